// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <vector>

namespace tapeline::testing {

/// Positions after `iterations` local/global iterations of CGAL's own spokes-and-rims deformer (Surface_mesh_deformation,
/// SPOKES_AND_RIMS, no early stop) from the rest shape: an implementation that shares no code with ours. `targets` has
/// one row per constrained vertex.
Positions cgal_spokes_and_rims(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                               int iterations);

/// The same with CGAL's smooth rotations (SRE_ARAP); with smoothness 0 its spokes only (ORIGINAL_ARAP).
Positions cgal_smooth_rotations(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                int iterations, double smoothness);

} // namespace tapeline::testing
