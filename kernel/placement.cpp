// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline {

namespace {

/// Normals of the triangles left and right of the directed edge a→b; zero where there is none.
std::pair<Vec3, Vec3> normals_beside(const Mesh& mesh, const Topology& topology, int a, int b)
{
    const int left = topology.face_left_of(a, b), right = topology.face_left_of(b, a);
    return {left < 0 ? Vec3(Vec3::Zero()) : triangle_normal(mesh, left),
            right < 0 ? Vec3(Vec3::Zero()) : triangle_normal(mesh, right)};
}

int edge_count(const FeatureLine& line) { return static_cast<int>(line.vertices.size()) - (line.closed ? 0 : 1); }

} // namespace

double smooth_step(double value, double from, double to)
{
    const double s = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

PlacementResult decide_placement(const Mesh& mesh, const Region& region, const Correspondence& correspondence)
{
    return decide_placement(mesh, Topology(mesh.F, static_cast<int>(mesh.V.rows())), ClosestPoint(mesh, region.faces),
                            correspondence);
}

PlacementResult decide_placement(const Mesh& mesh, const Topology& topology, const ClosestPoint& surface,
                                 const Correspondence& correspondence)
{
    const FeatureLine& line = correspondence.line;
    const auto n = line.vertices.size();

    PlacementResult result;
    std::vector<double> lift(n);
    for (size_t i = 0; i < n; ++i) {
        lift[i] = surface.closest(correspondence.targets[i]).distance;
        result.u_max_mm = std::max(result.u_max_mm, correspondence.displacements[i].norm());
    }
    double moved = 0, lifted = 0, tangential_left = 0, tangential_right = 0, normal_left = 0, normal_right = 0,
           path = 0, across = 0;
    for (int i = 0; i < edge_count(line); ++i) {
        const size_t j = i + 1U < n ? i + 1U : 0;
        const int a = line.vertices[i], b = line.vertices[j];
        const Vec3 edge = Vec3(mesh.V.row(b)) - Vec3(mesh.V.row(a));
        const double length = edge.norm();
        const Vec3 direction = edge / length;
        const Vec3 u = 0.5 * (correspondence.displacements[i] + correspondence.displacements[j]);
        const auto [left, right] = normals_beside(mesh, topology, a, b);
        // Conormals: in the plane of each side's triangle, across the edge, pointing into the side.
        result.c_left += length * u.dot(left.cross(direction));
        result.c_right -= length * u.dot(right.cross(direction));
        tangential_left += (u - left * left.dot(u)).norm();
        tangential_right += (u - right * right.dot(u)).norm();
        normal_left += std::abs(left.dot(u));
        normal_right += std::abs(right.dot(u));
        path += u.norm();
        across += length * std::abs(u.dot((left + right).normalized().cross(direction)));
        moved += length * u.norm();
        lifted += length * 0.5 * (lift[i] + lift[j]);
    }
    result.s_alpha = tangential_left;
    result.s_beta = tangential_right;
    result.compressed = result.c_left >= result.c_right ? LineSide::left : LineSide::right;
    result.off_fraction = moved > 0 ? std::min(1.0, lifted / moved) : 0;
    const double normal = result.compressed == LineSide::left ? normal_left : normal_right;
    result.normal_fraction = path > 0 ? normal / path : 0;
    if (lifted > 0) {
        result.whole_share =
            smooth_step(lifted / std::hypot(lifted, across), 0.95, 0.99) * smooth_step(result.off_fraction, 0.3, 0.7);
    }
    result.verdict = result.off_fraction > std::numbers::sqrt2 / 2 ? Placement::off_surface : Placement::on_surface;
    return result;
}

std::vector<double> signed_crease_angles(const Mesh& mesh, const Positions& V, const FeatureLine& line)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const Mesh shape{V, mesh.F};
    std::vector<double> angles;
    for (int i = 0; i < edge_count(line); ++i) {
        const int a = line.vertices[i], b = line.vertices[(i + 1) % line.vertices.size()];
        const Vec3 direction = (Vec3(V.row(b)) - Vec3(V.row(a))).normalized();
        const auto [left, right] = normals_beside(shape, topology, a, b);
        angles.push_back(std::atan2(right.cross(left).dot(direction), right.dot(left)) * 180 / std::numbers::pi);
    }
    return angles;
}

} // namespace tapeline
