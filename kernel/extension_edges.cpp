// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension_route.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <queue>

namespace tapeline {

namespace {

/// The edge runs between two allowed triangles, so that a cut along it has the region on both sides.
bool inside(const RouteSpace& space, const MeshEdge& edge)
{
    return edge.face_count == 2 && edge.left >= 0 && edge.right >= 0 && space.allowed[edge.left] &&
           space.allowed[edge.right];
}

} // namespace

Result<std::vector<PathPoint>> route_along_edges(const RouteSpace& space, const RouteStart& start, int to)
{
    const Positions& V = space.mesh.V;
    const Vec3 from = V.row(start.vertex);
    const Vec3 chord = (Vec3(V.row(to)) - from).normalized();
    // Distances from the straight way count in units of the edges around the start.
    double edge_length = 0;
    const auto around = space.topology.vertex_edges(start.vertex);
    for (const int e : around) {
        edge_length += (V.row(space.topology.other_end(e, start.vertex)) - V.row(start.vertex)).norm();
    }
    edge_length /= static_cast<double>(around.size());
    const Vec3 across = chord.cross(start.forward.cross(start.side)).normalized();

    std::vector<double> cost(V.rows(), std::numeric_limits<double>::infinity());
    std::vector<int> before(V.rows(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    cost[start.vertex] = 0;
    queue.emplace(0, start.vertex);
    while (!queue.empty()) {
        const auto [distance, v] = queue.top();
        queue.pop();
        if (distance > cost[v] || v == to) {
            continue;
        }
        for (const int e : space.topology.vertex_edges(v)) {
            const int next = space.topology.other_end(e, v);
            if (!inside(space, space.topology.edge(e)) || (space.blocked[next] && next != to)) {
                continue;
            }
            const Vec3 middle = 0.5 * (V.row(v) + V.row(next));
            const double off = std::abs((middle - from).dot(across)) / edge_length;
            const double longer = distance + (V.row(next) - V.row(v)).norm() * (1 + off);
            if (longer < cost[next]) {
                cost[next] = longer;
                before[next] = v;
                queue.emplace(longer, next);
            }
        }
    }
    if (before[to] < 0) {
        return fail(ErrorKind::rejected, fmt::format("no way along mesh edges from vertex {} to rim vertex {}; use the "
                                                     "geodesic extension",
                                                     start.vertex, to));
    }
    std::vector<PathPoint> path;
    for (int v = to; v >= 0; v = before[v]) {
        path.push_back({v, -1, 0});
    }
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace tapeline
