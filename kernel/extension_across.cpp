// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension_route.h"
#include "kernel/extension_tidy.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace tapeline {

namespace {

using Path = std::vector<PathPoint>;

/// Allowed triangles within `rings` vertex rings around the given ones, ascending.
std::vector<int> grown(const RouteSpace& space, std::vector<int> faces, int rings)
{
    std::sort(faces.begin(), faces.end());
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<int> vertices;
        for (const int t : faces) {
            for (int k = 0; k < 3; ++k) {
                vertices.push_back(space.mesh.F(t, k));
            }
        }
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        for (const int v : vertices) {
            const std::vector<int> around = space.faces_at({v});
            faces.insert(faces.end(), around.begin(), around.end());
        }
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    return faces;
}

/// The geodesic in a band of triangles around the corridor; the band follows the path until it no longer shortens.
Result<Path> geodesic_in_band(const RouteSpace& space, const std::vector<int>& corridor, int from, int to)
{
    constexpr int rings = 2, max_passes = 12;
    Result<Path> best = geodesic_path(space.mesh, grown(space, corridor, rings), from, to, space.walls);
    for (int pass = 0; pass < max_passes && best; ++pass) {
        std::vector<int> around;
        for (const PathPoint& p : *best) {
            const std::vector<int> faces = space.faces_at(p);
            around.insert(around.end(), faces.begin(), faces.end());
        }
        Result<Path> next = geodesic_path(space.mesh, grown(space, around, rings), from, to, space.walls);
        if (!next || path_length(space.mesh, *next) > path_length(space.mesh, *best) * (1 - 1e-9)) {
            break;
        }
        best = std::move(next);
    }
    return best;
}

/// Other ends of the edges at v that separate the triangles at `before` from those at `after`, the shorter way round,
/// without crossing walls; empty optional when there is no such way.
std::optional<std::vector<int>> edges_around(const RouteSpace& space, int v, const PathPoint& before,
                                             const PathPoint& after)
{
    const auto at_v = [&](const PathPoint& p) {
        std::vector<int> faces = space.faces_at(p);
        std::erase_if(faces, [&](int t) { return (space.mesh.F.row(t).array() != v).all(); });
        return faces;
    };
    const std::vector<int> goals = at_v(after);
    std::map<int, std::array<int, 2>> reached; // triangle -> {triangle before, other end of the edge crossed}
    std::vector<int> queue = at_v(before);
    for (const int t : queue) {
        reached[t] = {-1, -1};
    }
    for (size_t i = 0; i < queue.size(); ++i) {
        const int t = queue[i];
        if (std::find(goals.begin(), goals.end(), t) != goals.end()) {
            std::vector<int> ends;
            for (int at = t; reached[at][0] >= 0; at = reached[at][0]) {
                ends.insert(ends.begin(), reached[at][1]);
            }
            return ends;
        }
        for (const int e : space.topology.face_edges(t)) {
            const MeshEdge& edge = space.topology.edge(e);
            if ((edge.a != v && edge.b != v) || space.is_wall(e)) {
                continue;
            }
            const int next = space.topology.face_across(t, e);
            if (space.allowed[next] &&
                reached.try_emplace(next, std::array{t, space.topology.other_end(e, v)}).second) {
                queue.push_back(next);
            }
        }
    }
    return std::nullopt;
}

/// Leads the path past the blocked vertices that it bends around, at a quarter of the edges there.
Result<Path> around_blocked(const RouteSpace& space, const Path& path)
{
    constexpr double clearance = 0.25;
    Path out{path.front()};
    for (size_t i = 1; i + 1 < path.size(); ++i) {
        const int v = path[i].a;
        if (!path[i].is_vertex() || !space.blocked[v]) {
            out.push_back(path[i]);
            continue;
        }
        const auto ends = edges_around(space, v, out.back(), path[i + 1]);
        if (!ends) {
            return fail(ErrorKind::rejected, fmt::format("the extension cannot pass vertex {}", v));
        }
        for (const int end : *ends) {
            out.push_back(v < end ? PathPoint{v, end, clearance} : PathPoint{end, v, 1 - clearance});
        }
    }
    out.push_back(path.back());
    return out;
}

} // namespace

Result<Path> route_across(const RouteSpace& space, const Corridor& corridor, int from, int to)
{
    const std::vector<int> faces = corridor.faces(to);
    if (faces.empty()) {
        return fail(ErrorKind::rejected, fmt::format("no way from vertex {} to rim vertex {}", from, to));
    }
    Result<Path> path = geodesic_in_band(space, faces, from, to);
    if (path) {
        path = around_blocked(space, *path);
    }
    if (!path) {
        return path;
    }
    tidy_path(space, *path);
    snap_path(space, *path);
    for (size_t i = 1; i + 1 < path->size(); ++i) {
        const PathPoint& p = (*path)[i];
        if (p.is_vertex() && space.blocked[p.a]) {
            return fail(ErrorKind::rejected, fmt::format("the extension would run through vertex {}", p.a));
        }
    }
    return path;
}

} // namespace tapeline
