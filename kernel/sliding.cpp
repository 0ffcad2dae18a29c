// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/sliding.h"

#include "kernel/vertex_fan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace tapeline {

namespace {

using Vec2 = Eigen::Vector2d;
constexpr double pi = std::numbers::pi;
/// Angles [rad] and edge fractions closer than this are the same.
constexpr double same_angle = 1e-9;
constexpr double vertex_hit = 1e-12;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A place to go on from: a vertex, the fan around it and the polar angle in that fan.
struct Departure {
    int vertex = -1;
    VertexFan fan;
    double angle = 0;
};

class Walk {
public:
    Walk(const Mesh& mesh, const Topology& topology) : mesh_(mesh), topology_(topology) {}

    std::optional<Departure> depart(int v, const Vec3& u) const;
    MeshPoint run(const Departure& departure, double length);
    MeshPoint run(const MeshPoint& from, const Vec3& direction, double length);
    MeshPoint at_vertex(int face, int v) const;

private:
    Vec3 position(int v) const { return mesh_.V.row(v); }
    int across(int face, int edge) const;
    void enter(const Departure& departure);
    MeshPoint go(double length);
    void cross_edge(int face, int first);
    std::optional<Departure> pass_vertex(int exit_corner) const;
    MeshPoint in_face(const Vec2& q) const;

    const Mesh& mesh_;
    const Topology& topology_;
    // The unfolded triangle: its corners in a plane where the path is the straight ray from the origin along ray_.
    int face_ = -1;
    int first_ = 0; ///< the ray leaves over the edge from this corner (right of the ray) to the next (left of it)
    std::array<Vec2, 3> q_;
    Vec2 ray_;
};

int Walk::across(int face, int edge) const
{
    return topology_.edge(edge).face_count == 2 ? topology_.face_across(face, edge) : -1;
}

std::optional<Departure> Walk::depart(int v, const Vec3& u) const
{
    for (VertexFan& fan : fans_at(mesh_, topology_, v)) {
        if (const auto angle = polar_angle(mesh_, v, fan, u)) {
            return Departure{v, std::move(fan), *angle};
        }
    }
    return {};
}

/// Lays out the triangle of the fan that holds the departure's angle, with the vertex at the origin.
void Walk::enter(const Departure& departure)
{
    const VertexFan& fan = departure.fan;
    size_t k = 0;
    while (k + 1 < fan.faces.size() && departure.angle >= fan.start[k + 1]) {
        ++k;
    }
    face_ = fan.faces[k];
    const int c = corner_of(mesh_, face_, departure.vertex);
    first_ = (c + 1) % 3;
    const double opening = fan.start[k + 1] - fan.start[k];
    const double a = (position(mesh_.F(face_, first_)) - position(departure.vertex)).norm();
    const double b = (position(mesh_.F(face_, (c + 2) % 3)) - position(departure.vertex)).norm();
    q_[c].setZero();
    q_[first_] = Vec2(a, 0);
    q_[(c + 2) % 3] = b * Vec2(std::cos(opening), std::sin(opening));
    const double angle = std::clamp(departure.angle - fan.start[k], 0.0, opening);
    ray_ = Vec2(std::cos(angle), std::sin(angle));
}

/// Unfolds `face` over the edge that the ray leaves by; `first` is that face's corner on the right of the ray.
void Walk::cross_edge(int face, int first)
{
    const Vec2 right = q_[first_], left = q_[(first_ + 1) % 3];
    // The neighbour runs along the shared edge the other way: left to right.
    const int to = first, from = (first + 2) % 3, apex = (first + 1) % 3;
    const Vec3 edge = position(mesh_.F(face, from)) - position(mesh_.F(face, to));
    const Vec3 arm = position(mesh_.F(face, apex)) - position(mesh_.F(face, to));
    const double length = edge.norm();
    const double along = length > 0 ? edge.dot(arm) / length : 0;
    const double off = length > 0 ? edge.cross(arm).norm() / length : arm.norm();
    Vec2 axis = left - right;
    axis = axis.norm() > 0 ? Vec2(axis.normalized()) : Vec2(-ray_.y(), ray_.x());
    q_[to] = right;
    q_[from] = left;
    q_[apex] = right + along * axis + off * Vec2(axis.y(), -axis.x());
    face_ = face;
    first_ = cross(ray_, q_[apex]) > 0 ? to : apex;
}

/// Goes on behind a vertex of the current triangle with equal angles to both sides; at a border as straight on as the
/// triangles there allow, or not at all.
std::optional<Departure> Walk::pass_vertex(int exit_corner) const
{
    const int v = mesh_.F(face_, exit_corner);
    Departure next{v, fan_at(mesh_, topology_, v, face_), 0};
    const VertexFan& fan = next.fan;
    const size_t k = std::ranges::find(fan.faces, face_) - fan.faces.begin();
    const Vec2 spoke = q_[(exit_corner + 1) % 3] - q_[exit_corner];
    const double back = std::atan2(cross(spoke, -ray_), spoke.dot(-ray_));
    const double arrived = fan.start[k] + std::clamp(back, 0.0, fan.start[k + 1] - fan.start[k]);
    if (fan.closed) {
        next.angle = arrived + 0.5 * fan.total();
        next.angle -= next.angle >= fan.total() ? fan.total() : 0;
        return next;
    }
    const double beyond = fan.total() - arrived;
    if (beyond >= pi - same_angle) {
        next.angle = std::min(arrived + pi, fan.total());
    } else if (arrived >= pi - same_angle) {
        next.angle = std::max(arrived - pi, 0.0);
    } else {
        return {};
    }
    return next;
}

MeshPoint Walk::at_vertex(int face, int v) const { return {face, Vec3::Unit(corner_of(mesh_, face, v))}; }

MeshPoint Walk::in_face(const Vec2& q) const
{
    const double area = cross(q_[1] - q_[0], q_[2] - q_[0]);
    Vec3 w(cross(q_[1] - q, q_[2] - q), cross(q_[2] - q, q_[0] - q), cross(q_[0] - q, q_[1] - q));
    w = (w / area).cwiseMax(0);
    if (area > 0 && w.allFinite() && w.sum() > 0) {
        return {face_, w / w.sum()};
    }
    // A needle: the place along its longest edge.
    int k = 0;
    for (int i = 1; i < 3; ++i) {
        if ((q_[(i + 1) % 3] - q_[i]).norm() > (q_[(k + 1) % 3] - q_[k]).norm()) {
            k = i;
        }
    }
    const Vec2 edge = q_[(k + 1) % 3] - q_[k];
    const double t = edge.norm() > 0 ? std::clamp((q - q_[k]).dot(edge) / edge.squaredNorm(), 0.0, 1.0) : 0;
    w = (1 - t) * Vec3::Unit(k) + t * Vec3::Unit((k + 1) % 3);
    return {face_, w};
}

MeshPoint Walk::run(const Departure& departure, double length)
{
    enter(departure);
    return go(length);
}

/// From inside a triangle; `direction` is a unit vector in its plane.
MeshPoint Walk::run(const MeshPoint& from, const Vec3& direction, double length)
{
    face_ = from.face;
    const Vec3 across = triangle_normal(mesh_, face_).cross(direction);
    for (int k = 0; k < 3; ++k) {
        const Vec3 arm = position(mesh_.F(face_, k)) - position_of(mesh_, from);
        q_[k] = Vec2(arm.dot(direction), arm.dot(across));
    }
    ray_ = Vec2(1, 0);
    // The edge ahead: where the corners change from the right of the ray to its left, farthest along it.
    double farthest = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const Vec2 &right = q_[k], &left = q_[(k + 1) % 3];
        const double rise = left.y() - right.y();
        if (right.y() <= 0 && left.y() >= 0 && rise > 0) {
            const double exit = right.x() - right.y() / rise * (left.x() - right.x());
            if (exit > farthest) {
                farthest = exit;
                first_ = k;
            }
        }
    }
    return std::isfinite(farthest) ? go(length) : from;
}

MeshPoint Walk::go(double length)
{
    const long long most = 100LL * topology_.face_count() + 1000;
    for (long long i = 0; i < most; ++i) {
        const int second = (first_ + 1) % 3;
        const double right = cross(ray_, q_[first_]), left = cross(ray_, q_[second]);
        const double t = left > right ? std::clamp(-right / (left - right), 0.0, 1.0) : 0.5;
        const Vec2 exit = (1 - t) * q_[first_] + t * q_[second];
        const double travelled = std::max(0.0, exit.dot(ray_));
        if (travelled >= length) {
            return in_face(length * ray_);
        }
        if (t < vertex_hit || t > 1 - vertex_hit) {
            const int hit = t < 0.5 ? first_ : second;
            const auto next = pass_vertex(hit);
            if (!next) {
                return at_vertex(face_, mesh_.F(face_, hit));
            }
            length -= travelled;
            enter(*next);
            continue;
        }
        const int next = across(face_, topology_.face_edges(face_)[first_]);
        if (next < 0) {
            return in_face(exit);
        }
        cross_edge(next, corner_of(mesh_, next, mesh_.F(face_, first_)));
    }
    return in_face(q_[first_]);
}

} // namespace

Vec3 position_of(const Mesh& mesh, const MeshPoint& point)
{
    const auto F = mesh.F.row(point.face);
    return point.barycentric[0] * mesh.V.row(F[0]) + point.barycentric[1] * mesh.V.row(F[1]) +
           point.barycentric[2] * mesh.V.row(F[2]);
}

MeshPoint slide(const Mesh& mesh, const Topology& topology, int v, const Vec3& u)
{
    Walk walk(mesh, topology);
    const auto faces = topology.vertex_faces(v);
    if (faces.empty()) {
        return {};
    }
    MeshPoint stay = walk.at_vertex(faces.front(), v);
    if (!u.allFinite() || u.isZero(0)) {
        return stay;
    }
    const Vec3 normal = [&] {
        Vec3 sum = Vec3::Zero();
        for (const int t : faces) {
            sum += triangle_area(mesh, t) * triangle_normal(mesh, t);
        }
        return sum.norm() > 0 ? Vec3(sum.normalized()) : Vec3::Zero();
    }();
    const Vec3 tangential = u - normal.dot(u) * normal;
    const double length = tangential.norm();
    if (!(length > 0)) {
        return stay;
    }
    auto departure = walk.depart(v, tangential);
    return departure ? walk.run(*departure, length) : stay;
}

MeshPoint slide(const Mesh& mesh, const Topology& topology, const MeshPoint& from, const Vec3& normal, const Vec3& u)
{
    int k = 0;
    if (from.barycentric.maxCoeff(&k) >= 1 - vertex_hit) {
        return slide(mesh, topology, mesh.F(from.face, k), u);
    }
    const Vec3 plane = triangle_normal(mesh, from.face);
    const Vec3 tangential = u - normal.dot(u) * normal;
    const double length = tangential.norm();
    if (!u.allFinite() || !(length > 0) || plane.isZero(0)) {
        return from;
    }
    Vec3 direction = Eigen::Quaterniond::FromTwoVectors(normal, plane) * tangential;
    direction -= plane.dot(direction) * plane;
    return direction.norm() > 0 ? Walk(mesh, topology).run(from, direction.normalized(), length) : from;
}

} // namespace tapeline
