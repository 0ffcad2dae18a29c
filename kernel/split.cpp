// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/split.h"

#include "kernel/topology.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace tapeline {

namespace {

constexpr int outside = -1, unreached = 0;

/// Pairs of neighbouring vertices of L̂0, the closing one included.
std::vector<std::pair<int, int>> segments(const ExtendedLine& line)
{
    std::vector<std::pair<int, int>> result;
    const size_t n = line.vertices.size();
    for (size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
        result.emplace_back(line.vertices[i], line.vertices[(i + 1) % n]);
    }
    return result;
}

/// Spreads label `mark` over the region from the given triangles without crossing cut edges. Returns a triangle that
/// already bears another mark and is reached all the same, or -1.
int flood(const Topology& topology, const std::set<int>& cut, std::vector<int> front, int mark, std::vector<int>& label)
{
    int conflict = -1;
    for (size_t i = 0; i < front.size(); ++i) {
        if (label[front[i]] == unreached) {
            label[front[i]] = mark;
        }
    }
    while (!front.empty()) {
        const int t = front.back();
        front.pop_back();
        if (label[t] != mark) {
            conflict = t;
            continue;
        }
        for (const int e : topology.face_edges(t)) {
            const int next = cut.contains(e) ? -1 : topology.face_across(t, e);
            if (next < 0 || label[next] == outside || label[next] == mark) {
                continue;
            }
            if (label[next] != unreached) {
                conflict = next;
                continue;
            }
            label[next] = mark;
            front.push_back(next);
        }
    }
    return conflict;
}

/// Outside triangles within `rings` vertex rings of the side's rim, ascending.
std::vector<int> ring_outside(const Topology& topology, const Triangles& F, const std::vector<char>& in_region,
                              std::vector<int> front, int rings)
{
    std::set<int> faces;
    std::set<int> seen(front.begin(), front.end());
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<int> next;
        for (const int v : front) {
            for (const int t : topology.vertex_faces(v)) {
                if (in_region[t] || !faces.insert(t).second) {
                    continue;
                }
                for (int k = 0; k < 3; ++k) {
                    if (seen.insert(F(t, k)).second) {
                        next.push_back(F(t, k));
                    }
                }
            }
        }
        front = std::move(next);
    }
    return {faces.begin(), faces.end()};
}

/// The side made of the given region triangles (ascending) and the clamp rings beyond its rim.
SideMesh make_side(const ExtendedLine& extended, const Topology& topology, const std::vector<int>& faces,
                   const std::vector<char>& in_region, int clamp_rings)
{
    const Mesh& mesh = extended.model.mesh;
    const Region& region = extended.region;
    std::vector<char> immobile(mesh.V.rows(), 0), in_side(mesh.V.rows(), 0);
    for (const int t : faces) {
        for (int k = 0; k < 3; ++k) {
            in_side[mesh.F(t, k)] = 1;
        }
    }
    std::vector<int> rim;
    for (const int v : region.fixed_rim) {
        immobile[v] = 1;
        if (in_side[v]) {
            rim.push_back(v);
        }
    }
    for (const int v : region.inner_fixed) {
        immobile[v] = 1;
    }

    SideMesh side;
    side.inner_faces = static_cast<int>(faces.size());
    side.global_faces = faces;
    for (const int t : ring_outside(topology, mesh.F, in_region, rim, clamp_rings)) {
        // A triangle without area bends nothing and would only spoil the numbers.
        const double diagonal = bounding_diagonal(mesh.V);
        if (triangle_area(mesh, t) > 1e-12 * diagonal * diagonal) {
            side.global_faces.push_back(t);
        }
    }
    std::vector<int> local(mesh.V.rows(), -1);
    for (const int t : side.global_faces) {
        for (int k = 0; k < 3; ++k) {
            local[mesh.F(t, k)] = 0;
        }
    }
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (local[v] == 0) {
            local[v] = static_cast<int>(side.to_global.size());
            side.to_global.push_back(v);
        }
    }
    side.mesh.V.resize(static_cast<Eigen::Index>(side.to_global.size()), 3);
    for (size_t i = 0; i < side.to_global.size(); ++i) {
        side.mesh.V.row(static_cast<Eigen::Index>(i)) = mesh.V.row(side.to_global[i]);
    }
    side.mesh.F.resize(static_cast<Eigen::Index>(side.global_faces.size()), 3);
    for (size_t t = 0; t < side.global_faces.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            side.mesh.F(static_cast<Eigen::Index>(t), k) = local[mesh.F(side.global_faces[t], k)];
        }
    }
    std::vector<char> on_line(side.to_global.size(), 0);
    for (const int v : extended.vertices) {
        side.line.push_back(local[v]);
        on_line[local[v]] = 1;
    }
    for (size_t i = 0; i < side.to_global.size(); ++i) {
        const int v = side.to_global[i];
        if (!on_line[i] && (immobile[v] || !in_side[v])) {
            side.fixed.push_back(static_cast<int>(i));
        }
    }
    return side;
}

/// Those of the edges that lie inside the side, as local pairs.
std::vector<VertexPair> edges_in_side(const SideMesh& side, const Topology& topology,
                                      const std::vector<VertexPair>& features)
{
    const auto in_side = [&](int t) { return t >= 0 && std::ranges::binary_search(side.own_faces(), t); };
    const auto local = [&](int v) {
        return static_cast<int>(std::ranges::lower_bound(side.to_global, v) - side.to_global.begin());
    };
    std::vector<VertexPair> inside;
    for (const VertexPair& feature : features) {
        const int e = topology.find_edge(feature[0], feature[1]);
        if (e >= 0 && in_side(topology.edge(e).left) && in_side(topology.edge(e).right)) {
            inside.push_back({local(feature[0]), local(feature[1])});
        }
    }
    return inside;
}

std::vector<char> region_flags(const ExtendedLine& extended)
{
    std::vector<char> flags(extended.model.mesh.F.rows(), 0);
    for (const int t : extended.region.faces) {
        flags[t] = 1;
    }
    return flags;
}

} // namespace

Result<std::array<SideMesh, 2>> split_along(const ExtendedLine& extended, int clamp_rings)
{
    const Mesh& mesh = extended.model.mesh;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const std::vector<char> in_region = region_flags(extended);
    std::vector<int> label(mesh.F.rows(), outside);
    for (const int t : extended.region.faces) {
        label[t] = unreached;
    }
    std::set<int> cut;
    std::array<std::vector<int>, 2> seeds;
    for (const auto& [a, b] : segments(extended)) {
        const int e = topology.find_edge(a, b);
        if (e < 0) {
            return fail(ErrorKind::rejected,
                        fmt::format("the line's vertices {} and {} are not joined by an edge", a, b));
        }
        cut.insert(e);
        const int left = topology.face_left_of(a, b), right = topology.face_left_of(b, a);
        if (left >= 0 && in_region[left]) {
            seeds[0].push_back(left);
        }
        if (right >= 0 && in_region[right]) {
            seeds[1].push_back(right);
        }
    }
    for (int s = 0; s < 2; ++s) {
        if (seeds[s].empty()) {
            return fail(ErrorKind::rejected,
                        fmt::format("the region has no triangles {} of the line: the line runs along "
                                    "the region's border, choose a region on both sides of it",
                                    s == 0 ? "left" : "right"));
        }
        const int conflict = flood(topology, cut, seeds[s], s + 1, label);
        if (conflict >= 0) {
            const Vec3 p = mesh.V.row(mesh.F(conflict, 0));
            return fail(
                ErrorKind::rejected,
                fmt::format("the line does not part the region in two: both sides meet at ({:.6g}, {:.6g}, {:.6g}) "
                            "mm, round a hole or a second opening; choose a smaller region (--roi-distance)",
                            p.x(), p.y(), p.z()));
        }
    }
    std::array<SideMesh, 2> sides;
    for (int s = 0; s < 2; ++s) {
        std::vector<int> faces;
        for (const int t : extended.region.faces) {
            if (label[t] == s + 1) {
                faces.push_back(t);
            }
        }
        sides[s] = make_side(extended, topology, faces, in_region, clamp_rings);
        sides[s].features = edges_in_side(sides[s], topology, extended.features);
        sides[s].kept = edges_in_side(sides[s], topology, extended.region.kept_edges);
    }
    return sides;
}

SideMesh whole_region(const ExtendedLine& extended, int clamp_rings)
{
    const Mesh& mesh = extended.model.mesh;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    return make_side(extended, topology, extended.region.faces, region_flags(extended), clamp_rings);
}

void sew(const SideMesh& side, const Positions& side_positions, Positions& model_positions)
{
    std::vector<char> keep(side.to_global.size(), 0);
    for (const int v : side.fixed) {
        keep[v] = 1;
    }
    for (size_t i = 0; i < side.to_global.size(); ++i) {
        if (!keep[i]) {
            model_positions.row(side.to_global[i]) = side_positions.row(static_cast<Eigen::Index>(i));
        }
    }
}

} // namespace tapeline
