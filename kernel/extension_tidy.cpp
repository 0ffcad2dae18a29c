// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension_tidy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline {

namespace {

using Path = std::vector<PathPoint>;

constexpr double snap_fraction = 0.05;
constexpr double clearance = 0.15;                        ///< kept from blocked vertices, as a part of the edge
constexpr double thin_angle = 6 * std::numbers::pi / 180; ///< cut triangles below this are worth a snap ...
constexpr double thin_snap_fraction = 0.2;                ///< ... of at most this part of the edge

bool same_vertex(const PathPoint& p, const PathPoint& q) { return p.is_vertex() && q.is_vertex() && p.a == q.a; }
bool same_edge(const PathPoint& p, const PathPoint& q) { return !p.is_vertex() && p.a == q.a && p.b == q.b; }
bool end_of_edge(const PathPoint& vertex, const PathPoint& on_edge)
{
    return vertex.is_vertex() && !on_edge.is_vertex() && (vertex.a == on_edge.a || vertex.a == on_edge.b);
}

/// A triangle that holds both points; -1 = none.
int common_face(const RouteSpace& space, const PathPoint& p, const PathPoint& q)
{
    const std::vector<int> at_p = space.faces_at(p), at_q = space.faces_at(q);
    for (const int t : at_p) {
        if (std::find(at_q.begin(), at_q.end(), t) != at_q.end()) {
            return t;
        }
    }
    return -1;
}

bool holds(const RouteSpace& space, int face, const PathPoint& p)
{
    const std::vector<int> faces = space.faces_at(p);
    return std::find(faces.begin(), faces.end(), face) != faces.end();
}

/// True when the segment p–q of one triangle may be part of a path: not along a wall.
bool passable(const RouteSpace& space, const PathPoint& p, const PathPoint& q)
{
    return !p.is_vertex() || !q.is_vertex() || !space.is_wall(space.topology.find_edge(p.a, q.a));
}

/// True when point i of the path is not needed.
bool superfluous(const RouteSpace& space, const Path& path, size_t i)
{
    const PathPoint &before = path[i - 1], &point = path[i], &after = path[i + 1];
    if (same_vertex(before, point) || same_vertex(point, after) || end_of_edge(before, point) ||
        end_of_edge(after, point)) {
        return true;
    }
    if (same_edge(before, after) || end_of_edge(before, after) || end_of_edge(after, before)) {
        return false; // taken care of when the points on the edge have become neighbours
    }
    const int face = common_face(space, before, after);
    return face >= 0 && holds(space, face, point) && passable(space, before, after);
}

/// Cuts out the part between two visits of the same vertex or edge.
bool cut_loop(Path& path)
{
    for (size_t i = 0; i < path.size(); ++i) {
        for (size_t j = path.size() - 1; j > i; --j) {
            if (same_vertex(path[i], path[j]) || same_edge(path[i], path[j])) {
                if (!path[i].is_vertex()) {
                    path[i].t = 0.5 * (path[i].t + path[j].t);
                }
                path.erase(path.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                           path.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                return true;
            }
        }
    }
    return false;
}

/// Smallest angle among the triangles p, q, corner that a cut from p to q leaves at its two ends [rad].
double cut_angle(const RouteSpace& space, const PathPoint& p, const PathPoint& q)
{
    const int face = common_face(space, p, q);
    if (face < 0) {
        return std::numbers::pi;
    }
    const Vec3 a = p.position(space.mesh), b = q.position(space.mesh);
    double smallest = std::numbers::pi;
    for (int k = 0; k < 3; ++k) {
        const Vec3 corner = space.mesh.V.row(space.mesh.F(face, k));
        const Vec3 to_a = a - corner, to_b = b - corner, along = b - a;
        const double area = to_a.cross(to_b).norm();
        if (area <= 1e-12 * along.squaredNorm()) {
            continue; // the corner is an end of the cut
        }
        smallest = std::min({smallest, std::atan2(area, to_a.dot(to_b)), std::atan2(area, -to_a.dot(along)),
                             std::atan2(area, to_b.dot(along))});
    }
    return smallest;
}

/// Nearer end of the edge that holds the point; sets the distance to it as a fraction of the edge.
int nearer_end(const PathPoint& p, double& fraction)
{
    fraction = std::min(p.t, 1 - p.t);
    return p.t <= 0.5 ? p.a : p.b;
}

/// Snaps the first point that asks for it; false when none does.
bool snap_one(const RouteSpace& space, Path& path)
{
    for (size_t i = 1; i + 1 < path.size(); ++i) {
        if (path[i].is_vertex()) {
            continue;
        }
        double fraction = 0;
        const int end = nearer_end(path[i], fraction);
        if (space.blocked[end]) {
            path[i].t = std::clamp(path[i].t, clearance, 1 - clearance);
            continue;
        }
        const bool thin =
            fraction < thin_snap_fraction &&
            std::min(cut_angle(space, path[i - 1], path[i]), cut_angle(space, path[i], path[i + 1])) < thin_angle;
        if (fraction <= snap_fraction || thin) {
            path[i] = {end, -1, 0};
            return true;
        }
    }
    return false;
}

} // namespace

void tidy_path(const RouteSpace& space, Path& path)
{
    for (bool changed = true; changed;) {
        changed = cut_loop(path);
        for (size_t i = 1; i + 1 < path.size();) {
            if (superfluous(space, path, i)) {
                path.erase(path.begin() + static_cast<std::ptrdiff_t>(i));
                changed = true;
            } else {
                ++i;
            }
        }
    }
}

void snap_path(const RouteSpace& space, Path& path)
{
    while (snap_one(space, path)) {
        tidy_path(space, path);
    }
}

} // namespace tapeline
