// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/topology.h"

#include <algorithm>
#include <tuple>

namespace tapeline {

namespace {

/// Compressed rows: item lists per key, from (key, item) pairs in item order.
void compress(const std::vector<std::pair<int, int>>& pairs, int keys, std::vector<int>& start, std::vector<int>& items)
{
    start.assign(keys + 1, 0);
    for (const auto& [key, item] : pairs) {
        ++start[key + 1];
    }
    for (int k = 0; k < keys; ++k) {
        start[k + 1] += start[k];
    }
    items.resize(pairs.size());
    std::vector<int> next(start.begin(), start.end() - 1);
    for (const auto& [key, item] : pairs) {
        items[next[key]++] = item;
    }
}

} // namespace

Topology::Topology(const Triangles& F, int vertex_count)
{
    struct Side {
        int a, b, face, corner;
        bool forward;
    };
    const int faces = static_cast<int>(F.rows());
    std::vector<Side> sides;
    sides.reserve(3 * static_cast<size_t>(faces));
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(3 * static_cast<size_t>(faces));
    for (int t = 0; t < faces; ++t) {
        for (int k = 0; k < 3; ++k) {
            const int from = F(t, k), to = F(t, (k + 1) % 3);
            sides.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
            pairs.emplace_back(from, t);
        }
    }
    compress(pairs, vertex_count, vertex_face_start_, vertex_faces_);

    std::sort(sides.begin(), sides.end(), [](const Side& l, const Side& r) {
        return std::tie(l.a, l.b, l.face, l.corner) < std::tie(r.a, r.b, r.face, r.corner);
    });
    face_edges_.assign(faces, {-1, -1, -1});
    for (const Side& side : sides) {
        if (edges_.empty() || edges_.back().a != side.a || edges_.back().b != side.b) {
            edges_.push_back({side.a, side.b, -1, -1, 0});
        }
        MeshEdge& edge = edges_.back();
        ++edge.face_count;
        int& slot = side.forward ? edge.left : edge.right;
        if (slot < 0) {
            slot = side.face;
        }
        face_edges_[side.face][side.corner] = static_cast<int>(edges_.size()) - 1;
    }

    pairs.clear();
    for (int e = 0; e < edge_count(); ++e) {
        pairs.emplace_back(edges_[e].a, e);
        pairs.emplace_back(edges_[e].b, e);
    }
    compress(pairs, vertex_count, vertex_edge_start_, vertex_edges_);
}

int Topology::find_edge(int a, int b) const
{
    const auto key = std::minmax(a, b);
    const auto it = std::lower_bound(edges_.begin(), edges_.end(), key, [](const MeshEdge& edge, const auto& k) {
        return std::tie(edge.a, edge.b) < std::tie(k.first, k.second);
    });
    const bool found = it != edges_.end() && it->a == key.first && it->b == key.second;
    return found ? static_cast<int>(it - edges_.begin()) : -1;
}

int Topology::face_left_of(int from, int to) const
{
    const int e = find_edge(from, to);
    return e < 0 ? -1 : (from < to ? edges_[e].left : edges_[e].right);
}

int Topology::face_across(int t, int e) const { return edges_[e].left == t ? edges_[e].right : edges_[e].left; }

std::span<const int> Topology::vertex_faces(int v) const
{
    return {vertex_faces_.data() + vertex_face_start_[v],
            static_cast<size_t>(vertex_face_start_[v + 1] - vertex_face_start_[v])};
}

std::span<const int> Topology::vertex_edges(int v) const
{
    return {vertex_edges_.data() + vertex_edge_start_[v],
            static_cast<size_t>(vertex_edge_start_[v + 1] - vertex_edge_start_[v])};
}

bool Topology::border_vertex(int v) const
{
    const auto around = vertex_edges(v);
    return std::any_of(around.begin(), around.end(), [this](int e) { return edges_[e].border(); });
}

} // namespace tapeline
