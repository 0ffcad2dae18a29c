// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a move that makes room: junctions taken along, the side under compression retracted.
#include "kernel/feature_rails.h"
#include "kernel/junctions.h"
#include "kernel/move_steps.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

std::string place_of(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", p.x(), p.y(), p.z()); }

/// From this share of its displacement on, a junction is said to miss the target.
constexpr double off_target_share = 1e-3;

bool is_free(const Vec3& target) { return !target.allFinite(); }

} // namespace

Result<void> MoveState::carry_line(const TargetCurve& target)
{
    Correspondence& c = result_.correspondence;
    if (!splits() || !retracts_on_rails()) {
        return {};
    }
    std::vector<int> whole(c.before.rbegin(), c.before.rend());
    whole.insert(whole.end(), c.line.vertices.begin(), c.line.vertices.end());
    whole.insert(whole.end(), c.after.begin(), c.after.end());
    return carry_junctions(model_.mesh, other_feature_edges(model_, whole, c.line.closed), target, c).map([&] {
        warn_of_carried_junctions(target);
    });
}

void MoveState::warn_of_carried_junctions(const TargetCurve& target)
{
    const Correspondence& c = result_.correspondence;
    double farthest = 0;
    size_t at = 0;
    for (size_t i = 0; i < c.targets.size(); ++i) {
        const double off = target.foot(c.targets[i]).distance;
        if (off > farthest) {
            farthest = off;
            at = i;
        }
    }
    if (farthest > off_target_share * c.displacements[at].norm()) {
        result_.warnings.push_back(fmt::format("the line meets another feature line at {} and follows it, {:.3g} mm "
                                               "off the target: let the target cross that feature line",
                                               place_of(model_.mesh.V.row(c.line.vertices[at])), farthest));
    }
}

void MoveState::warn_of_lines()
{
    const SideMesh& narrowed = sides_[compression()].side;
    if (!narrowed.features.empty() && retracts_on_rails()) {
        const Vec3 p = narrowed.mesh.V.row(narrowed.features.front()[0]);
        result_.warnings.push_back(
            fmt::format("other feature lines lie on the side that the slide narrows, as at {}: they stay, the surface "
                        "slides along them; a region that ends before them (--roi-distance) leaves them out",
                        place_of(p)));
    }
}

double MoveState::runs_into(int side) const
{
    double farthest = 0;
    const FeatureLine& line = result_.correspondence.line;
    const Topology topology(model_.mesh.F, static_cast<int>(model_.mesh.V.rows()));
    const size_t edges = line.vertices.size() - (line.closed ? 0 : 1);
    for (size_t i = 0; i < edges; ++i) {
        const size_t j = (i + 1) % line.vertices.size();
        const int a = line.vertices[side == 0 ? i : j], b = line.vertices[side == 0 ? j : i];
        const int t = topology.face_left_of(a, b);
        if (t < 0) {
            continue;
        }
        const Vec3 direction = (Vec3(model_.mesh.V.row(b)) - Vec3(model_.mesh.V.row(a))).normalized();
        const Vec3 conormal = triangle_normal(model_.mesh, t).cross(direction);
        const Vec3 u = 0.5 * (result_.correspondence.displacements[i] + result_.correspondence.displacements[j]);
        farthest = std::max(farthest, u.dot(conormal));
    }
    return result_.placement.u_max_mm > 0 ? farthest / result_.placement.u_max_mm : 0;
}

Result<void> MoveState::retract_side(int side)
{
    return timed("retraction", [&]() -> Result<void> {
        SideState& state = sides_[side];
        std::vector<Vec3> displacements;
        for (size_t i = 0; i < state.side.line.size(); ++i) {
            const Vec3 u = extended_.targets[i] - Vec3(state.side.mesh.V.row(state.side.line[i]));
            displacements.push_back(is_free(u) ? Vec3(Vec3::Zero()) : u);
        }
        RetractionOptions options;
        options.mode = result_.retraction.mode;
        options.active_radius_mm = options_.active_radius_mm;
        options.material = material_for(result_.correspondence.displacements);
        // The side under tension joins in gradually, as far as a zigzag target compresses it (method.md A5).
        constexpr double whole = 0.2;
        options.share = side == compression() ? 1 : smooth_step(runs_into(side), 0, whole);
        lay_strip(side, true);
        options.strip = state.strip ? &*state.strip : nullptr;
        auto slid = retract(state.side, displacements, options);
        if (!slid) {
            return tl::unexpected(slid.error());
        }
        RetractionReport& report = result_.retraction;
        report.applied = true;
        report.min_area_ratio = std::min(report.min_area_ratio, slid->min_area_ratio);
        report.flipped += slid->flipped;
        report.crossings += slid->crossings;
        constexpr double nothing_left = 1e-7;
        if (slid->min_area_ratio < nothing_left) {
            return fail(ErrorKind::rejected,
                        fmt::format("the slide leaves no room for the triangles near {} on the side that it narrows "
                                    "(the region's rim, a hole or another feature line is in the way): shorten the "
                                    "slide or widen the region (--roi-distance)",
                                    place_of(slid->worst_at)));
        }
        warn_of_folds(*slid);
        lay_slid_on_cad(state, slid->V);
        state.rest = state.V = std::move(slid->V);
        return {};
    });
}

Result<void> MoveState::retract_tension()
{
    // A zigzag target compresses the tension side in places; it is retracted there (method.md A5).
    if (!method_.as_published && runs_into(tension()) > 0) {
        return retract_side(tension());
    }
    lay_strip(tension(), false);
    return {};
}

void MoveState::warn_of_folds(const RetractionResult& retraction)
{
    if (retraction.flipped > 0) {
        result_.warnings.push_back(
            fmt::format("the retraction folded {} triangles over, near {}: the slide is too long "
                        "for the region, widen it (--roi-distance) or shorten the slide",
                        retraction.flipped, place_of(retraction.worst_at)));
    }
}

} // namespace tapeline
