// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/quality.h"
#include "kernel/topology.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

namespace tapeline {

std::pair<std::vector<int>, std::vector<int>> sides_of_line(const Mesh& mesh, const std::vector<int>& faces,
                                                            const std::vector<int>& line, bool closed)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    enum Side : char { outside, unreached, left, right };
    std::vector<char> side(mesh.F.rows(), outside);
    for (const int t : faces) {
        side[t] = unreached;
    }
    const auto centre = [&](int t) {
        return Vec3((mesh.V.row(mesh.F(t, 0)) + mesh.V.row(mesh.F(t, 1)) + mesh.V.row(mesh.F(t, 2))) / 3);
    };
    std::vector<char> wall(topology.edge_count(), 0);
    using Front = std::tuple<double, int, char>; // way from the line [mm], triangle, side
    std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
    const size_t edges = closed ? line.size() : line.size() - std::min<size_t>(1, line.size());
    for (size_t k = 0; k < edges; ++k) {
        const int a = line[k], b = line[(k + 1) % line.size()];
        const int e = topology.find_edge(a, b);
        if (e < 0) {
            continue;
        }
        wall[e] = 1;
        const Vec3 middle = 0.5 * (mesh.V.row(a) + mesh.V.row(b));
        for (const auto& [t, s] :
             {std::pair{topology.face_left_of(a, b), left}, {topology.face_left_of(b, a), right}}) {
            if (t >= 0) {
                front.emplace((centre(t) - middle).norm(), t, s);
            }
        }
    }
    while (!front.empty()) {
        const auto [way, t, s] = front.top();
        front.pop();
        if (side[t] != unreached) {
            continue;
        }
        side[t] = s;
        for (const int e : topology.face_edges(t)) {
            const int next = topology.face_across(t, e);
            if (!wall[e] && next >= 0 && side[next] == unreached) {
                front.emplace(way + (centre(next) - centre(t)).norm(), next, s);
            }
        }
    }
    std::pair<std::vector<int>, std::vector<int>> parts;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        if (side[t] == left) {
            parts.first.push_back(t);
        } else if (side[t] == right) {
            parts.second.push_back(t);
        }
    }
    return parts;
}

} // namespace tapeline
