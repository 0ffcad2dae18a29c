// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension_route.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace tapeline {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 midpoint(const Mesh& mesh, const MeshEdge& edge)
{
    return 0.5 * (Vec3(mesh.V.row(edge.a)) + Vec3(mesh.V.row(edge.b)));
}

/// Edge of triangle t opposite to vertex v.
int opposite_edge(const RouteSpace& space, int t, int v)
{
    for (int k = 0; k < 3; ++k) {
        if (space.mesh.F(t, k) == v) {
            return space.topology.face_edges(t)[(k + 1) % 3];
        }
    }
    return -1;
}

} // namespace

bool RouteSpace::is_wall(int edge) const
{
    const MeshEdge& e = topology.edge(edge);
    return e.face_count != 2 || std::binary_search(walls.begin(), walls.end(), VertexPair{e.a, e.b});
}

std::vector<int> RouteSpace::faces_at(const PathPoint& point) const
{
    std::vector<int> faces;
    const auto add = [&](int t) {
        if (t >= 0 && allowed[t]) {
            faces.push_back(t);
        }
    };
    if (point.is_vertex()) {
        for (const int t : topology.vertex_faces(point.a)) {
            add(t);
        }
    } else {
        const MeshEdge& edge = topology.edge(topology.find_edge(point.a, point.b));
        add(edge.left);
        add(edge.right);
    }
    return faces;
}

Corridor::Corridor(const RouteSpace& space, int from)
{
    const Mesh& mesh = space.mesh;
    const Topology& topology = space.topology;
    edge_.assign(topology.edge_count(), {infinity});
    arrival_.assign(topology.vertex_count(), {infinity});
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto arrive = [&](int v, const Vec3& at, double before, int face, int edge) {
        const double distance = before + (Vec3(mesh.V.row(v)) - at).norm();
        if (distance < arrival_[v].distance) {
            arrival_[v] = {distance, face, edge};
        }
    };
    const auto relax = [&](int e, const Vec3& at, double before, int face, int edge) {
        const double distance = before + (midpoint(mesh, topology.edge(e)) - at).norm();
        if (!space.is_wall(e) && distance < edge_[e].distance) {
            edge_[e] = {distance, face, edge};
            queue.emplace(distance, e);
        }
    };
    const Vec3 start = mesh.V.row(from);
    for (const int t : space.faces_at({from})) {
        for (int k = 0; k < 3; ++k) {
            arrive(mesh.F(t, k), start, 0, t, -1);
        }
        relax(opposite_edge(space, t, from), start, 0, t, -1);
    }
    while (!queue.empty()) {
        const auto [distance, e] = queue.top();
        queue.pop();
        if (distance > edge_[e].distance) {
            continue;
        }
        const MeshEdge& edge = topology.edge(e);
        const int t = edge.left == edge_[e].face ? edge.right : edge.left;
        if (!space.allowed[t]) {
            continue;
        }
        const Vec3 at = midpoint(mesh, edge);
        for (int k = 0; k < 3; ++k) {
            const int corner = mesh.F(t, k), other = topology.face_edges(t)[k];
            if (corner != edge.a && corner != edge.b) {
                arrive(corner, at, distance, t, e);
            }
            if (other != e) {
                relax(other, at, distance, t, e);
            }
        }
    }
}

std::vector<int> Corridor::faces(int vertex) const
{
    std::vector<int> faces;
    const Stop* stop = &arrival_[vertex];
    while (stop->face >= 0) {
        faces.push_back(stop->face);
        if (stop->edge < 0) {
            break;
        }
        stop = &edge_[stop->edge];
    }
    return faces;
}

std::vector<RouteGoal> rank_goals(const RouteSpace& space, const Corridor& corridor, const RouteStart& start,
                                  const std::vector<int>& loop, int wanted_loop)
{
    // At this angle off the plane a way counts double; ways to another border loop count tenfold.
    constexpr double doubling_angle = 15 * std::numbers::pi / 180;
    constexpr double other_loop = 10;
    const Vec3 from = space.mesh.V.row(start.vertex);
    struct Ranked {
        RouteGoal goal;
        double sideways;
    };
    std::vector<Ranked> ranked;
    for (int v = 0; v < static_cast<int>(loop.size()); ++v) {
        if (loop[v] < 0 || !std::isfinite(corridor.distance(v)) || v == start.vertex) {
            continue;
        }
        const Vec3 d = Vec3(space.mesh.V.row(v)) - from;
        const double sideways = d.dot(start.side);
        const double angle = std::atan2(std::abs(sideways), d.dot(start.forward)) / doubling_angle;
        // The corridor's length is coarse: up to a fifth over the straight distance counts as straight.
        double cost = std::max(d.norm(), corridor.distance(v) / 1.2) * (1 + angle * angle);
        cost *= wanted_loop >= 0 && loop[v] != wanted_loop ? other_loop : 1;
        ranked.push_back({{v, cost}, sideways});
    }
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& l, const Ranked& r) { return l.goal.cost < r.goal.cost; });
    // Rounding must not decide between mirror images: of equally good first choices take the one to the left.
    size_t ties = 1;
    while (ties < ranked.size() && ranked[ties].goal.cost < ranked[0].goal.cost * (1 + 1e-9)) {
        ++ties;
    }
    if (!ranked.empty()) {
        std::stable_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(ties),
                         [](const Ranked& l, const Ranked& r) { return l.sideways > r.sideways; });
    }
    std::vector<RouteGoal> goals;
    for (const Ranked& r : ranked) {
        goals.push_back(r.goal);
    }
    return goals;
}

} // namespace tapeline
