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

} // namespace tapeline
