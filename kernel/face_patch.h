// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <array>
#include <span>
#include <vector>

namespace tapeline {

/// Two vertex indices, smaller first.
using VertexPair = std::array<int, 2>;

/// The pair in ascending order.
inline VertexPair vertex_pair(int a, int b) { return a < b ? VertexPair{a, b} : VertexPair{b, a}; }

/// A part of a mesh with its own vertex numbering, manifold by construction.
struct FacePatch {
    Mesh mesh;                  ///< local triangles in the order given, local vertices
    std::vector<int> to_vertex; ///< local vertex -> vertex of the whole mesh; several may share one
    std::vector<int> to_face;   ///< local triangle -> triangle of the whole mesh
};

/// Cuts the listed triangles out of `mesh`. Neighbours are joined only across edges that exactly two listed triangles
/// share with opposite sense and that are not in `walls` (ascending list); everywhere else the patch is open. So a
/// vertex at which several fans of triangles meet (bow-ties, ends of walls on the border, non-manifold edges) gets one
/// local copy per fan.
FacePatch patch_of_faces(const Mesh& mesh, std::span<const int> faces, const std::vector<VertexPair>& walls = {});

} // namespace tapeline
