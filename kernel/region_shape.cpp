// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/region_shape.h"

#include "kernel/geodesic_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>

namespace tapeline {

namespace {

constexpr double pocket_share = 0.01;
constexpr int filling_rounds = 8;
constexpr int all_rounds = 40;

bool ordinary(const MeshEdge& edge) { return edge.face_count == 2 && edge.left >= 0 && edge.right >= 0; }

/// Outside triangles whose existing neighbours are all inside, and small outside pockets beside the region, join.
void fill(const Mesh& mesh, const Topology& topology, FaceSet& inside)
{
    double area = 0;
    for (int t = 0; t < topology.face_count(); ++t) {
        area += inside[t] ? triangle_area(mesh, t) : 0;
    }
    FaceSet seen = inside;
    std::vector<int> pocket;
    for (int start = 0; start < topology.face_count(); ++start) {
        if (seen[start]) {
            continue;
        }
        // Flood the outside part that `start` belongs to; large parts are walked once and left alone.
        pocket.assign(1, start);
        seen[start] = 1;
        double pocket_area = 0;
        bool beside = false;
        for (size_t k = 0; k < pocket.size(); ++k) {
            pocket_area += triangle_area(mesh, pocket[k]);
            for (const int e : topology.face_edges(pocket[k])) {
                const int next = ordinary(topology.edge(e)) ? topology.face_across(pocket[k], e) : -1;
                if (next >= 0 && inside[next]) {
                    beside = true;
                } else if (next >= 0 && !seen[next]) {
                    seen[next] = 1;
                    pocket.push_back(next);
                }
            }
        }
        if (beside && (pocket.size() == 1 || pocket_area <= pocket_share * area)) {
            for (const int t : pocket) {
                inside[t] = 1;
            }
        }
    }
}

/// Groups the region's triangles around v that are joined by edges at v.
std::vector<std::vector<int>> fans_at(const Topology& topology, const FaceSet& inside, int v)
{
    std::vector<int> faces;
    for (const int t : topology.vertex_faces(v)) {
        if (inside[t]) {
            faces.push_back(t);
        }
    }
    std::vector<std::vector<int>> fans;
    std::vector<char> taken(faces.size(), 0);
    for (size_t i = 0; i < faces.size(); ++i) {
        if (taken[i]) {
            continue;
        }
        std::vector<int> fan{faces[i]};
        taken[i] = 1;
        for (size_t k = 0; k < fan.size(); ++k) {
            for (const int e : topology.face_edges(fan[k])) {
                const MeshEdge& edge = topology.edge(e);
                if ((edge.a != v && edge.b != v) || !ordinary(edge)) {
                    continue;
                }
                const auto next = std::ranges::find(faces, topology.face_across(fan[k], e));
                if (next != faces.end() && !taken[next - faces.begin()]) {
                    taken[next - faces.begin()] = 1;
                    fan.push_back(*next);
                }
            }
        }
        fans.push_back(std::move(fan));
    }
    return fans;
}

/// One round of repairs at pinched vertices; true when something changed.
bool unpinch(const Mesh& mesh, const Topology& topology, FaceSet& inside, const std::vector<int>& keep, bool by_filling)
{
    bool changed = false;
    for (int v = 0; v < topology.vertex_count(); ++v) {
        const auto fans = fans_at(topology, inside, v);
        if (fans.size() < 2) {
            continue;
        }
        if (by_filling) {
            for (const int t : topology.vertex_faces(v)) {
                changed = changed || !inside[t];
                inside[t] = 1;
            }
            continue;
        }
        const auto kept = [&](const std::vector<int>& fan) {
            return std::ranges::any_of(fan, [&](int t) { return std::ranges::binary_search(keep, t); });
        };
        const auto area = [&](const std::vector<int>& fan) {
            return std::accumulate(fan.begin(), fan.end(), 0.0,
                                   [&](double sum, int t) { return sum + triangle_area(mesh, t); });
        };
        const bool some_kept = std::ranges::any_of(fans, kept);
        const auto largest = std::ranges::max_element(fans, {}, area);
        for (auto fan = fans.begin(); fan != fans.end(); ++fan) {
            if (some_kept ? kept(*fan) : fan == largest) {
                continue;
            }
            for (const int t : *fan) {
                inside[t] = 0;
            }
            changed = true;
        }
    }
    return changed;
}

int find_root(std::vector<int>& parent, int v)
{
    while (parent[v] != v) {
        v = parent[v] = parent[parent[v]];
    }
    return v;
}

} // namespace

std::vector<double> band_distance(const Mesh& mesh, const Topology& topology, const FeatureLine& line,
                                  const std::vector<MeshFoot>& feet)
{
    std::vector<DistanceSeed> seeds;
    for (const int v : line.vertices) {
        seeds.push_back({v, 0, mesh.V.row(v)});
    }
    for (const MeshFoot& foot : feet) {
        for (int k = 0; k < 3 && foot.face >= 0; ++k) {
            const int v = mesh.F(foot.face, k);
            seeds.push_back({v, (Vec3(mesh.V.row(v)) - foot.point).norm(), foot.point});
        }
    }
    return geodesic_distance(mesh, topology, seeds);
}

std::vector<int> faces_along(const Topology& topology, const FeatureLine& line)
{
    std::vector<int> faces;
    const size_t n = line.vertices.size();
    for (size_t i = 0; i + 1 < n + (line.closed ? 1 : 0); ++i) {
        const int e = topology.find_edge(line.vertices[i], line.vertices[(i + 1) % n]);
        for (const int t : {topology.edge(e).left, topology.edge(e).right}) {
            if (t >= 0) {
                faces.push_back(t);
            }
        }
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

FaceSet connected_part(const Topology& topology, const FaceSet& inside, const std::vector<int>& starts,
                       const std::vector<char>& barrier)
{
    FaceSet part(inside.size(), 0);
    std::vector<int> queue;
    for (const int t : starts) {
        if (inside[t] && !part[t]) {
            part[t] = 1;
            queue.push_back(t);
        }
    }
    for (size_t k = 0; k < queue.size(); ++k) {
        for (const int e : topology.face_edges(queue[k])) {
            if (!ordinary(topology.edge(e)) || (!barrier.empty() && barrier[e])) {
                continue;
            }
            const int next = topology.face_across(queue[k], e);
            if (inside[next] && !part[next]) {
                part[next] = 1;
                queue.push_back(next);
            }
        }
    }
    return part;
}

FaceSet tidy(const Mesh& mesh, const Topology& topology, FaceSet inside, const std::vector<int>& keep)
{
    inside = connected_part(topology, inside, keep);
    fill(mesh, topology, inside);
    for (int round = 0; round < all_rounds; ++round) {
        if (!unpinch(mesh, topology, inside, keep, round < filling_rounds) && round >= filling_rounds) {
            break;
        }
        inside = connected_part(topology, inside, keep);
    }
    return inside;
}

RegionShape shape_of(const Mesh& mesh, const Topology& topology, const FaceSet& inside)
{
    RegionShape shape;
    std::vector<char> used(topology.vertex_count(), 0);
    std::vector<int> parent(topology.vertex_count());
    std::iota(parent.begin(), parent.end(), 0);
    std::vector<int> border_edges;
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        const int count =
            (edge.left >= 0 && inside[edge.left] ? 1 : 0) + (edge.right >= 0 && inside[edge.right] ? 1 : 0);
        if (count == 0) {
            continue;
        }
        --shape.euler;
        used[edge.a] = used[edge.b] = 1;
        if (count == 1) {
            border_edges.push_back(e);
            parent[find_root(parent, edge.a)] = find_root(parent, edge.b);
        }
    }
    shape.euler += static_cast<int>(std::ranges::count(used, 1)) + static_cast<int>(std::ranges::count(inside, 1));
    struct Loop {
        std::vector<int> vertices;
        double length = 0;
    };
    std::map<int, Loop> loops;
    for (const int e : border_edges) {
        const MeshEdge& edge = topology.edge(e);
        Loop& loop = loops[find_root(parent, edge.a)];
        loop.vertices.insert(loop.vertices.end(), {edge.a, edge.b});
        loop.length += (mesh.V.row(edge.a) - mesh.V.row(edge.b)).norm();
    }
    std::vector<Loop> sorted;
    for (auto& [root, loop] : loops) {
        std::ranges::sort(loop.vertices);
        loop.vertices.erase(std::unique(loop.vertices.begin(), loop.vertices.end()), loop.vertices.end());
        sorted.push_back(std::move(loop));
    }
    std::ranges::sort(sorted, [](const Loop& l, const Loop& r) {
        return l.length != r.length ? l.length > r.length : l.vertices < r.vertices;
    });
    for (Loop& loop : sorted) {
        shape.openings.push_back(std::move(loop.vertices));
    }
    return shape;
}

} // namespace tapeline
