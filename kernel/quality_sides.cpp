// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/quality.h"
#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
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

namespace {

/// Per entry of the line the side that its displacement runs into; `usual` where it clearly runs into neither.
std::vector<LineSide> compressed_along(const Mesh& rest, const Topology& topology, const std::vector<int>& line,
                                       bool closed, const std::vector<Vec3>& displacements, LineSide usual)
{
    std::vector<std::array<double, 2>> into(line.size(), {0, 0}); // displacement into the left and the right side [mm]
    const size_t edges = line.size() - (closed ? 0 : 1);
    for (size_t k = 0; k < edges; ++k) {
        const size_t next = (k + 1) % line.size();
        const int a = line[k], b = line[next];
        const Vec3 direction = (rest.V.row(b) - rest.V.row(a)).normalized();
        const std::array<int, 2> beside = {topology.face_left_of(a, b), topology.face_left_of(b, a)};
        for (int s = 0; s < 2; ++s) {
            if (beside[s] >= 0) {
                const Vec3 conormal = (s == 0 ? 1 : -1) * triangle_normal(rest, beside[s]).cross(direction);
                into[k][s] += 0.5 * displacements[k].dot(conormal);
                into[next][s] += 0.5 * displacements[next].dot(conormal);
            }
        }
    }
    double largest = 0;
    for (const Vec3& u : displacements) {
        largest = std::max(largest, u.norm());
    }
    const int other = 1 - static_cast<int>(usual);
    std::vector<LineSide> side(line.size(), usual);
    for (size_t k = 0; k < line.size(); ++k) {
        if (into[k][other] > 0.02 * largest && into[k][other] > into[k][1 - other]) {
            side[k] = static_cast<LineSide>(other);
        }
    }
    return side;
}

} // namespace

StrainedParts strained_parts(const Mesh& rest, const std::pair<std::vector<int>, std::vector<int>>& sides,
                             const std::vector<int>& line, bool closed, const std::vector<Vec3>& displacements,
                             LineSide compressed)
{
    return strained_parts(rest, Topology(rest.F, static_cast<int>(rest.V.rows())), sides, line, closed, displacements,
                          compressed);
}

StrainedParts strained_parts(const Mesh& rest, const Topology& topology,
                             const std::pair<std::vector<int>, std::vector<int>>& sides, const std::vector<int>& line,
                             bool closed, const std::vector<Vec3>& displacements, LineSide compressed)
{
    const bool left = compressed == LineSide::left;
    StrainedParts parts{left ? sides.first : sides.second, left ? sides.second : sides.first};
    const std::vector<LineSide> along = compressed_along(rest, topology, line, closed, displacements, compressed);
    if (std::ranges::all_of(along, [&](LineSide s) { return s == compressed; })) {
        return parts;
    }
    std::vector<char> usual(rest.F.rows(), 1);
    const auto follows_usual = [&](int t) {
        const Vec3 centre = (rest.V.row(rest.F(t, 0)) + rest.V.row(rest.F(t, 1)) + rest.V.row(rest.F(t, 2))) / 3;
        const auto nearest =
            std::ranges::min_element(line, {}, [&](int v) { return (Vec3(rest.V.row(v)) - centre).squaredNorm(); });
        return along[nearest - line.begin()] == compressed;
    };
    const auto take_swapped = [&](std::vector<int>& part) {
        parallel_for(static_cast<int>(part.size()), [&](int i) { usual[part[i]] = follows_usual(part[i]); });
        const auto swapped = std::stable_partition(part.begin(), part.end(), [&](int t) { return usual[t] != 0; });
        std::vector<int> taken(swapped, part.end());
        part.erase(swapped, part.end());
        return taken;
    };
    const std::vector<int> to_tension = take_swapped(parts.compressed);
    const std::vector<int> to_compressed = take_swapped(parts.tension);
    std::ranges::copy(to_compressed, std::back_inserter(parts.compressed));
    std::ranges::copy(to_tension, std::back_inserter(parts.tension));
    std::ranges::sort(parts.compressed);
    std::ranges::sort(parts.tension);
    return parts;
}

} // namespace tapeline
