// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_repair.h"

#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace tapeline {

namespace {

void keep_faces(Model& model, const std::vector<char>& keep)
{
    int row = 0;
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        if (keep[t]) {
            model.mesh.F.row(row) = model.mesh.F.row(t);
            if (!model.cad_face.empty()) {
                model.cad_face[row] = model.cad_face[t];
            }
            ++row;
        }
    }
    model.mesh.F.conservativeResize(row, 3);
    if (!model.cad_face.empty()) {
        model.cad_face.resize(row);
    }
}

void drop_faces(Model& model, RepairCounts& counts)
{
    const Triangles& F = model.mesh.F;
    std::vector<char> keep(F.rows(), 1);
    std::vector<std::pair<std::array<int, 3>, int>> sorted;
    for (int t = 0; t < F.rows(); ++t) {
        std::array<int, 3> corners{F(t, 0), F(t, 1), F(t, 2)};
        std::ranges::sort(corners);
        if (corners[0] == corners[1] || corners[1] == corners[2]) {
            keep[t] = 0;
            ++counts.degenerate_faces;
        } else {
            sorted.emplace_back(corners, t);
        }
    }
    std::ranges::sort(sorted);
    for (size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first == sorted[i - 1].first) {
            keep[sorted[i].second] = 0;
            ++counts.duplicate_faces;
        }
    }
    if (counts.degenerate_faces + counts.duplicate_faces > 0) {
        keep_faces(model, keep);
    }
}

/// Per mesh edge the triangles along it.
std::vector<std::vector<int>> edge_faces(const Topology& topology)
{
    std::vector<std::vector<int>> faces(topology.edge_count());
    for (int t = 0; t < topology.face_count(); ++t) {
        for (const int e : topology.face_edges(t)) {
            faces[e].push_back(t);
        }
    }
    return faces;
}

/// True when triangle t runs along edge e from its smaller to its larger vertex.
bool runs_forward(const Triangles& F, const Topology& topology, int t, int e)
{
    for (int k = 0; k < 3; ++k) {
        if (topology.face_edges(t)[k] == e) {
            return F(t, k) < F(t, (k + 1) % 3);
        }
    }
    return false;
}

struct Parts {
    std::vector<int> part;  ///< per triangle
    std::vector<char> turn; ///< per triangle: against the first triangle of its part
    int count = 0;
};

/// Parts connected over edges with exactly two triangles.
Parts find_parts(const Triangles& F, const Topology& topology, const std::vector<std::vector<int>>& along)
{
    Parts parts{std::vector<int>(F.rows(), -1), std::vector<char>(F.rows(), 0), 0};
    std::vector<int> queue;
    for (int seed = 0; seed < F.rows(); ++seed) {
        if (parts.part[seed] >= 0) {
            continue;
        }
        parts.part[seed] = parts.count;
        queue.assign(1, seed);
        for (size_t head = 0; head < queue.size(); ++head) {
            const int t = queue[head];
            for (const int e : topology.face_edges(t)) {
                if (along[e].size() != 2) {
                    continue;
                }
                const int other = along[e][0] == t ? along[e][1] : along[e][0];
                if (parts.part[other] < 0) {
                    parts.part[other] = parts.count;
                    const bool agree = runs_forward(F, topology, t, e) != runs_forward(F, topology, other, e);
                    parts.turn[other] = parts.turn[t] ^ static_cast<char>(!agree);
                    queue.push_back(other);
                }
            }
        }
        ++parts.count;
    }
    return parts;
}

void turn_face(Triangles& F, int t) { std::swap(F(t, 1), F(t, 2)); }

/// Turns the smaller share of each part.
int orient(Triangles& F, const Parts& parts)
{
    std::vector<int> turned(parts.count, 0), all(parts.count, 0);
    for (int t = 0; t < F.rows(); ++t) {
        turned[parts.part[t]] += parts.turn[t];
        ++all[parts.part[t]];
    }
    int flipped = 0;
    for (int t = 0; t < F.rows(); ++t) {
        const int p = parts.part[t];
        const bool other_share_is_smaller = 2 * turned[p] > all[p];
        if (static_cast<bool>(parts.turn[t]) != other_share_is_smaller) {
            turn_face(F, t);
            ++flipped;
        }
    }
    return flipped;
}

/// Gives each fan of triangles around a vertex, connected over edges that are not open, a vertex of its own.
void split_vertices(Model& model, const Topology& topology, const std::vector<char>& open, RepairCounts& counts)
{
    const Triangles old = model.mesh.F;
    std::vector<int> copies; // per appended vertex the original
    std::vector<int> fan, faces;
    for (int v = 0; v < topology.vertex_count(); ++v) {
        const auto around = topology.vertex_faces(v);
        faces.assign(around.begin(), around.end());
        std::ranges::sort(faces);
        std::vector<char> seen(faces.size(), 0);
        bool first = true;
        for (size_t i = 0; i < faces.size(); ++i) {
            if (seen[i]) {
                continue;
            }
            fan.assign(1, static_cast<int>(i));
            seen[i] = 1;
            for (size_t head = 0; head < fan.size(); ++head) {
                for (const int e : topology.face_edges(faces[fan[head]])) {
                    if (open[e] || (topology.edge(e).a != v && topology.edge(e).b != v)) {
                        continue;
                    }
                    for (size_t k = 0; k < faces.size(); ++k) {
                        if (!seen[k] && std::ranges::count(topology.face_edges(faces[k]), e) > 0) {
                            seen[k] = 1;
                            fan.push_back(static_cast<int>(k));
                        }
                    }
                }
            }
            if (!first) {
                const int copy = topology.vertex_count() + static_cast<int>(copies.size());
                copies.push_back(v);
                for (const int k : fan) {
                    for (int corner = 0; corner < 3; ++corner) {
                        if (old(faces[k], corner) == v) {
                            model.mesh.F(faces[k], corner) = copy;
                        }
                    }
                }
            }
            counts.non_manifold_vertices += !first;
            first = false;
        }
    }
    const int n = topology.vertex_count();
    model.mesh.V.conservativeResize(n + static_cast<int>(copies.size()), 3);
    for (size_t i = 0; i < copies.size(); ++i) {
        model.mesh.V.row(n + static_cast<int>(i)) = model.mesh.V.row(copies[i]).eval();
    }
    std::map<std::pair<int, int>, std::vector<int>> tags;
    for (const CadEdgeTag& tag : model.cad_edges) {
        tags[{tag.a, tag.b}].push_back(tag.cad_edge);
    }
    std::vector<CadEdgeTag> renewed;
    for (int t = 0; t < old.rows() && !tags.empty(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const auto found = tags.find(std::minmax(old(t, k), old(t, (k + 1) % 3)));
            if (found != tags.end()) {
                const auto [a, b] = std::minmax(model.mesh.F(t, k), model.mesh.F(t, (k + 1) % 3));
                for (const int e : found->second) {
                    renewed.push_back({a, b, e});
                }
            }
        }
    }
    std::ranges::sort(renewed);
    renewed.erase(std::unique(renewed.begin(), renewed.end()), renewed.end());
    model.cad_edges = std::move(renewed);
}

void drop_isolated(Model& model, RepairCounts& counts)
{
    std::vector<int> number(model.mesh.V.rows(), -1);
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            number[model.mesh.F(t, k)] = 0;
        }
    }
    int next = 0;
    for (size_t v = 0; v < number.size(); ++v) {
        if (number[v] == 0) {
            model.mesh.V.row(next) = model.mesh.V.row(static_cast<int>(v)).eval();
            number[v] = next++;
        }
    }
    counts.isolated_vertices = static_cast<int>(number.size()) - next;
    if (counts.isolated_vertices == 0) {
        return;
    }
    model.mesh.V.conservativeResize(next, 3);
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            model.mesh.F(t, k) = number[model.mesh.F(t, k)];
        }
    }
    std::erase_if(model.cad_edges, [&](const CadEdgeTag& tag) { return number[tag.a] < 0 || number[tag.b] < 0; });
    for (CadEdgeTag& tag : model.cad_edges) {
        tag.a = number[tag.a];
        tag.b = number[tag.b];
    }
}

} // namespace

RepairCounts repair_model(Model& model)
{
    RepairCounts counts;
    drop_faces(model, counts);
    Triangles& F = model.mesh.F;
    const Topology topology(F, static_cast<int>(model.mesh.V.rows()));
    const auto along = edge_faces(topology);
    counts.flipped_faces = orient(F, find_parts(F, topology, along));

    // Turning a triangle swaps the places of its edges: look them up anew.
    const Topology oriented(F, static_cast<int>(model.mesh.V.rows()));
    std::vector<char> open(oriented.edge_count(), 0);
    for (int e = 0; e < oriented.edge_count(); ++e) {
        const std::vector<int>& faces = along[e];
        const bool one_sided =
            faces.size() == 2 && runs_forward(F, oriented, faces[0], e) == runs_forward(F, oriented, faces[1], e);
        open[e] = one_sided || faces.size() > 2;
        counts.one_sided_edges += one_sided;
        counts.non_manifold_edges += faces.size() > 2;
    }
    split_vertices(model, oriented, open, counts);
    drop_isolated(model, counts);
    const Topology final_topology(F, static_cast<int>(model.mesh.V.rows()));
    counts.border_edges = static_cast<int>(std::ranges::count_if(final_topology.edges(), &MeshEdge::border));
    return counts;
}

int turn_outward(Model& model, const std::vector<int>& group)
{
    Triangles& F = model.mesh.F;
    const Topology topology(F, static_cast<int>(model.mesh.V.rows()));
    const auto along = edge_faces(topology);
    const Parts parts = find_parts(F, topology, along);
    const int groups = group.empty() ? 0 : *std::ranges::max_element(group) + 1;
    // What is judged as a whole: first the groups, then the parts that belong to none.
    std::vector<double> volume(std::max(groups, 0) + parts.count, 0);
    std::vector<char> closed(volume.size(), 1);
    const auto whole = [&](int t) {
        return group.empty() || group[t] < 0 ? std::max(groups, 0) + parts.part[t] : group[t];
    };
    const Vec3 origin = model.mesh.V.rows() > 0 ? Vec3(model.mesh.V.colwise().mean()) : Vec3::Zero();
    for (int t = 0; t < F.rows(); ++t) {
        const Vec3 a = Vec3(model.mesh.V.row(F(t, 0))) - origin, b = Vec3(model.mesh.V.row(F(t, 1))) - origin,
                   c = Vec3(model.mesh.V.row(F(t, 2))) - origin;
        volume[whole(t)] += a.dot(b.cross(c)) / 6;
        for (const int e : topology.face_edges(t)) {
            closed[whole(t)] &= static_cast<char>(along[e].size() == 2);
        }
    }
    int turned = 0;
    for (int t = 0; t < F.rows(); ++t) {
        if (closed[whole(t)] && volume[whole(t)] < 0) {
            turn_face(F, t);
            ++turned;
        }
    }
    return turned;
}

} // namespace tapeline
