// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/face_patch.h"

#include <span>
#include <vector>

namespace tapeline {

/// A point of a path over a mesh: the vertex a (then b = -1), or the point (1 - t) V[a] + t V[b] inside the edge a < b.
struct PathPoint {
    int a = -1;
    int b = -1;
    double t = 0;

    bool is_vertex() const { return b < 0; }
    Vec3 position(const Mesh& mesh) const
    {
        const Vec3 from = mesh.V.row(a);
        return is_vertex() ? from : Vec3((1 - t) * from + t * Vec3(mesh.V.row(b)));
    }
};

/// Length of a path given by its points [mm].
double path_length(const Mesh& mesh, const std::vector<PathPoint>& path);

/// Exact shortest path over the listed triangles from one vertex to another, both included (Xin & Wang 2009 in CGAL's
/// Surface_mesh_shortest_path). It does not cross the edges in `walls` (ascending), but may touch their ends: where it
/// bends around an obstacle it passes through the obstacle's vertex. Every two neighbours in the answer lie in one
/// triangle. Cost grows faster than linearly: 0.1 s at 1000 triangles, seconds at 20 000. Rejected when a vertex is not
/// in the triangles or they do not connect the two.
Result<std::vector<PathPoint>> geodesic_path(const Mesh& mesh, std::span<const int> faces, int from, int to,
                                             const std::vector<VertexPair>& walls = {});

} // namespace tapeline
