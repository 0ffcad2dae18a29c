// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/retraction_ground.h"

#include "kernel/mesh_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace tapeline {

namespace {

/// Turn of the surface on a vertex's way [deg] from which on, and beyond which alone, the straightest path decides.
constexpr double walk_from = 15, walk_beyond = 30;
/// Tries to hit a line vertex's place by a straightest path.
constexpr int shots = 8;

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

RetractionGround::RetractionGround(const Mesh& inner, const std::vector<VertexPair>& walls)
    : mesh_(inner), topology_(inner.F, static_cast<int>(inner.V.rows())), local_(inner.V.rows())
{
    std::iota(local_.begin(), local_.end(), 0);
    part_.assign(inner.F.rows(), 0);
    if (!walls.empty()) {
        std::vector<int> faces(inner.F.rows());
        std::iota(faces.begin(), faces.end(), 0);
        FacePatch cut = patch_of_faces(inner, faces, walls);
        mesh_ = std::move(cut.mesh);
        topology_ = Topology(mesh_.F, static_cast<int>(mesh_.V.rows()));
        std::ranges::fill(local_, -1);
        for (int v = 0; v < static_cast<int>(cut.to_vertex.size()); ++v) {
            local_[cut.to_vertex[v]] = v;
        }
        part_ = mesh_parts(topology_);
    }
    normals_ = vertex_normals(mesh_);
    std::vector<std::vector<int>> faces;
    for (int t = 0; t < static_cast<int>(part_.size()); ++t) {
        faces.resize(std::max<size_t>(faces.size(), part_[t] + 1));
        faces[part_[t]].push_back(t);
    }
    for (const auto& list : faces) {
        trees_.emplace_back(mesh_, list);
    }
}

Vec3 RetractionGround::closest(const Vec3& p) const
{
    MeshFoot best;
    best.distance = std::numeric_limits<double>::infinity();
    for (const ClosestPoint& tree : trees_) {
        const MeshFoot foot = tree.closest(p);
        best = foot.face >= 0 && foot.distance < best.distance ? foot : best;
    }
    return best.face >= 0 ? best.point : p;
}

double RetractionGround::distance_in_part(int v, const Vec3& p) const
{
    const auto faces = topology_.vertex_faces(local_[v]);
    return faces.empty() ? 0 : trees_[part_[faces.front()]].closest(p).distance;
}

Vec3 RetractionGround::normal_at(int face, const Vec3& barycentric) const
{
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += barycentric[k] * normals_.row(mesh_.F(face, k)).transpose();
    }
    return sum.norm() > 0 ? Vec3(sum.normalized()) : triangle_normal(mesh_, face);
}

Vec3 RetractionGround::arc_to(int v, const Vec3& u, const Vec3& goal) const
{
    v = local_[v];
    const Vec3 normal = normals_.row(v);
    const Vec3 tangential = u - normal * normal.dot(u);
    if (!(tangential.norm() > 1e-3 * u.norm())) {
        return u;
    }
    Vec3 arc = tangential.normalized() * u.norm(), best = arc;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < shots; ++i) {
        const MeshPoint end = slide(mesh_, topology_, v, arc);
        if (end.face < 0) {
            return u;
        }
        const Vec3 miss = goal - position_of(mesh_, end);
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
Vec3 RetractionGround::along_normal(int face, const Vec3& foot, const Vec3& wanted) const
{
    const Vec3 o = position(mesh_.F(face, 0)), e1 = position(mesh_.F(face, 1)) - o;
    const Vec3 e2 = position(mesh_.F(face, 2)) - o, n = e1.cross(e2);
    const double b1 = (foot - o).cross(e2).dot(n) / n.squaredNorm(), b2 = e1.cross(foot - o).dot(n) / n.squaredNorm();
    const Vec3 normal = normal_at(face, Vec3(1 - b1 - b2, b1, b2));
    const double most = 2 * (wanted - foot).norm();
    double least = std::numeric_limits<double>::infinity();
    Vec3 best = foot;
    for (int k = 0; k < 3; ++k) {
        for (const int t : topology_.vertex_faces(mesh_.F(face, k))) {
            const Vec3 a = position(mesh_.F(t, 0)), f1 = position(mesh_.F(t, 1)) - a;
            const Vec3 f2 = position(mesh_.F(t, 2)) - a, m = f1.cross(f2);
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
Vec3 RetractionGround::closest_from(int face, const Vec3& wanted, const Vec3& u) const
{
    const MeshFoot nearest = trees_[part_[face]].closest(wanted);
    for (int k = 0; k < 9; ++k) {
        if (mesh_.F(face, k / 3) == mesh_.F(nearest.face, k % 3)) {
            return along_normal(nearest.face, nearest.point, wanted);
        }
    }
    Vec3 best = closest_in_triangle(mesh_, face, wanted);
    int best_face = face;
    for (int at = face, next = -1; at >= 0; at = next) {
        next = -1;
        for (int k = 0; k < 3; ++k) {
            for (const int t : topology_.vertex_faces(mesh_.F(at, k))) {
                const Vec3 q = closest_in_triangle(mesh_, t, wanted);
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

Vec3 RetractionGround::place(int v, const Vec3& u, const Vec3& arc) const
{
    v = local_[v];
    const MeshPoint end = slide(mesh_, topology_, v, arc);
    if (end.face < 0) {
        return closest(position(v) + u);
    }
    Vec3 walked = position_of(mesh_, end);
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
