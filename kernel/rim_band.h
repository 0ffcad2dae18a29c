// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/plate_system.h"
#include "kernel/split.h"

#include <vector>

namespace tapeline {

/// The free vertices of a part over which the tangent plane at its rim is brought about, local indices, ascending:
/// those nearer than `width_mm` to the rim vertices that hold their tangent plane (`rim` without `tilting`, both
/// vertices of the model, ascending), and at most half as far from them as from `line` (local) and from other vertices
/// that are held inside the region, so that the line keeps its surroundings. Width 0 = as far as that allows, a third of the
/// way to the line. Distances along the surface at rest [mm].
std::vector<int> rim_band(const SideMesh& part, const std::vector<int>& line, const std::vector<int>& rim,
                          const std::vector<int>& tilting, double width_mm);

/// What holds a plate in a band: all other vertices, at their places in `moved`. It meets the triangles beyond the band
/// with their tangent planes; along the line's prolongation it may kink.
PlateSupport outside_band(const SideMesh& part, const std::vector<int>& band, const Positions& moved);

} // namespace tapeline
