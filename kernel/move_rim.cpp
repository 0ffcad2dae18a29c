// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a move that brings about the tangent plane at the rim where the method's own energy does not.
#include "kernel/move_steps.h"
#include "kernel/rim_band.h"

#include <algorithm>

namespace tapeline {

namespace {

/// Sides that are left to move by less than this share of the displacements lie on the old surface: their rim is in
/// order.
constexpr double little_left = 0.1;

} // namespace

RimControl MoveState::own_rim_control() const
{
    return options_.rim_width_mm > 0 ? RimControl::position : options_.rim;
}

bool MoveState::makes_transition() const
{
    if (options_.rim == RimControl::position) {
        return false;
    }
    if (method_.deformer == Deformer::plate) {
        return options_.rim_width_mm > 0; // without a width the plate makes it over its whole side
    }
    return options_.rim == RimControl::tangent || (method_.splits && !method_.as_published);
}

double MoveState::transition_share(int side) const
{
    if (!cut_ || side == tension()) {
        return 1;
    }
    const double whole = result_.placement.whole_share;
    double left = 0, all = 0;
    for (int i = extended_.first; i <= extended_.last; ++i) {
        const int v = sides_[side].side.line[i];
        left += (extended_.targets[i] - Vec3(sides_[side].rest.row(v))).norm();
        all += (extended_.targets[i] - Vec3(sides_[side].side.mesh.V.row(v))).norm();
    }
    return std::max(whole, all > 0 ? smooth_step(left / all, 0, little_left) : 0);
}

Result<void> MoveState::smooth_rim(const Progress& progress)
{
    if (!makes_transition()) {
        return {};
    }
    return timed("rim", [&]() -> Result<void> {
        const SideMesh part = whole_region(extended_, 1);
        const std::vector<int> tilting =
            tilting_rim(extended_.model, extended_.region, options_.rim, options_.rim_crease_angle);
        const std::vector<int> line(part.line.begin() + extended_.first, part.line.begin() + extended_.last + 1);
        const std::vector<int> band = rim_band(part, line, extended_.region.fixed_rim, tilting, options_.rim_width_mm);
        if (band.empty()) {
            return {};
        }
        Positions moved(part.mesh.V.rows(), 3);
        for (int v = 0; v < moved.rows(); ++v) {
            moved.row(v) = result_.V.row(part.to_global[v]);
        }
        PlateSupport support = outside_band(part, band, moved);
        for (const int v : part.fixed) {
            if (std::ranges::binary_search(tilting, part.to_global[v])) {
                support.free_slope.push_back(v);
            }
        }
        PlateOptions plate = plate_options(solver_options(material_for(result_.correspondence.displacements)));
        auto bent = bend_plate(Mesh{part.mesh.V, part.mesh.F}, support, plate, {}, progress);
        if (!bent) {
            return tl::unexpected(bent.error());
        }
        result_.solves.push_back({"rim", bent->iterations, bent->error_estimate_mm, plate.tolerance_mm, bent->converged,
                                  bent->energy, bent->seconds});
        take_band(part, band, bent->V);
        return {};
    });
}

void MoveState::take_band(const SideMesh& part, const std::vector<int>& band, const Positions& V)
{
    std::vector<double> share(extended_.model.mesh.V.rows(), 1);
    for (int side = 0; side < 2 && cut_; ++side) {
        const double own = transition_share(side);
        for (const int v : sides_[side].side.to_global) {
            share[v] = std::min(share[v], own);
        }
    }
    for (const int v : band) {
        const int global = part.to_global[v];
        result_.V.row(global) += share[global] * (V.row(v) - result_.V.row(global));
    }
}

} // namespace tapeline
