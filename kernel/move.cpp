// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/move.h"

#include "kernel/move_steps.h"

#include <algorithm>

namespace tapeline {

bool MoveResult::converged() const
{
    return uniqueness.converged &&
           std::ranges::all_of(solves, [](const SolveReport& solve) { return solve.converged; });
}

bool MoveResult::ambiguous() const { return uniqueness.checked && uniqueness.distance_mm > uniqueness.limit_mm; }

int MoveResult::iterations() const
{
    int sum = 0;
    for (const SolveReport& solve : solves) {
        sum += solve.iterations;
    }
    return sum;
}

double MoveResult::error_estimate_mm() const
{
    double largest = 0;
    for (const SolveReport& solve : solves) {
        largest = std::max(largest, solve.error_estimate_mm);
    }
    return largest;
}

namespace {

/// The whole region deforms in one piece: targets that rise straight from the surface, and the plain methods.
Result<void> move_uncut(MoveState& state, const Progress& progress)
{
    state.keep_whole();
    return state.solve_whole(progress);
}

/// The paper's steps 2 to 7: cut the region along the extended line, deform the side under tension, make room on the
/// side under compression, deform it, sew both together, mend the crease.
Result<void> move_split(MoveState& state, const Progress& progress)
{
    const bool compressed_first = state.keeps_crease(), late = state.tension_decides_ends();
    const auto retract = [&](bool due) { return due ? state.retract_side(state.compression()) : Result<void>(); };
    const auto tension = [&](const Progress& part) { return state.deform_side(state.tension(), part); };
    const auto compression = [&](const Progress& part) {
        return retract(late).and_then([&] { return state.deform_side(state.compression(), part); });
    };
    return state.extend()
        .and_then([&] { return state.split(); })
        .and_then([&] { return state.retract_tension(); })
        .and_then([&] { return retract(!late); })
        .and_then(
            [&] { return compressed_first ? compression(progress.part(0.1, 0.4)) : tension(progress.part(0.1, 0.5)); })
        .and_then(
            [&] { return compressed_first ? tension(progress.part(0.4, 0.9)) : compression(progress.part(0.5, 0.9)); })
        .and_then([&] { return state.sew_sides(); })
        .and_then([&] { return state.restore_lost_crease(progress.part(0.9, 1.0)); });
}

} // namespace

Result<MoveResult> move_feature_line(const Model& model, const FeatureLine& line, const TargetCurve& target,
                                     const Region& region, const MoveOptions& options, const Progress& progress)
{
    MoveState state(model, region, options);
    const auto placed = state.correspond_to(line, target).and_then([&] { return state.place(); }).and_then([&] {
        return state.carry_line(target);
    });
    if (!placed) {
        return tl::unexpected(placed.error());
    }
    const double share = state.deforms_whole() ? (state.splits() ? 0.3 : 1) : 0;
    Result<void> moved;
    if (state.deforms_whole()) {
        moved = move_uncut(state, progress.part(0, share));
    }
    if (moved && state.splits()) {
        moved = move_split(state, progress.part(share, 1));
    }
    if (!moved) {
        return tl::unexpected(moved.error());
    }
    state.sew_all();
    return state.smooth_rim(progress).map([&] { return state.finish(); });
}

} // namespace tapeline
