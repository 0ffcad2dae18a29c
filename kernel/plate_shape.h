// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"
#include "kernel/orthotropic.h"
#include "kernel/topology.h"

#include <Eigen/Sparse>
#include <vector>

namespace tapeline {

/// How a triangle mesh is curved, at each vertex, as the thin plate sees it (method.md B5, A9).
struct PlateShape {
    std::vector<TriangleElement> elements;
    Eigen::SparseMatrix<double> K;          ///< Σ_t A_t g_aᵀ D_t g_b, n×n
    Positions laplacian;                    ///< K p, row a = -M_a (D : ∇∇p) but for discretisation
    Positions normals;                      ///< unit, area-weighted
    std::vector<double> cells;              ///< M_a: a third of the triangles around a [mm²]
    std::vector<Eigen::Matrix3d> metric;    ///< D of the triangles around a, in space
    std::vector<Eigen::Matrix3d> curvature; ///< second fundamental form in space: n·∂∂p, from the normals' gradient

    /// D : curvature at vertex v, the orthotropic sum of normal curvatures [1/mm].
    double bend(int v) const { return metric[v].cwiseProduct(curvature[v]).sum(); }
};

PlateShape plate_shape(const Mesh& mesh, const Material& material);

/// K V, each row summed over differences to its own vertex, which keeps the digits that large coordinates would cost.
Positions apply_stiffness(const Eigen::SparseMatrix<double>& K, const Positions& V);

/// Empties the lists, one per vertex, of all but the ends of creases between two listed vertices: edges of which at least
/// 5 deg stand out (kernel/crease_edges.h).
void keep_beside_creases(const Mesh& rest, const Topology& topology, std::vector<std::vector<int>>& lists);

/// What of row v of K V leaves the planes of triangles at rest: the sum over the listed triangles around v of their pull
/// on it, as `moved` has them, across the planes in which they lie at rest, turned by R.
Vec3 pull_across_planes(const Mesh& rest, const Eigen::Matrix3d& R, const Mesh& moved,
                        const std::vector<TriangleElement>& elements, int v, const std::vector<int>& faces);

/// Curvature vector of the polyline through the listed vertices at each of them [1/mm], zero at the ends of an open one.
std::vector<Vec3> polyline_curvature(const Positions& V, const std::vector<int>& line, bool closed);

/// Twist of a surface along a line on it, -n' · (n × t) with n the surface's normal (row v of `normals` for vertex v) and
/// t the line's direction: the entry of the second fundamental form along and across the line [1/mm], per entry of the
/// line; one-sided at the ends of an open one.
std::vector<double> line_twist(const Positions& V, const Positions& normals, const std::vector<int>& line, bool closed);

} // namespace tapeline
