// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/move_steps.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

/// A line whose angle is held makes the sections' curvature beside it answer its own curving, the more so the stiffer the
/// sections are; a free end is corrected for that (kernel/plate_system.cpp).
double plate_stiffness(const MoveOptions& options)
{
    constexpr double free_end = 3, held_end = 1;
    if (options.plate_stiffness_ratio > 0) {
        return options.plate_stiffness_ratio;
    }
    return options.line_crease == LineCrease::keep ? held_end : free_end;
}

bool MoveState::keeps_crease() const
{
    return plate_share_ == 1 && (options_.line_crease == LineCrease::keep || options_.crease == CreaseRestoration::on);
}

double MoveState::plate_share() const
{
    if (method_.deformer == Deformer::plate) {
        return 1;
    }
    // Stiff fibres carry the pull of a side's stretched parts into its compressed ones, which lie at their place after
    // the retraction; a plate does not. The paper leaves such targets open (Section 7).
    constexpr double none = 0.1, clear = 0.8;
    const bool can = options_.method == Method::asan_fl && splits();
    return can ? smooth_step(std::min(runs_into(0), runs_into(1)), none, clear) : 0;
}

Result<void> MoveState::check_plate_options() const
{
    const bool plate = method_.deformer == Deformer::plate;
    if (!plate && options_.line_crease == LineCrease::keep) {
        return fail(ErrorKind::usage,
                    fmt::format("--crease keep belongs to plate-fl; {} has --restore-crease on", method_.name));
    }
    if (keeps_crease() && result_.extension_target == ExtensionTarget::free) {
        return fail(ErrorKind::usage, "--crease keep needs the line's prolongation to have a target: leave "
                                      "--extension-target free");
    }
    return {};
}

std::vector<int> MoveState::tilting_vertices(const SideMesh& side) const
{
    // Uncut, a plate that is smooth across the line keeps the crease by itself (method.md A9).
    std::vector<int> tilting = cut_ || !keeps_crease() ? side.line : std::vector<int>{};
    const std::vector<int> rim =
        tilting_rim(extended_.model, extended_.region, own_rim_control(), options_.rim_crease_angle);
    for (const std::vector<int>* list : {&side.fixed, &side.guided}) {
        for (const int v : *list) {
            if (std::ranges::binary_search(rim, side.to_global[v])) {
                tilting.push_back(v);
            }
        }
    }
    return tilting;
}

Result<DeformationResult> MoveState::bend_part(const SideState& side, const Constraints& constraints,
                                               const DeformationOptions& options, const std::optional<Positions>& start,
                                               const Progress& progress) const
{
    PlateSupport support{.constrained = constraints.vertices, .targets = constraints.targets};
    if (side.strip && !side.strip->settled) {
        support.carried = side.strip->vertices;
        support.places = side.strip->places;
    }
    support.free_slope = tilting_vertices(side.side);
    if (!keeps_crease()) {
        support.line = side.side.line;
        support.closed = extended_.closed;
    }
    const bool holds = cut_ && keeps_crease() && &side == &sides_[tension()];
    const PlateOptions plate = plate_options(options, holds);
    if (cut_) {
        if (auto held = hold_ring(&side == &sides_[0] ? 0 : 1, support, plate); !held) {
            return tl::unexpected(held.error());
        }
    }
    return bend_plate(Mesh{side.rest, side.side.mesh.F}, support, plate, start, progress);
}

PlateOptions MoveState::plate_options(const DeformationOptions& options, bool held) const
{
    PlateOptions plate;
    plate.material = options.material;
    plate.material.stiff = Stiff::along;
    plate.material.stiffness_ratio = std::min(options.material.stiffness_ratio, plate_stiffness(options_));
    if (held && options_.plate_stiffness_ratio <= 0) {
        // The stiffer the sections, the farther into the side they answer the line's curving, and where that changes
        // sides they get a second inflection; soft ones take their turn near the line.
        constexpr double held_section = 2;
        plate.material.stiff = Stiff::across;
        plate.material.stiffness_ratio = std::min(options.material.stiffness_ratio, held_section);
    }
    plate.tolerance_mm = options.tolerance_mm;
    plate.max_passes = options.max_iterations;
    return plate;
}

} // namespace tapeline
