// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/linear_frames.h"
#include "kernel/baselines/rings.h"
#include "kernel/baselines/smooth_rotations.h"
#include "kernel/baselines/spokes.h"
#include "kernel/move_steps.h"

#include <algorithm>

namespace tapeline {

namespace {

/// Where a second start may end before the answer counts as ambiguous: 0.1 mm, or a ten-thousandth of a region that is
/// smaller than a metre.
double ambiguity_limit(double region_size_mm) { return std::min(0.1, 1e-4 * region_size_mm); }

} // namespace

double MoveState::region_size() const
{
    Positions corners(static_cast<Eigen::Index>(extended_.region.vertices.size()), 3);
    for (size_t i = 0; i < extended_.region.vertices.size(); ++i) {
        corners.row(static_cast<Eigen::Index>(i)) = extended_.model.mesh.V.row(extended_.region.vertices[i]);
    }
    return rotation_free_size(corners);
}

DeformationOptions MoveState::solver_options(const Material& material) const
{
    DeformationOptions options;
    options.material = material;
    options.max_iterations = options_.max_iterations;
    options.tolerance_mm = options_.tolerance_mm > 0 ? options_.tolerance_mm : 1e-5 * region_size();
    return options;
}

MoveState::Constraints MoveState::constraints(const SideState& side, const std::vector<Vec3>& line_targets) const
{
    Constraints constraints;
    std::vector<Vec3> goals;
    const auto hold = [&](int v, const Vec3& goal) {
        constraints.vertices.push_back(v);
        goals.push_back(goal);
    };
    for (const int v : side.side.fixed) {
        hold(v, side.side.mesh.V.row(v));
    }
    for (size_t i = 0; i < side.side.guided.size(); ++i) {
        hold(side.side.guided[i], side.side.guided_targets[i]);
    }
    for (size_t k = 0; side.strip && side.strip->settled && k < side.strip->vertices.size(); ++k) {
        hold(side.strip->vertices[k], side.strip->places.row(static_cast<Eigen::Index>(k)));
    }
    for (size_t i = 0; i < side.side.line.size(); ++i) {
        // An extension without a target is free.
        if (line_targets[i].allFinite()) {
            hold(side.side.line[i], line_targets[i]);
        }
    }
    constraints.targets.resize(static_cast<Eigen::Index>(goals.size()), 3);
    for (size_t i = 0; i < goals.size(); ++i) {
        constraints.targets.row(static_cast<Eigen::Index>(i)) = goals[i];
    }
    return constraints;
}

std::vector<Eigen::Matrix3d> MoveState::frame_turns(const Mesh& rest, const SideState& side,
                                                    const std::vector<Vec3>& line_targets) const
{
    std::vector<Eigen::Matrix3d> turns(side.side.fixed.size() + side.side.guided.size(), Eigen::Matrix3d::Identity());
    std::vector<int> line;
    std::vector<Vec3> targets;
    for (size_t i = 0; i < side.side.line.size(); ++i) {
        if (line_targets[i].allFinite()) {
            line.push_back(side.side.line[i]);
            targets.push_back(line_targets[i]);
        }
    }
    const bool on_surface = result_.placement.verdict == Placement::on_surface;
    for (const Eigen::Matrix3d& turn : darboux_turns(rest, line, extended_.closed, targets, on_surface)) {
        turns.push_back(turn);
    }
    return turns;
}

Result<DeformationResult> MoveState::deform_by(Deformer deformer, const SideState& side,
                                               const std::vector<Vec3>& line_targets, const DeformationOptions& options,
                                               const std::optional<Positions>& start, const Progress& progress) const
{
    const Mesh rest{side.rest, side.side.mesh.F};
    const auto [vertices, targets] = constraints(side, line_targets);
    switch (deformer) {
    case Deformer::spokes:
        return deform_spokes(rest, vertices, targets, options, start, progress);
    case Deformer::rings: {
        const RingOptions rings{options, options_.rings, options_.ring_weights};
        return deform_rings(rest, vertices, targets, rings, start, progress);
    }
    case Deformer::smooth_rotations: {
        const SmoothRotationOptions smooth{options, options_.smoothness};
        return deform_smooth_rotations(rest, vertices, targets, smooth, start, progress);
    }
    case Deformer::linear_frames:
        return deform_linear_frames(rest, vertices, targets, frame_turns(rest, side, line_targets), progress);
    case Deformer::plate:
        return bend_part(side, {vertices, targets}, options, start, progress);
    case Deformer::orthotropic:
    case Deformer::spokes_and_rims:
        break;
    }
    return deform(rest, vertices, targets, options, start, progress);
}

Result<void> MoveState::solve(SideState& side, const std::vector<Vec3>& targets, const Material& material,
                              const std::string& name, const Progress& progress)
{
    const DeformationOptions options = solver_options(material);
    // A side by side of plates is for what runs into sides; in one piece each method has its own solver.
    const double share = &side == &whole_ ? 0 : plate_share_;
    const bool plate = share > 0 && method_.deformer != Deformer::plate, own = !plate || share < 1;
    if (side.strip && method_.deformer != Deformer::plate) {
        if (auto settled = settle_strip(side, targets, options); !settled) {
            return settled;
        }
    }
    Positions V;
    if (own) {
        auto solved =
            solve_by(method_.deformer, side, targets, options, name, plate ? progress.part(0, 0.8) : progress);
        if (!solved) {
            return tl::unexpected(solved.error());
        }
        V = std::move(*solved);
    }
    if (plate) {
        auto solved = solve_by(Deformer::plate, side, targets, options, name, own ? progress.part(0.8, 1) : progress);
        if (!solved) {
            return tl::unexpected(solved.error());
        }
        V = own ? Positions(V + share * (*solved - V)) : std::move(*solved);
    }
    side.V = std::move(V);
    return {};
}

Result<Positions> MoveState::solve_by(Deformer deformer, const SideState& side, const std::vector<Vec3>& targets,
                                      const DeformationOptions& options, const std::string& name,
                                      const Progress& progress)
{
    const bool twice = options_.check_unique && !method_.direct;
    auto solved = deform_by(deformer, side, targets, options, {}, twice ? progress.part(0, 0.5) : progress);
    if (!solved) {
        return tl::unexpected(solved.error());
    }
    result_.solves.push_back({name, solved->iterations, solved->error_estimate_mm, options.tolerance_mm,
                              solved->converged, solved->energy, solved->seconds});
    UniquenessReport& uniqueness = result_.uniqueness;
    uniqueness.checked = options_.check_unique;
    uniqueness.limit_mm = ambiguity_limit(region_size());
    if (twice) {
        // The second start: the rest shape, with only the constrained vertices moved.
        const auto other = deform_by(deformer, side, targets, options, side.rest, progress.part(0.5, 1));
        if (!other) {
            return tl::unexpected(other.error());
        }
        const double distance = (other->V - solved->V).rowwise().norm().maxCoeff();
        uniqueness.distance_mm = std::max(uniqueness.distance_mm, distance);
        uniqueness.converged = uniqueness.converged && other->converged;
        uniqueness.energies.push_back({name, solved->energy, other->energy});
        uniqueness.iterations += other->iterations;
        uniqueness.seconds += other->seconds;
    }
    return std::move(solved->V);
}

} // namespace tapeline
