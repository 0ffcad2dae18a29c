// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/region.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// Vertices of an open border and where they slide.
struct BorderSlide {
    std::vector<int> vertices;
    std::vector<Vec3> targets; ///< [mm]
};

/// Where a line ends on an open border of the model and its end slides along that border, the border's vertices must
/// make room as the surface does. They slide along the border's own polyline: the arc length from the end is stretched
/// linearly on one side and squeezed on the other, up to the place where the border leaves the region or turns a corner
/// by more than 45°. What the target lies off the border fades out along the same length. The end itself is not listed.
/// Empty when the target is the end's own place. Rejected when the target lies beyond that length.
Result<BorderSlide> slide_border(const Mesh& mesh, const Topology& topology, const Region& region, int end,
                                 const Vec3& target);

} // namespace tapeline
