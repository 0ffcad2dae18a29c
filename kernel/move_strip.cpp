// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a move that takes narrow bends beside the line along with it.
#include "kernel/move_steps.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// A strip is carried where the region goes on beyond it for as far again; true where it ends before on most of the line.
bool ends_before(const Model& model, const Region& region, int side_of_line, const Mesh& side, const FeatureLine& line,
                 const Strip& strip)
{
    const std::vector<double> distances = strip.carried(line.vertices.size(), 2);
    const Mesh inside{model.mesh.V, model.mesh.F(region.faces, Eigen::all)};
    const auto [left, right] = meshes_beside(inside, line.vertices, line.closed);
    const Mesh& region_side = side_of_line == 0 ? left : right;
    const std::vector<Vec3> within = points_across(region_side, line.vertices, line.closed, distances);
    const std::vector<Vec3> whole = points_across(side, line.vertices, line.closed, distances);
    size_t cut = 0;
    for (size_t i = 0; i < whole.size(); ++i) {
        cut += (within[i] - whole[i]).norm() > 1e-6 * distances[i];
    }
    return 2 * cut > whole.size();
}

/// Per entry of the side's line what is carried beside it; along the prolongation as much as at the line's end.
std::vector<double> carried_widths(const Strip& strip, const Model& model, const std::vector<int>& line,
                                   const SideMesh& side)
{
    const std::vector<double> known = strip.carried(line.size());
    std::vector<double> widths;
    for (const int v : side.line) {
        const auto apart = [&](int u) { return (model.mesh.V.row(u) - side.mesh.V.row(v)).squaredNorm(); };
        widths.push_back(known[std::ranges::min_element(line, {}, apart) - line.begin()]);
    }
    return widths;
}

} // namespace

void MoveState::find_strips()
{
    const bool asked = !options_.strip_width_mm || *options_.strip_width_mm > 0;
    if (!asked || !splits() || method_.as_published || !retracts_on_rails() ||
        result_.extension_target != ExtensionTarget::tapered) {
        return;
    }
    const FeatureLine& line = result_.correspondence.line;
    const auto [left, right] = meshes_beside(model_.mesh, line.vertices, line.closed);
    for (const int side : {0, 1}) {
        Strip& strip = result_.strips[side].bend;
        const Mesh& beside = side == 0 ? left : right;
        strip = find_strip(beside, line.vertices, line.closed);
        if (options_.strip_width_mm) {
            strip.carried_mm = *options_.strip_width_mm;
            strip.widths.clear();
        }
        if (strip.found() && ends_before(model_, result_.region, side, beside, line, strip)) {
            result_.warnings.push_back(fmt::format(
                "a bend beside the line is not carried along: it takes {:.4g} mm and the region ends within "
                "twice that on this side; widen it (--roi-distance), or say --strip none",
                strip.carried_mm));
            strip = {};
        }
    }
}

void MoveState::lay_strip(int side, bool rests)
{
    StripReport& report = result_.strips[side];
    if (!report.bend.found()) {
        return;
    }
    SideState& state = sides_[side];
    const ExactGround* exact = keeps_to_cad() ? &exact_side(state).ground() : nullptr;
    const ClosestPoint triangles(state.side.own_mesh());
    const auto ground = [&](const Vec3& p) {
        const auto place = exact ? exact->closest(p) : std::optional<Vec3>();
        return place ? *place : triangles.closest(p).point;
    };
    const std::vector<int>& line = result_.correspondence.line.vertices;
    const std::vector<double> widths = carried_widths(report.bend, model_, line, state.side);
    state.strip = carry_strip(state.side, {widths, extended_.closed, rests}, extended_.targets, ground);
    if (state.strip->vertices.empty()) { // narrower than the triangles
        state.strip.reset();
        report.bend.carried_mm = 0;
        return;
    }
    report.vertices.clear();
    for (const int v : state.strip->vertices) {
        report.vertices.push_back(state.side.to_global[v]);
    }
    report.pivot_max = report.lift_max_mm = 0;
    for (size_t i = 0; i < state.strip->lifts.size() && rests; ++i) {
        report.pivot_max = std::max(report.pivot_max, std::abs(state.strip->pivots[i]));
        report.lift_max_mm = std::max(report.lift_max_mm, state.strip->lifts[i].norm());
    }
}

Result<void> MoveState::settle_strip(SideState& side, const std::vector<Vec3>& targets,
                                     const DeformationOptions& options)
{
    // How far the strip turns about the line is the side's business: a plate tells, the method's own solver then holds it.
    const Constraints held = constraints(side, targets);
    return bend_part(side, held, options, {}, {}).map([&](const DeformationResult& bent) {
        for (size_t k = 0; k < side.strip->vertices.size(); ++k) {
            side.strip->places.row(static_cast<Eigen::Index>(k)) = bent.V.row(side.strip->vertices[k]);
        }
        side.strip->settled = true;
    });
}

} // namespace tapeline
