// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/cad_shape.h"
#include "kernel/mesh.h"

#include <vector>

namespace tapeline {

/// Triangles of all faces joined into one mesh.
struct WeldedFaces {
    Model model;               ///< `surface` is null; triangles in the order of the faces
    std::vector<int> unmeshed; ///< faces without triangles
    int unmatched_edges = 0;   ///< CAD edges that two faces subdivide differently: left open
    int non_finite_nodes = 0;
    int folded_triangles = 0; ///< back to front against the exact surface's normal at their middle
};

/// Joins the triangulations of `triangulate_faces` (io/tessellation.h) by topology, never by distance: nodes on one CAD edge by their place
/// in the edge's subdivision, nodes at one CAD vertex, both sides of a seam, all nodes of a degenerated edge. Nodes without triangles are left out. Triangles
/// are counter-clockwise seen from outside (turned for a reversed face, and for a mirrored placement).
WeldedFaces weld_faces(const CadFaces& faces);

} // namespace tapeline
