// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a move that puts the side under compression on the exact CAD faces that its triangles stand for.
#include "kernel/move_steps.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// A target that is farther off the surface than these shares is meant to be off it [of the largest displacement, of the
/// line's mean edge].
constexpr double off_of_slide = 1e-3, off_of_edge = 3e-3;

std::vector<int> without_strip(const std::optional<CarriedStrip>& strip, std::vector<int> vertices)
{
    std::erase_if(vertices, [&](int v) { return strip && strip->has(v); });
    return vertices;
}

} // namespace

bool MoveState::keeps_to_cad() const
{
    const Model& model = extended_.model;
    return options_.exact_surface && splits() && !method_.as_published && model.surface && !model.cad_face.empty();
}

const ExactSide& MoveState::exact_side(SideState& state) const
{
    if (!state.exact) {
        state.exact.emplace(extended_.model, state.side, retracts_on_rails());
    }
    return *state.exact;
}

void MoveState::lay_slid_on_cad(SideState& state, Positions& slid)
{
    if (!keeps_to_cad()) {
        return;
    }
    SideMesh& side = state.side;
    const ExactSide& exact = exact_side(state);
    const std::vector<int> moved = without_strip(state.strip, exact.moved_vertices(slid));
    std::vector<int> all = moved;
    // The line lies on the surface unless it stands on a strip.
    if (!state.strip) {
        std::ranges::copy_if(side.line, std::back_inserter(all),
                             [&](int v) { return slid.row(v) != side.mesh.V.row(v); });
    }
    const double before = exact.distance(moved, slid);
    exact.lay(all, 1, slid);
    for (size_t i = 0; i < side.guided.size(); ++i) {
        side.guided_targets[i] = slid.row(side.guided[i]);
    }
    if (&state == &sides_[compression()]) {
        result_.exact_surface.distance_before_mm = before;
    }
}

void MoveState::lay_solved_on_cad(SideState& state)
{
    if (!keeps_to_cad()) {
        return;
    }
    const ExactSide& exact = exact_side(state);
    const std::vector<int>& line = state.side.line;
    double gap = 0, length = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        gap = std::max(gap, (extended_.targets[i] - Vec3(state.rest.row(line[i]))).norm());
        length += (state.side.mesh.V.row(line[i]) - state.side.mesh.V.row(line[(i + 1) % line.size()])).norm();
    }
    // Between once and twice the limit the side leaves the surface gradually, so that the result does not jump.
    const double limit =
        std::max(off_of_slide * result_.placement.u_max_mm, off_of_edge * length / static_cast<double>(line.size()));
    const double x = std::clamp(gap / limit - 1, 0.0, 1.0), share = (1 - x) * (1 - x) * (1 + 2 * x);
    ExactSurfaceReport& report = result_.exact_surface;
    report.line_gap_mm = gap;
    const std::vector<int> moved = without_strip(state.strip, exact.moved_vertices(state.V));
    if (share > 0) {
        const ExactPlacement laid = exact.lay(moved, share, state.V);
        report.applied = share == 1;
        report.vertices = laid.placed;
        report.left = laid.left;
    }
    report.distance_after_mm = exact.distance(moved, state.V);
    std::vector<int> used(line.begin() + extended_.first, line.begin() + extended_.last + 1);
    report.line_distance_mm = exact.distance(used, state.V);
    if (share < 1 && result_.placement.verdict == Placement::on_surface && runs_into(tension()) == 0) {
        warn(fmt::format("the target lies {:.3g} mm off the exact surface: the compressed side follows it and leaves "
                         "the surface by up to {:.3g} mm (--on-surface lays the target on it)",
                         gap, report.distance_after_mm));
    }
}

} // namespace tapeline
