// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline {

namespace {

/// Twice the area vector of triangle t.
Vec3 area_vector(const Mesh& mesh, int t)
{
    const Vec3 a = mesh.V.row(mesh.F(t, 0));
    const Vec3 b = mesh.V.row(mesh.F(t, 1));
    const Vec3 c = mesh.V.row(mesh.F(t, 2));
    return (b - a).cross(c - a);
}

} // namespace

Vec3 triangle_normal(const Mesh& mesh, int t)
{
    const Vec3 n = area_vector(mesh, t);
    const double length = n.norm();
    return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

double triangle_area(const Mesh& mesh, int t) { return 0.5 * area_vector(mesh, t).norm(); }

double triangle_min_angle(const Mesh& mesh, int t)
{
    const double twice_area = area_vector(mesh, t).norm();
    if (twice_area <= 0) {
        return 0;
    }
    double smallest = std::numbers::pi;
    for (int k = 0; k < 3; ++k) {
        const Vec3 p = mesh.V.row(mesh.F(t, k));
        const Vec3 e1 = Vec3(mesh.V.row(mesh.F(t, (k + 1) % 3))) - p;
        const Vec3 e2 = Vec3(mesh.V.row(mesh.F(t, (k + 2) % 3))) - p;
        smallest = std::min(smallest, std::atan2(twice_area, e1.dot(e2)));
    }
    return smallest * 180 / std::numbers::pi;
}

double bounding_diagonal(const Positions& V)
{
    return V.rows() == 0 ? 0 : (V.colwise().maxCoeff() - V.colwise().minCoeff()).norm();
}

double rotation_free_size(const Positions& V)
{
    if (V.rows() == 0) {
        return 0;
    }
    // As an expression the mean would be taken anew for every row.
    const Eigen::RowVector3d mean = V.colwise().mean();
    return 2 * (V.rowwise() - mean).rowwise().norm().maxCoeff();
}

Positions vertex_normals(const Mesh& mesh)
{
    Positions N = Positions::Zero(mesh.V.rows(), 3);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Vec3 n = area_vector(mesh, t);
        for (int k = 0; k < 3; ++k) {
            N.row(mesh.F(t, k)) += n.transpose();
        }
    }
    for (int v = 0; v < N.rows(); ++v) {
        const double length = N.row(v).norm();
        if (length > 0) {
            N.row(v) /= length;
        }
    }
    return N;
}

} // namespace tapeline
