// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension_route.h"
#include "kernel/region.h"

#include <vector>

namespace tapeline {

/// The region as the extension sees it: its border loops, the line in it, other feature lines, inner constraints.
class ExtensionSpace {
public:
    /// `mesh` must outlive the space.
    ExtensionSpace(const Mesh& mesh, const Region& region);

    const Mesh& mesh() const { return mesh_; }
    /// The vertex is on the region's border (rim or open border).
    bool on_rim(int v) const { return loop_[v] >= 0; }
    /// Number of the border loop through v; -1 = inside the region or off it.
    int loop_of(int v) const { return loop_[v]; }
    int longest_loop() const { return longest_loop_; }
    /// The mesh edge a–b exists and has region triangles on both sides.
    bool edge_inside(int a, int b) const;

    /// Sets the line that ways must not meet, end to end. Rejected when neighbours are not joined inside the region,
    /// when a vertex repeats, or when the line touches the rim other than at its ends.
    Result<void> set_line(std::vector<int> line);
    /// The line's last (or first) vertex, and the directions there.
    RouteStart start(bool at_back) const;

    /// What a way from `from` must not meet. `taken`: the way from the line's other end (may be empty).
    RouteSpace routes(int from, const std::vector<PathPoint>& taken, bool clear_of_features) const;
    /// Border loops per vertex as goals: without the line's ends and the goal of `taken`.
    std::vector<int> goal_loops(const std::vector<PathPoint>& taken) const;
    /// The way passes a vertex or edge of another feature line after its start.
    bool meets_feature(const std::vector<PathPoint>& way) const;

private:
    void label_loops();
    void find_features();

    const Mesh& mesh_;
    const Region& region_;
    Topology topology_;
    std::vector<char> in_region_; ///< per triangle
    std::vector<int> loop_;       ///< per vertex
    int longest_loop_ = -1;
    std::vector<int> line_;
    std::vector<VertexPair> line_edges_, features_; ///< ascending
    std::vector<char> feature_vertex_;
};

} // namespace tapeline
