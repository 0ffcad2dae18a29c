// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/retraction_steps.h"
#include "kernel/sliding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline {

namespace {

/// Share of the largest displacement over which a line that leaves the side stops dragging material along.
constexpr double fade_width = 0.1;
/// Turn of the surface on a vertex's way [deg] from which on, and beyond which alone, the straightest path decides.
constexpr double walk_from = 15, walk_beyond = 30;
/// Tries to hit a line vertex's place by a straightest path.
constexpr int shots = 8;

Mesh inner_mesh(const SideMesh& side) { return {side.mesh.V, side.mesh.F.topRows(side.inner_faces)}; }

/// Unit vector in the plane of triangle t, orthogonal to its edge a-b, pointing into the triangle.
Vec3 conormal(const Mesh& mesh, int t, int a, int b)
{
    const int c = mesh.F.row(t).sum() - a - b;
    const Vec3 edge = (mesh.V.row(b) - mesh.V.row(a)).normalized();
    const Vec3 arm = mesh.V.row(c) - mesh.V.row(a);
    return (arm - edge * edge.dot(arm)).normalized();
}

/// Point of triangle t closest to p (Ericson, Real-Time Collision Detection, 5.1.5, by the closest of plane and edges).
Vec3 closest_in_triangle(const Mesh& mesh, int t, const Vec3& p)
{
    const Vec3 corner[3] = {mesh.V.row(mesh.F(t, 0)), mesh.V.row(mesh.F(t, 1)), mesh.V.row(mesh.F(t, 2))};
    const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const Vec3 foot = p - n * (n.dot(p - corner[0]) / n.squaredNorm());
    Vec3 best = corner[0];
    bool inside = true;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = corner[k], edge = corner[(k + 1) % 3] - a;
        inside = inside && n.dot(edge.cross(foot - a)) >= 0;
        const Vec3 on_edge = a + edge * std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0);
        if ((p - on_edge).squaredNorm() < least) {
            least = (p - on_edge).squaredNorm();
            best = on_edge;
        }
    }
    return inside ? foot : best;
}

} // namespace

RetractionTask::RetractionTask(const SideMesh& side, const std::vector<Vec3>& displacements)
    : side_(side), inner_(inner_mesh(side)), topology_(inner_.F, static_cast<int>(inner_.V.rows())), surface_(inner_),
      entry_(inner_.V.rows(), -1), free_(inner_.V.rows(), 1), normals_(vertex_normals(inner_)), start_(inner_.V)
{
    for (size_t i = 0; i < side.line.size(); ++i) {
        entry_[side.line[i]] = static_cast<int>(i);
        free_[side.line[i]] = 0;
    }
    for (const int v : side.fixed) {
        free_[v] = 0;
    }
    for (const int v : side.guided) {
        free_[v] = 0;
    }
    for (int v = 0; v < inner_.V.rows(); ++v) {
        if (topology_.vertex_faces(v).empty()) {
            free_[v] = 0;
        }
    }
    const int closing = side.line.size() > 2 ? topology_.find_edge(side.line.back(), side.line.front()) : -1;
    closed_ = closing >= 0 && topology_.edge(closing).border();
    find_moves(displacements);
    place_line();
    place_guided(displacements);
    slide_borders();
    find_arcs();
}

void RetractionTask::find_moves(const std::vector<Vec3>& displacements)
{
    const size_t n = side_.line.size();
    std::vector<Vec3> inwards(n, Vec3::Zero());
    for (size_t i = 0; i + (closed_ ? 0 : 1) < n; ++i) {
        const size_t j = (i + 1) % n;
        const int a = side_.line[i], b = side_.line[j], e = topology_.find_edge(a, b);
        if (e < 0) {
            continue;
        }
        const int t = topology_.edge(e).left >= 0 ? topology_.edge(e).left : topology_.edge(e).right;
        const Vec3 m = conormal(inner_, t, a, b);
        inwards[i] += m;
        inwards[j] += m;
    }
    double largest = 0;
    for (const Vec3& u : displacements) {
        largest = std::max(largest, u.norm());
    }
    for (size_t i = 0; i < n; ++i) {
        const Vec3 m = inwards[i].norm() > 0 ? Vec3(inwards[i].normalized()) : Vec3::Zero();
        const double into = displacements[i].dot(m);
        if (into >= 0) {
            moves_.push_back(displacements[i]);
            continue;
        }
        const double s = std::max(0.0, 1 + into / (fade_width * largest));
        moves_.push_back(s * s * (3 - 2 * s) * (displacements[i] - into * m));
    }
}

void RetractionTask::place_line()
{
    for (size_t i = 0; i < moves_.size(); ++i) {
        if (!moves_[i].isZero(0)) {
            const int v = side_.line[i];
            start_.row(v) = surface_.closest(position(v) + moves_[i]).point;
        }
    }
}

void RetractionTask::place_guided(const std::vector<Vec3>& displacements)
{
    for (size_t i = 0; i < side_.guided.size() && !side_.line.empty(); ++i) {
        const int v = side_.guided[i];
        const auto distance = [&](int w) { return (position(w) - position(v)).squaredNorm(); };
        const size_t end = distance(side_.line.front()) <= distance(side_.line.back()) ? 0 : side_.line.size() - 1;
        const double whole = displacements[end].norm();
        const double share = whole > 0 ? moves_[end].norm() / whole : 1;
        if (share == 1) {
            start_.row(v) = side_.guided_targets[i];
        } else if (share > 0) {
            start_.row(v) = surface_.closest((1 - share) * position(v) + share * side_.guided_targets[i]).point;
        }
    }
}

void RetractionTask::slide_borders()
{
    std::vector<char> seen(inner_.V.rows(), 0);
    for (int v = 0; v < inner_.V.rows(); ++v) {
        if (free_[v] && topology_.border_vertex(v)) {
            free_[v] = 0;
            seen[v] = 1; // still to be put into a chain
        }
    }
    const std::vector<char> on_border = seen;
    for (const int v : {side_.line.empty() ? -1 : side_.line.front(), side_.line.empty() ? -1 : side_.line.back()}) {
        if (v < 0) {
            continue;
        }
        for (const int e : topology_.vertex_edges(v)) {
            const int next = topology_.other_end(e, v);
            if (topology_.edge(e).border() && seen[next]) {
                slide_chain(border_chain(v, next, seen));
            }
        }
    }
}

/// The border from vertex `from` over `next` up to the first vertex that is not on a free border; clears `seen`.
std::vector<int> RetractionTask::border_chain(int from, int next, std::vector<char>& seen) const
{
    std::vector<int> chain{from};
    for (int before = from, at = next; at >= 0;) {
        chain.push_back(at);
        if (!seen[at]) {
            break;
        }
        seen[at] = 0;
        int onward = -1;
        for (const int e : topology_.vertex_edges(at)) {
            const int other = topology_.other_end(e, at);
            if (topology_.edge(e).border() && other != before) {
                onward = other;
            }
        }
        before = at;
        at = onward;
    }
    return chain;
}

void RetractionTask::slide_chain(const std::vector<int>& chain)
{
    std::vector<double> arc{0};
    for (size_t i = 1; i < chain.size(); ++i) {
        arc.push_back(arc.back() + (position(chain[i]) - position(chain[i - 1])).norm());
    }
    const auto point_at = [&](double s) -> Vec3 {
        size_t k = 0;
        while (k + 2 < arc.size() && arc[k + 1] < s) {
            ++k;
        }
        const double t = arc[k + 1] > arc[k] ? std::clamp((s - arc[k]) / (arc[k + 1] - arc[k]), 0.0, 1.0) : 0;
        return (1 - t) * position(chain[k]) + t * position(chain[k + 1]);
    };
    const auto nearest_arc = [&](const Vec3& p) {
        double best = 0, least = std::numeric_limits<double>::infinity();
        for (size_t k = 0; k + 1 < chain.size(); ++k) {
            const Vec3 a = position(chain[k]), edge = position(chain[k + 1]) - a;
            const double t = edge.norm() > 0 ? std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0) : 0;
            if (const double distance = (a + t * edge - p).norm(); distance < least) {
                least = distance;
                best = arc[k] + t * edge.norm();
            }
        }
        return best;
    };
    const auto end = [&](int v, double rest) { return line_entry(v) >= 0 ? nearest_arc(start_.row(v)) : rest; };
    const double first = end(chain.front(), 0), last = end(chain.back(), arc.back());
    if (first == 0 && last == arc.back()) {
        return;
    }
    for (size_t i = 1; i + 1 < chain.size(); ++i) {
        start_.row(chain[i]) = point_at(first + (last - first) * arc[i] / arc.back());
    }
}

Vec3 RetractionTask::normal_at(int face, const Vec3& barycentric) const
{
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += barycentric[k] * normals_.row(inner_.F(face, k)).transpose();
    }
    return sum.norm() > 0 ? Vec3(sum.normalized()) : triangle_normal(inner_, face);
}

void RetractionTask::find_arcs()
{
    for (size_t i = 0; i < moves_.size(); ++i) {
        const int v = side_.line[i];
        arcs_.push_back(moves_[i].isZero(0) ? moves_[i] : arc_to(v, moves_[i], start_.row(v)));
    }
}

Vec3 RetractionTask::arc_to(int v, const Vec3& u, const Vec3& goal) const
{
    const Vec3 normal = normals_.row(v);
    const Vec3 tangential = u - normal * normal.dot(u);
    if (!(tangential.norm() > 1e-3 * u.norm())) {
        return u;
    }
    Vec3 arc = tangential.normalized() * u.norm(), best = arc;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < shots; ++i) {
        const MeshPoint end = slide(inner_, topology_, v, arc);
        if (end.face < 0) {
            return u;
        }
        const Vec3 miss = goal - position_of(inner_, end);
        if (miss.norm() < least) {
            least = miss.norm();
            best = arc;
        }
        const Vec3 correction = Eigen::Quaterniond::FromTwoVectors(normal_at(end.face, end.barycentric), normal) * miss;
        arc += correction - normal * normal.dot(correction);
    }
    return least < 0.1 * u.norm() ? best : u;
}

/// The surface point below or above `wanted` along the surface's smooth normal at `foot`, which lies in triangle `face`
/// or beside it. Closest points of a place beneath a convex edge jump from one side of the edge to the other; this does
/// not. The foot itself where the normal misses the triangles around.
Vec3 RetractionTask::along_normal(int face, const Vec3& foot, const Vec3& wanted) const
{
    const Vec3 o = position(inner_.F(face, 0)), e1 = position(inner_.F(face, 1)) - o;
    const Vec3 e2 = position(inner_.F(face, 2)) - o, n = e1.cross(e2);
    const double b1 = (foot - o).cross(e2).dot(n) / n.squaredNorm(), b2 = e1.cross(foot - o).dot(n) / n.squaredNorm();
    const Vec3 normal = normal_at(face, Vec3(1 - b1 - b2, b1, b2));
    const double most = 2 * (wanted - foot).norm();
    double least = std::numeric_limits<double>::infinity();
    Vec3 best = foot;
    for (int k = 0; k < 3; ++k) {
        for (const int t : topology_.vertex_faces(inner_.F(face, k))) {
            const Vec3 a = position(inner_.F(t, 0)), f1 = position(inner_.F(t, 1)) - a;
            const Vec3 f2 = position(inner_.F(t, 2)) - a, m = f1.cross(f2);
            const double slope = m.dot(normal);
            if (!(std::abs(slope) > 0.1 * m.norm())) {
                continue;
            }
            const double height = m.dot(a - wanted) / slope;
            const Vec3 q = wanted + height * normal;
            const double w1 = (q - a).cross(f2).dot(m), w2 = f1.cross(q - a).dot(m), whole = m.squaredNorm();
            const bool inside = std::min({w1, w2, whole - w1 - w2}) >= -1e-12 * whole;
            if (inside && std::abs(height) <= most && std::abs(height) < least) {
                least = std::abs(height);
                best = q;
            }
        }
    }
    return best;
}

/// The surface point over or under `wanted`: near the one that walking downhill from triangle `face` finds closest, or
/// the closest of all (see `place`).
Vec3 RetractionTask::closest_from(int face, const Vec3& wanted, const Vec3& u) const
{
    const MeshFoot nearest = surface_.closest(wanted);
    for (int k = 0; k < 9; ++k) {
        if (inner_.F(face, k / 3) == inner_.F(nearest.face, k % 3)) {
            return along_normal(nearest.face, nearest.point, wanted);
        }
    }
    Vec3 best = closest_in_triangle(inner_, face, wanted);
    int best_face = face;
    for (int at = face, next = -1; at >= 0; at = next) {
        next = -1;
        for (int k = 0; k < 3; ++k) {
            for (const int t : topology_.vertex_faces(inner_.F(at, k))) {
                const Vec3 q = closest_in_triangle(inner_, t, wanted);
                if ((q - wanted).norm() < (best - wanted).norm() * (1 - 1e-12)) {
                    best = q;
                    best_face = next = t;
                }
            }
        }
    }
    const bool local = (best - wanted).norm() <= nearest.distance + 0.25 * u.norm();
    return local ? along_normal(best_face, best, wanted) : along_normal(nearest.face, nearest.point, wanted);
}

Vec3 RetractionTask::place(int v, const Vec3& u, const Vec3& arc) const
{
    const MeshPoint end = slide(inner_, topology_, v, arc);
    if (end.face < 0) {
        return surface_.closest(position(v) + u).point;
    }
    const Vec3 walked = position_of(inner_, end);
    const double cosine = Vec3(normals_.row(v)).dot(normal_at(end.face, end.barycentric));
    const double turn = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    const double t = std::clamp((turn - walk_from) / (walk_beyond - walk_from), 0.0, 1.0);
    const double share = t * t * (3 - 2 * t);
    if (share == 1) {
        return walked;
    }
    const Vec3 near = closest_from(end.face, position(v) + u, u);
    return share == 0 ? near : closest_from(end.face, (1 - share) * near + share * walked, u);
}

} // namespace tapeline
