// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/repair_steps.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

/// Which corners of triangles stay together at their vertex: a forest over 3·faces corners.
class CornerForest {
public:
    explicit CornerForest(int faces) : parent_(3 * static_cast<std::size_t>(faces))
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    int root(int corner)
    {
        while (parent_[corner] != corner) {
            parent_[corner] = parent_[parent_[corner]];
            corner = parent_[corner];
        }
        return corner;
    }
    /// Keeps two triangles together along an edge of both, at its lower and at its higher vertex.
    void join(const EdgeSide& l, const EdgeSide& r)
    {
        join_corners(low(l), low(r));
        join_corners(high(l), high(r));
    }

private:
    static int low(const EdgeSide& side)
    {
        return 3 * side.face + (side.forward ? side.corner : (side.corner + 1) % 3);
    }
    static int high(const EdgeSide& side)
    {
        return 3 * side.face + (side.forward ? (side.corner + 1) % 3 : side.corner);
    }
    void join_corners(int a, int b)
    {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    std::vector<int> parent_;
};

/// Joins the triangles of an edge with more than two pairwise by component, if each component has one on each hand.
bool join_in_pairs(std::span<const EdgeSide> around, const std::vector<int>& component, CornerForest& forest)
{
    std::vector<EdgeSide> sorted(around.begin(), around.end());
    std::ranges::stable_sort(sorted, {}, [&](const EdgeSide& side) { return component[side.face]; });
    if (sorted.size() % 2 != 0) {
        return false;
    }
    for (std::size_t i = 0; i < sorted.size(); i += 2) {
        const int number = component[sorted[i].face];
        const bool pair = component[sorted[i + 1].face] == number && sorted[i].forward != sorted[i + 1].forward;
        if (!pair || (i + 2 < sorted.size() && component[sorted[i + 2].face] == number)) {
            return false;
        }
    }
    for (std::size_t i = 0; i < sorted.size(); i += 2) {
        forest.join(sorted[i], sorted[i + 1]);
    }
    return true;
}

/// Gives every group of corners at a vertex but the first its own copy of the vertex. Returns the vertices copied.
std::vector<int> copy_vertices(Mesh& mesh, CornerForest& forest)
{
    std::vector<int> first_root(mesh.V.rows(), -1);
    std::vector<std::pair<int, int>> copies; // root corner, vertex
    for (int corner = 0; corner < 3 * mesh.F.rows(); ++corner) {
        if (forest.root(corner) != corner) {
            continue;
        }
        const int vertex = mesh.F(corner / 3, corner % 3);
        if (first_root[vertex] < 0) {
            first_root[vertex] = corner;
        } else {
            copies.emplace_back(corner, vertex);
        }
    }
    if (copies.empty()) {
        return {};
    }
    const int old_count = static_cast<int>(mesh.V.rows());
    mesh.V.conservativeResize(old_count + static_cast<int>(copies.size()), 3);
    std::vector<int> sources;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        mesh.V.row(old_count + static_cast<int>(i)) = mesh.V.row(copies[i].second);
        sources.push_back(copies[i].second);
    }
    for (int corner = 3 * static_cast<int>(mesh.F.rows()) - 1; corner >= 0; --corner) {
        const auto copy = std::ranges::lower_bound(copies, forest.root(corner), {}, &std::pair<int, int>::first);
        if (copy != copies.end() && copy->first == forest.root(corner)) {
            mesh.F(corner / 3, corner % 3) = old_count + static_cast<int>(copy - copies.begin());
        }
    }
    return sources;
}

} // namespace

bool split_apart(RepairedMesh& work, const EdgeSides& sides, const std::vector<int>& component)
{
    Mesh& mesh = work.mesh;
    RepairReport& report = work.report;
    CornerForest forest(static_cast<int>(mesh.F.rows()));
    std::vector<char> at_split_edge(mesh.V.rows(), 0);
    const MeshEdge* first_split = nullptr;
    int split_edges = 0;
    for (int e = 0; e < sides.topology().edge_count(); ++e) {
        const auto around = sides.sides(e);
        const MeshEdge& edge = sides.topology().edge(e);
        report.non_manifold_edges += around.size() > 2;
        if (around.size() > 2 && join_in_pairs(around, component, forest)) {
            at_split_edge[edge.a] = at_split_edge[edge.b] = 1;
            first_split = first_split ? first_split : &edge;
            ++split_edges;
            continue;
        }
        for (std::size_t i = 1; i < around.size(); ++i) {
            forest.join(around[0], around[i]);
        }
    }
    work.source_vertex = copy_vertices(mesh, forest);
    if (first_split) {
        report.warnings.push_back(
            fmt::format("{} edges where pieces of surface touch were split so that each piece has "
                        "its own, the first is {}",
                        split_edges, edge_place(mesh, first_split->a, first_split->b)));
    }
    std::vector<int> touching = work.source_vertex;
    std::ranges::sort(touching);
    touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
    std::erase_if(touching, [&](int v) { return at_split_edge[v] != 0; });
    report.non_manifold_vertices = static_cast<int>(touching.size());
    if (!touching.empty()) {
        const Vec3 p = mesh.V.row(touching.front());
        report.warnings.push_back(fmt::format("{} vertices where pieces of surface touch in a single point were split "
                                              "so that each piece has its own, the first is vertex {} at ({:.6g}, "
                                              "{:.6g}, {:.6g}) mm",
                                              report.non_manifold_vertices, touching.front(), p.x(), p.y(), p.z()));
    }
    return !work.source_vertex.empty();
}

} // namespace tapeline
