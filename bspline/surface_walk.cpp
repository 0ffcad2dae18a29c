// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/surface_walk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace tapeline::spline {

namespace {

constexpr double cos_30 = 0.866;

/// A triangle's edges: start point, unit direction, unit conormal pointing into the triangle, length.
struct FaceFrame {
    std::array<Vec3, 3> corner, along, inward;
    std::array<double, 3> length;
    Vec3 normal = Vec3::Zero();
    bool valid = false;
};

FaceFrame frame_of(const Mesh& mesh, int face)
{
    FaceFrame f;
    for (int k = 0; k < 3; ++k) {
        f.corner[k] = mesh.V.row(mesh.F(face, k));
    }
    f.normal = triangle_normal(mesh, face);
    f.valid = f.normal.squaredNorm() > 0.5;
    for (int k = 0; k < 3; ++k) {
        const Vec3 edge = f.corner[(k + 1) % 3] - f.corner[k];
        f.length[k] = edge.norm();
        f.along[k] = edge / f.length[k];
        f.inward[k] = f.normal.cross(f.along[k]).normalized();
    }
    return f;
}

/// Neighbour across edge k of a face, -1 at borders and non-manifold edges.
int neighbour(const Topology& topology, int face, int k)
{
    const int e = topology.face_edges(face)[k];
    return topology.edge(e).face_count == 2 ? topology.face_across(face, e) : -1;
}

/// Which edge of `face` is mesh edge e.
int local_edge(const Topology& topology, int face, int e)
{
    const auto& edges = topology.face_edges(face);
    return edges[0] == e ? 0 : edges[1] == e ? 1 : 2;
}

/// Triangles that the foot belongs to, lowest index first.
std::vector<int> touching(const Mesh& mesh, const Topology& topology, const MeshFoot& foot)
{
    constexpr double on_it = 1e-9; // barycentric: the closest-point query lands on edges to rounding
    std::vector<int> faces{foot.face};
    for (int k = 0; k < 3; ++k) {
        if (foot.barycentric[k] > 1 - 2 * on_it) {
            const auto all = topology.vertex_faces(mesh.F(foot.face, k));
            faces.assign(all.begin(), all.end());
            std::ranges::sort(faces);
            return faces;
        }
    }
    for (int k = 0; k < 3; ++k) {
        // Edge k joins corners k and k + 1: the third corner's weight vanishes on it.
        if (foot.barycentric[(k + 2) % 3] <= on_it) {
            if (const int other = neighbour(topology, foot.face, k); other >= 0) {
                faces.push_back(other);
            }
        }
    }
    std::ranges::sort(faces);
    return faces;
}

} // namespace

std::optional<WalkStart> start_beside(const Mesh& mesh, const Topology& topology, const MeshFoot& foot,
                                      const Vec3& tangent, bool left)
{
    std::optional<WalkStart> best;
    double best_score = -2;
    for (const int face : touching(mesh, topology, foot)) {
        const FaceFrame f = frame_of(mesh, face);
        Vec3 direction = f.normal.cross(left ? tangent : Vec3(-tangent));
        if (!f.valid || direction.norm() < 1e-3) {
            continue;
        }
        direction.normalize();
        double score = 1; // how far the direction points into the triangle
        for (int k = 0; k < 3; ++k) {
            const double height = (f.corner[(k + 2) % 3] - f.corner[k]).dot(f.inward[k]);
            if ((foot.point - f.corner[k]).dot(f.inward[k]) <= 1e-8 * height) {
                score = std::min(score, direction.dot(f.inward[k]));
            }
        }
        if (score > best_score + 1e-12) {
            best_score = score;
            best = WalkStart{face, foot.point, direction};
        }
    }
    return best;
}

WalkEnd walk(const Mesh& mesh, const Topology& topology, const WalkStart& start, double distance)
{
    int face = start.face, entry = -1;
    bool along_border = false;
    Vec3 p = start.point, d = start.direction;
    double left = distance;
    // A path crosses few triangles; the limit only ends a walk that turns in a circle on a broken mesh.
    for (long step = 0; step < 1000 + 10 * mesh.F.rows() && left > 0; ++step) {
        const FaceFrame f = frame_of(mesh, face);
        if (!f.valid) {
            break;
        }
        int exit = -1;
        double nearest = left;
        for (int k = 0; k < 3; ++k) {
            const double speed = d.dot(f.inward[k]);
            if (k == entry || speed >= 0) {
                continue;
            }
            const double t = std::max(0.0, (p - f.corner[k]).dot(f.inward[k])) / -speed;
            if (t < nearest) {
                nearest = t;
                exit = k;
            }
        }
        p += nearest * d;
        left -= nearest;
        if (exit < 0) {
            return {p, 0, along_border};
        }
        // Keep off the vertices, where the next triangle would be a matter of rounding.
        const double s = std::clamp((p - f.corner[exit]).dot(f.along[exit]) / f.length[exit], 1e-9, 1 - 1e-9);
        p = f.corner[exit] + s * f.length[exit] * f.along[exit];
        const double with_edge = d.dot(f.along[exit]);
        const int next = neighbour(topology, face, exit);
        if (next < 0) {
            if (std::abs(with_edge) < cos_30) {
                return {p, left, along_border};
            }
            d = with_edge > 0 ? f.along[exit] : Vec3(-f.along[exit]);
            entry = exit;
            along_border = true;
            continue;
        }
        const FaceFrame g = frame_of(mesh, next);
        const int k = local_edge(topology, next, topology.face_edges(face)[exit]);
        d = (with_edge * f.along[exit] - d.dot(f.inward[exit]) * g.inward[k]).normalized();
        face = next;
        entry = k;
    }
    return {p, left, along_border};
}

std::optional<WalkEnd> walk_border(const Mesh& mesh, const Topology& topology, const WalkStart& start, double distance)
{
    // The border edge at the start that runs best along the direction, and the vertex it leads to.
    int edge = -1, ahead = -1;
    double best = cos_30;
    for (const int v : mesh.F.row(start.face)) {
        for (const int e : topology.vertex_edges(v)) {
            const MeshEdge& candidate = topology.edge(e);
            const Vec3 a = mesh.V.row(candidate.a), b = mesh.V.row(candidate.b);
            const double length = (b - a).norm(), s = (start.point - a).dot(b - a) / (length * length);
            const bool on_it = s > -1e-9 && s < 1 + 1e-9 && (start.point - a - s * (b - a)).norm() < 1e-6 * length;
            const double along = start.direction.dot(b - a) / length;
            const bool room = along > 0 ? s < 1 - 1e-9 : s > 1e-9;
            if (candidate.border() && on_it && room && std::abs(along) > best) {
                best = std::abs(along);
                edge = e;
                ahead = along > 0 ? candidate.b : candidate.a;
            }
        }
    }
    if (edge < 0) {
        return {};
    }
    Vec3 p = start.point, heading = Vec3::Zero();
    double left = distance;
    for (int step = 0; step < topology.edge_count(); ++step) {
        const Vec3 goal = mesh.V.row(ahead), way = goal - p;
        const bool corner = heading.norm() > 0 && way.dot(heading) < 0.5 * way.norm() * heading.norm();
        if (corner) {
            break;
        }
        if (way.norm() >= left) {
            return WalkEnd{p + left * way.normalized(), 0, true};
        }
        left -= way.norm();
        p = goal;
        heading = way;
        int next = -1, count = 0;
        for (const int e : topology.vertex_edges(ahead)) {
            if (topology.edge(e).border() && e != edge) {
                next = e;
                ++count;
            }
        }
        if (count != 1) {
            break;
        }
        edge = next;
        ahead = topology.other_end(edge, ahead);
    }
    return WalkEnd{p, left, true};
}

} // namespace tapeline::spline
