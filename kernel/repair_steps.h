// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/repair.h"

#include <span>
#include <vector>

namespace tapeline {

/// A triangle at an edge. `forward`: it runs from the edge's lower to its higher vertex.
struct EdgeSide {
    int face = -1;
    int corner = -1; ///< the edge joins this corner to the next one
    bool forward = true;
};

/// `Topology` with all triangles of every edge, in ascending order, also where there are more than two.
class EdgeSides {
public:
    EdgeSides(const Triangles& F, int vertex_count);

    const Topology& topology() const { return topology_; }
    std::span<const EdgeSide> sides(int edge) const
    {
        return {sides_.data() + start_[edge], static_cast<std::size_t>(start_[edge + 1] - start_[edge])};
    }
    /// Turns a triangle's sides round after its last two corners were swapped. The topology keeps the old left and
    /// right, and the old order of the triangle's edges.
    void flip(int face);

private:
    Topology topology_;
    std::vector<int> start_;
    std::vector<EdgeSide> sides_;
};

/// The steps of `repair_mesh`, one source file each; numbers as there.

/// 1. Removes from mesh.F and source_face; true when something went.
bool remove_repeated_corners(RepairedMesh& work);
bool remove_duplicates(RepairedMesh& work, const EdgeSides& sides);

/// 2. Returns true when edges were joined (mesh.F then names other vertices).
bool sew_borders(RepairedMesh& work, const EdgeSides& sides);

/// 3. Orients; returns the component of each triangle.
std::vector<int> orient_components(RepairedMesh& work, EdgeSides& sides);

/// 4 and 5. Appends vertices and changes mesh.F; true when something was split.
bool split_apart(RepairedMesh& work, const EdgeSides& sides, const std::vector<int>& component);

/// "edge 12-57 at (1, 2, 3) mm", with the middle of the edge.
std::string edge_place(const Mesh& mesh, int a, int b);

} // namespace tapeline
