// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/plate_shape.h"

#include "kernel/crease_edges.h"
#include "kernel/line_tangents.h"
#include "kernel/parallel.h"
#include "kernel/vertex_fan.h"

namespace tapeline {

PlateShape plate_shape(const Mesh& mesh, const Material& material)
{
    PlateShape shape;
    shape.elements = triangle_elements(mesh, material);
    shape.K = stiffness_matrix(mesh, shape.elements);
    shape.laplacian = apply_stiffness(shape.K, mesh.V);
    shape.normals = vertex_normals(mesh);
    const auto n = static_cast<size_t>(mesh.V.rows());
    shape.cells.assign(n, 0);
    shape.metric.assign(n, Eigen::Matrix3d::Zero());
    shape.curvature.assign(n, Eigen::Matrix3d::Zero());
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const TriangleElement& element = shape.elements[t];
        Eigen::Matrix3d corner_normals;
        for (int k = 0; k < 3; ++k) {
            corner_normals.col(k) = shape.normals.row(mesh.F(t, k)).transpose();
        }
        const Eigen::Matrix2d slope = element.basis.transpose() * corner_normals * element.gradient.transpose();
        const Eigen::Matrix3d bending = -0.5 * element.basis * (slope + slope.transpose()) * element.basis.transpose();
        const Eigen::Matrix3d metric = element.basis * element.material * element.basis.transpose();
        for (int k = 0; k < 3; ++k) {
            shape.cells[mesh.F(t, k)] += element.area / 3;
            shape.metric[mesh.F(t, k)] += element.area / 3 * metric;
            shape.curvature[mesh.F(t, k)] += element.area / 3 * bending;
        }
    }
    for (size_t v = 0; v < n; ++v) {
        if (shape.cells[v] > 0) {
            shape.metric[v] /= shape.cells[v];
            shape.curvature[v] /= shape.cells[v];
        }
    }
    return shape;
}

Positions apply_stiffness(const Eigen::SparseMatrix<double>& K, const Positions& V)
{
    Positions result(V.rows(), 3);
    parallel_for(static_cast<int>(V.rows()), [&](int v) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (Eigen::SparseMatrix<double>::InnerIterator it(K, v); it; ++it) {
            sum += it.value() * (V.row(it.row()) - V.row(v));
        }
        result.row(v) = sum;
    });
    return result;
}

void keep_beside_creases(const Mesh& rest, const Topology& topology, std::vector<std::vector<int>>& lists)
{
    constexpr double least_crease = 5; // [deg]
    std::vector<char> keep(lists.size(), 0);
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        if (edge.left >= 0 && edge.right >= 0 && !lists[edge.a].empty() && !lists[edge.b].empty() &&
            standing_out_angle(rest, topology, e) >= least_crease) {
            keep[edge.a] = keep[edge.b] = 1;
        }
    }
    for (size_t v = 0; v < lists.size(); ++v) {
        if (!keep[v]) {
            lists[v].clear();
        }
    }
}

Vec3 pull_across_planes(const Mesh& rest, const Eigen::Matrix3d& R, const Mesh& moved,
                        const std::vector<TriangleElement>& elements, int v, const std::vector<int>& faces)
{
    Vec3 across = Vec3::Zero();
    for (const int t : faces) {
        const TriangleElement& element = elements[t];
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k) {
            corners.col(k) = (moved.V.row(moved.F(t, k)) - moved.V.row(v)).transpose();
        }
        const Vec3 pull = element.area * corners * element.gradient.transpose() * element.material *
                          element.gradient.col(corner_of(moved, t, v));
        const Vec3 normal = R * triangle_normal(rest, t);
        across += normal * normal.dot(pull);
    }
    return across;
}

std::vector<Vec3> polyline_curvature(const Positions& V, const std::vector<int>& line, bool closed)
{
    const size_t n = line.size();
    std::vector<Vec3> result(n, Vec3::Zero());
    for (size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
        const Vec3 before = V.row(line[i]) - V.row(line[(i + n - 1) % n]);
        const Vec3 after = V.row(line[(i + 1) % n]) - V.row(line[i]);
        const double length = before.norm() + after.norm();
        if (before.norm() > 0 && after.norm() > 0) {
            result[i] = 2 / length * (after.normalized() - before.normalized());
        }
    }
    return result;
}

std::vector<double> line_twist(const Positions& V, const Positions& normals, const std::vector<int>& line, bool closed)
{
    const size_t n = line.size();
    std::vector<double> result(n, 0);
    for (size_t i = 0; i < n && n > 1; ++i) {
        const auto [before, after] = line_neighbours(i, n, closed);
        const Vec3 step = V.row(line[after]) - V.row(line[before]);
        const Vec3 turn = normals.row(line[after]) - normals.row(line[before]);
        const Vec3 normal = normals.row(line[i]);
        result[i] = step.squaredNorm() > 0 ? -turn.dot(normal.cross(step)) / step.squaredNorm() : 0;
    }
    return result;
}

} // namespace tapeline
