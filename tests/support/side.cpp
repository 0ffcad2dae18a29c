// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/side.h"

#include "kernel/topology.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

namespace tapeline::testing
{

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

double squash(const Mesh& rest, int faces, const Positions& moved, const Vec3& direction)
{
    const auto altitude = [&](const Positions& V, int t) {
        const Vec3 a = V.row(rest.F(t, 0)), b = V.row(rest.F(t, 1)), c = V.row(rest.F(t, 2));
        const Vec3 along(a.dot(direction), b.dot(direction), c.dot(direction));
        return (b - a).cross(c - a).norm() / (along.maxCoeff() - along.minCoeff());
    };
    double smallest = 1;
    for (int t = 0; t < faces; ++t) {
        smallest = std::min(smallest, altitude(moved, t) / altitude(rest.V, t));
    }
    return smallest;
}

double squash_at_line(const SideMesh& side, const Positions& moved)
{
    const Topology topology(side.mesh.F.topRows(side.inner_faces), static_cast<int>(side.mesh.V.rows()));
    double smallest = 1;
    for (size_t i = 0; i + 1 < side.line.size(); ++i) {
        const int a = side.line[i], b = side.line[i + 1], t = topology.face_left_of(a, b);
        const int c = side.mesh.F.row(t).sum() - a - b;
        const auto altitude = [&](const Positions& V) {
            const Vec3 edge = V.row(b) - V.row(a), arm = V.row(c) - V.row(a);
            return edge.cross(arm).norm() / edge.norm();
        };
        smallest = std::min(smallest, altitude(moved) / altitude(side.mesh.V));
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
