// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <array>
#include <span>
#include <vector>

namespace tapeline {

/// An undirected mesh edge, a < b. `left` is the triangle that runs a→b, `right` the one that runs b→a; -1 = none.
struct MeshEdge {
    int a = -1;
    int b = -1;
    int left = -1;
    int right = -1;
    int face_count = 0; ///< 1 border, 2 interior, more: non-manifold (left/right then hold the first ones met)

    bool border() const { return face_count == 1; }
};

/// Connectivity of a triangle mesh: edges in ascending (a, b) order, and what touches what. Immutable, index based,
/// independent of vertex positions. Copes with non-manifold input; callers ask `face_count`.
class Topology {
public:
    /// Builds from triangle indices; every index must be in [0, vertex_count).
    Topology(const Triangles& F, int vertex_count);

    int vertex_count() const { return static_cast<int>(vertex_face_start_.size()) - 1; }
    int edge_count() const { return static_cast<int>(edges_.size()); }
    int face_count() const { return static_cast<int>(face_edges_.size()); }

    const MeshEdge& edge(int e) const { return edges_[e]; }
    std::span<const MeshEdge> edges() const { return edges_; }

    /// Index of the edge between two vertices in either order; -1 when they are not joined.
    int find_edge(int a, int b) const;

    /// Triangle in which the directed edge from→to runs counter-clockwise (it lies to the left of the direction,
    /// seen from outside); -1 when there is none.
    int face_left_of(int from, int to) const;

    /// The edges of triangle t: entry k joins corners k and (k+1)%3.
    const std::array<int, 3>& face_edges(int t) const { return face_edges_[t]; }

    /// The triangle across edge e from triangle t; -1 on a border.
    int face_across(int t, int e) const;

    std::span<const int> vertex_faces(int v) const;
    std::span<const int> vertex_edges(int v) const;
    /// The vertex at the other end of edge e.
    int other_end(int e, int v) const { return edges_[e].a == v ? edges_[e].b : edges_[e].a; }
    /// True when some edge at v is a border edge.
    bool border_vertex(int v) const;

private:
    std::vector<MeshEdge> edges_;
    std::vector<std::array<int, 3>> face_edges_;
    std::vector<int> vertex_face_start_, vertex_faces_;
    std::vector<int> vertex_edge_start_, vertex_edges_;
};

} // namespace tapeline
