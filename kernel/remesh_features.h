// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/face_patch.h"
#include "kernel/remesh.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// Edges of the region that remeshing keeps, ascending: its border, the chains of options.keep_lines, edges at least
/// crease_angle sharp (on meshes without CAD faces only where that stands out from the bending beside it: facets of round
/// parts are no features), every CAD edge of which one mesh edge is that sharp, and from open ends of those the straight
/// continuation along edges at least half as sharp. With exact surfaces at hand, an edge inside a CAD face counts only
/// where the exact normals break, too: facets of a coarse tessellation are no features.
std::vector<VertexPair> kept_edges(const Model& model, const Topology& topology, const std::vector<char>& in_region,
                                   const RemeshOptions& options);

/// Single points of the region, such as the tip of a cone, that relaxation would blunt: angle defect of 45° or more,
/// all neighbours below a quarter of that. Ascending; vertices of kept edges are left out.
std::vector<int> kept_tips(const Mesh& mesh, const Topology& topology, const std::vector<char>& in_region,
                           const std::vector<VertexPair>& kept);

} // namespace tapeline
