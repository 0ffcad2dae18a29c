// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/face_patch.h"

#include <vector>

namespace tapeline {

struct IsotropicInput {
    Mesh mesh;                          ///< manifold, with border; no zero-area triangle
    std::vector<int> part;              ///< per triangle: its part; triangles never leave the surface of their part
    std::vector<VertexPair> kept_edges; ///< left as they are, ascending; border edges are kept in any case
    std::vector<int> kept_vertices;     ///< further vertices left where they are
    double edge_length = 0;             ///< wanted [mm]; kept and border edges must not exceed 4/3 of it
    int iterations = 5;
};

struct IsotropicResult {
    Mesh mesh;
    std::vector<int> part;       ///< per triangle
    std::vector<int> old_vertex; ///< per vertex the input vertex with the same number and position; -1 = new or moved
};

/// Isotropic remeshing (Botsch & Kobbelt 2004, CGAL Polygon_mesh_processing): splits, collapses, flips and tangential
/// relaxation towards equilateral triangles, every vertex projected back on the input triangles. Deterministic.
Result<IsotropicResult> remesh_isotropic(const IsotropicInput& input);

} // namespace tapeline
