// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/error.h"
#include "kernel/exact_ground.h"
#include "kernel/extension.h"
#include "kernel/topology.h"

#include <optional>
#include <vector>

namespace tapeline {

/// How a taper arrives at the rim.
enum class TaperEnd {
    clamped, ///< with slope 0, as the line goes on beyond the rim
    natural  ///< with curvature 0, where the surface ends and nothing goes on: half the bending
};

/// Share h(s / length) of the end displacement that is left at arc length s beyond the line's end: the cubic from 1 with
/// the given slope dh/ds at 0 to 0 at `length` of least bending, the slope limited to [-3 / length, 0] so that it falls
/// monotonically and neither over- nor undershoots (Fritsch & Carlson 1980; method.md A4).
double taper(double s, double length, double slope, TaperEnd end = TaperEnd::clamped);

/// The tapered targets of the prolongation, for as many places of the line's ends as are asked for. `extended` must
/// outlive it; `rest` is the model before the cut, `faces` its region, on which targets are laid.
class ExtensionTargets {
public:
    ExtensionTargets(const ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                     const ExtensionOptions& options);

    /// Entries of `extended.vertices` from the line's first or last (`after`) one outwards; none without a prolongation.
    std::vector<int> entries(bool after) const;
    /// A target for each of them. Rejected as by `set_targets`.
    Result<std::vector<Vec3>> beyond(const Correspondence& correspondence, bool after) const;

private:
    const ExtendedLine& extended_;
    bool on_surface_;
    ClosestPoint surface_;
    std::optional<ExactGround> exact_;
    Topology topology_;
};

/// Gives `extended.targets` (one per vertex of the line): the used part's targets from the correspondence, beyond its
/// ends the tapered displacement or NaN by the options. Fixed rim vertices keep their place exactly. `rest` is the
/// model before the cut, `faces` its region, on which targets are laid. Rejected when the end displacement runs along
/// the extension farther than there is room before the rim.
Result<void> set_targets(ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                         const Correspondence& correspondence, const ExtensionOptions& options);
/// The same with the prolongation's tapered targets at hand.
Result<void> set_targets(ExtendedLine& extended, const ExtensionTargets& prolongation,
                         const Correspondence& correspondence);

} // namespace tapeline
