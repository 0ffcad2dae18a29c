// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace tapeline {

class SurfaceProjector;

using Vec3 = Eigen::Vector3d;
/// n×3, row i = vertex i [mm].
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// m×3, row t = the vertex indices of triangle t, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A triangle mesh as flat arrays. Vertex and triangle indices are stable: no function reorders them.
struct Mesh {
    Positions V; ///< n×3 vertex positions [mm]
    Triangles F; ///< m×3 vertex indices
};

/// A mesh edge that lies on an edge of the CAD model; a < b.
struct CadEdgeTag {
    int a = -1;
    int b = -1;
    int cad_edge = -1; ///< number of the CAD edge, from 0, in the order of the CAD file
    auto operator<=>(const CadEdgeTag&) const = default; // NOLINT(modernize-use-nullptr): a 0 of the compiler's own
};

/// What Tapeline works on: one conforming, consistently oriented, edge-manifold mesh, with where it came from.
/// A move never edits a Model: it returns new positions for the same vertices.
struct Model {
    Mesh mesh;
    std::vector<int> cad_face;         ///< per triangle the CAD face, -1 = none; empty when the input was a mesh
    std::vector<CadEdgeTag> cad_edges; ///< sorted; empty when the input was a mesh
    std::shared_ptr<const SurfaceProjector> surface; ///< exact CAD faces; null when the input was a mesh
};

/// Unit normal of triangle t; the zero vector when the triangle has no area.
Vec3 triangle_normal(const Mesh& mesh, int t);

/// Area of triangle t [mm²].
double triangle_area(const Mesh& mesh, int t);

/// Smallest interior angle of triangle t [deg]; 0 when degenerate.
double triangle_min_angle(const Mesh& mesh, int t);

/// Length of the bounding box's diagonal over all vertices [mm]; 0 for an empty mesh.
double bounding_diagonal(const Positions& V);

/// Twice the largest distance of a vertex from the vertices' mean [mm]: a size that a rotation does not change.
double rotation_free_size(const Positions& V);

/// Area-weighted unit vertex normals, n×3; zero rows for isolated vertices.
Positions vertex_normals(const Mesh& mesh);

} // namespace tapeline
