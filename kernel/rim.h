// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"
#include "kernel/region.h"

#include <vector>

namespace tapeline {

/// What is kept where the region ends.
enum class RimControl {
    automatic, ///< per rim edge: `position` on open borders and existing creases, `tangent` elsewhere
    position,  ///< the place only: the surface may kink at the rim
    tangent    ///< the tangent plane too
};

/// Vertices of the region's fixed rim at which the surface may tilt (position control), ascending. By default a rim
/// edge lets the surface tilt where it is an open border of the model, or a crease of at least `crease_angle` [deg] by
/// the rules of kernel/crease_edges.h; a vertex holds its tangent plane when all its rim edges do.
std::vector<int> tilting_rim(const Model& model, const Region& region, RimControl control, double crease_angle);

/// How a move changed the angle of the surface across rim edges [deg]: its size in the mean (by length) and where it is
/// largest, and the mean size of the angle that was there. All zero where there are no such edges.
struct RimChange {
    double mean = 0, max = 0, at_rest = 0;
};

/// That of the rim inside smooth surfaces, where a change is a new crease, and along creases that were there. Open borders
/// have no angle.
struct RimChanges {
    RimChange smooth, creased;
};

/// `moved` are the positions of the model's vertices after the move; creases as for `tilting_rim`.
RimChanges rim_changes(const Model& rest, const Positions& moved, const Region& region, double crease_angle);

} // namespace tapeline
