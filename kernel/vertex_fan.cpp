// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/vertex_fan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline {

namespace {

constexpr double pi = std::numbers::pi;
/// Angles [rad] closer than this are the same.
constexpr double same_angle = 1e-9;

double wrap(double angle) { return angle - 2 * pi * std::floor(angle / (2 * pi)); }

Vec3 position(const Mesh& mesh, int v) { return mesh.V.row(v); }

/// The edges from v to the next and to the last corner of a triangle.
std::pair<Vec3, Vec3> arms(const Mesh& mesh, int face, int v)
{
    const int k = corner_of(mesh, face, v);
    return {position(mesh, mesh.F(face, (k + 1) % 3)) - position(mesh, v),
            position(mesh, mesh.F(face, (k + 2) % 3)) - position(mesh, v)};
}

double corner_angle(const Mesh& mesh, int face, int v)
{
    const auto [a, b] = arms(mesh, face, v);
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

int across(const Topology& topology, int face, int edge)
{
    return topology.edge(edge).face_count == 2 ? topology.face_across(face, edge) : -1;
}

} // namespace

int corner_of(const Mesh& mesh, int face, int v) { return mesh.F(face, 0) == v ? 0 : (mesh.F(face, 1) == v ? 1 : 2); }

VertexFan fan_at(const Mesh& mesh, const Topology& topology, int v, int face)
{
    // Back, clockwise, to where the fan begins; then once around.
    const size_t most = topology.vertex_faces(v).size();
    VertexFan fan;
    int begin = face;
    for (size_t i = 0; i < most; ++i) {
        const int before = across(topology, begin, topology.face_edges(begin)[corner_of(mesh, begin, v)]);
        if (before < 0) {
            break;
        }
        begin = before;
        if (begin == face) {
            fan.closed = true;
            break;
        }
    }
    fan.start.push_back(0);
    for (int t = begin; t >= 0 && fan.faces.size() < most;) {
        fan.faces.push_back(t);
        fan.start.push_back(fan.start.back() + corner_angle(mesh, t, v));
        t = across(topology, t, topology.face_edges(t)[(corner_of(mesh, t, v) + 2) % 3]);
        if (t == begin) {
            break;
        }
    }
    return fan;
}

std::vector<VertexFan> fans_at(const Mesh& mesh, const Topology& topology, int v)
{
    std::vector<VertexFan> all;
    for (const int t : topology.vertex_faces(v)) {
        const bool known = std::ranges::any_of(
            all, [t](const VertexFan& fan) { return std::ranges::find(fan.faces, t) != fan.faces.end(); });
        if (!known) {
            all.push_back(fan_at(mesh, topology, v, t));
        }
    }
    return all;
}

std::optional<double> polar_angle(const Mesh& mesh, int v, const VertexFan& fan, const Vec3& u)
{
    Vec3 normal = Vec3::Zero();
    std::vector<Vec3> spokes;
    for (const int t : fan.faces) {
        const auto [a, b] = arms(mesh, t, v);
        normal += a.cross(b);
        spokes.push_back(a);
        if (!fan.closed && t == fan.faces.back()) {
            spokes.push_back(b);
        }
    }
    const double size = normal.norm();
    if (!(size > 0 && fan.total() > 0)) {
        return {};
    }
    normal /= size;
    const Vec3 X = normal.unitOrthogonal();
    const Vec3 Y = normal.cross(X);
    std::vector<double> seen;
    double opening = 0;
    for (const Vec3& spoke : spokes) {
        seen.push_back(std::atan2(spoke.dot(Y), spoke.dot(X)));
        if (seen.size() > 1) {
            opening += std::remainder(seen.back() - seen[seen.size() - 2], 2 * pi);
        }
    }
    double scale = fan.closed ? 2 * pi / fan.total() : opening / fan.total();
    if (!(scale > 0.1 && scale < 10)) {
        scale = 1;
    }
    Eigen::Vector2d turn = Eigen::Vector2d::Zero();
    for (size_t k = 0; k < spokes.size(); ++k) {
        const double weight = std::hypot(spokes[k].dot(X), spokes[k].dot(Y));
        const double angle = seen[k] - scale * fan.start[k];
        turn += weight * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    const double angle = wrap(std::atan2(u.dot(Y), u.dot(X)) - std::atan2(turn.y(), turn.x())) / scale;
    if (fan.closed || angle <= fan.total() + same_angle) {
        return std::min(angle, fan.total());
    }
    return angle >= 2 * pi / scale - same_angle ? std::optional<double>(0) : std::nullopt;
}

} // namespace tapeline
