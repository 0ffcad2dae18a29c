// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/correspondence.h"
#include "kernel/region.h"
#include "kernel/topology.h"

#include <functional>
#include <vector>

namespace tapeline::testing {

/// The region of the given triangles with its border as rim, made without the library's own region code.
Region hand_made_region(const Mesh& mesh, const std::vector<int>& faces);

/// All triangles of the mesh as the region.
Region whole_mesh_region(const Mesh& mesh);

/// Triangles whose three corners satisfy the predicate.
std::vector<int> faces_where(const Mesh& mesh, const std::function<bool(const Vec3&)>& inside);

/// A correspondence that moves each line vertex p by displacement(p).
Correspondence hand_made_move(const Mesh& mesh, const std::vector<int>& line,
                              const std::function<Vec3(const Vec3&)>& displacement);

/// V - E + F, and the number of border edges; fails on non-manifold edges.
struct SurfaceCount {
    int euler = 0;
    int border_edges = 0;
    int bad_edges = 0; ///< more than two triangles, or two of the same sense
};
SurfaceCount count_surface(const Mesh& mesh);

double total_area(const Mesh& mesh);

} // namespace tapeline::testing
