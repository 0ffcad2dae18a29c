// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/side.h"

#include "kernel/topology.h"
#include "tests/support/shapes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

namespace tapeline::testing {

std::vector<int> grid_row(int nx, int j)
{
    std::vector<int> row(nx + 1);
    std::iota(row.begin(), row.end(), j * (nx + 1));
    return row;
}

ExtendedLine line_across(const Mesh& mesh, const std::vector<int>& line, bool closed,
                         const std::function<bool(const Vec3&)>& in_region)
{
    ExtendedLine extended;
    extended.model = model_of(mesh);
    extended.vertices = line;
    extended.closed = closed;
    extended.last = static_cast<int>(line.size()) - 1;
    Region& region = extended.region;
    std::set<int> vertices, rim;
    std::vector<char> inside(mesh.F.rows(), 0);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Vec3 centre = (mesh.V.row(mesh.F(t, 0)) + mesh.V.row(mesh.F(t, 1)) + mesh.V.row(mesh.F(t, 2))) / 3;
        inside[t] = !in_region || in_region(centre);
        if (inside[t]) {
            region.faces.push_back(t);
            vertices.insert({mesh.F(t, 0), mesh.F(t, 1), mesh.F(t, 2)});
        }
    }
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    for (const MeshEdge& edge : topology.edges()) {
        const int count = (edge.left >= 0 && inside[edge.left]) + (edge.right >= 0 && inside[edge.right]);
        if (count == 1) {
            rim.insert({edge.a, edge.b});
        }
    }
    region.vertices.assign(vertices.begin(), vertices.end());
    region.fixed_rim.assign(rim.begin(), rim.end());
    return extended;
}

SideMesh left_side(const Mesh& mesh, const std::vector<int>& line, bool closed,
                   const std::function<bool(const Vec3&)>& in_region)
{
    auto sides = split_along(line_across(mesh, line, closed, in_region));
    if (!sides) {
        throw std::runtime_error(sides.error().message);
    }
    return std::move((*sides)[0]);
}

double squash(const SideMesh& side, const Positions& moved, const Vec3& direction)
{
    const Mesh& rest = side.mesh;
    double smallest = 1;
    for (int t = 0; t < side.inner_faces; ++t) {
        const Vec3 p = rest.V.row(rest.F(t, 0)), q = moved.row(rest.F(t, 0));
        Eigen::Matrix<double, 3, 2> before, after;
        for (int k = 0; k < 2; ++k) {
            before.col(k) = rest.V.row(rest.F(t, k + 1)).transpose() - p;
            after.col(k) = moved.row(rest.F(t, k + 1)).transpose() - q;
        }
        // The direction as combination of the triangle's edges, normal part left out.
        const Eigen::Vector2d weights = (before.transpose() * before).inverse() * (before.transpose() * direction);
        const double stretch = (after * weights).norm() / (before * weights).norm();
        const double area_ratio = after.col(0).cross(after.col(1)).norm() / before.col(0).cross(before.col(1)).norm();
        smallest = std::min(smallest, area_ratio / stretch);
    }
    return smallest;
}

std::vector<Vec3> crease_slide(const SideMesh& side, double s)
{
    const ParametricCurve target = crease_slide_target(s);
    std::vector<Vec3> displacements;
    for (const int v : side.line) {
        const Vec3 p = side.mesh.V.row(v);
        displacements.push_back(std::abs(p.x()) < 200 ? Vec3(target.point(p.x()) - p) : Vec3(Vec3::Zero()));
    }
    return displacements;
}

Positions transformed(const Positions& V, double scale, const Eigen::Matrix3d& R, const Vec3& shift)
{
    return ((scale * V * R.transpose()).rowwise() + shift.transpose()).eval();
}

} // namespace tapeline::testing
