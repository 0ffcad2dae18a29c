// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/crease_edges.h"
#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// A chain of mesh edges without branches that meets no vertex twice.
struct EdgeChain {
    std::vector<int> vertices; ///< in order; a closed chain does not repeat its first vertex
    std::vector<int> edges;    ///< edges[k] joins vertices k and k+1 (cyclically if closed)
    bool closed = false;
};

struct ChainOptions {
    double max_turn = 60; ///< edges that turn by more than this are never joined [deg]
    int min_spur = 3;     ///< weak dead ends with fewer edges that leave a junction are dropped first
};

/// Joins crease edges into chains. At every vertex the edges are paired, best pair first: edges of the same CAD edge
/// before others, then the smallest turn, then the most alike crease angles, then the smaller vertices; pairs that
/// turn by more than max_turn are not joined. So valence-2 vertices are passed, and at a junction a chain goes on along
/// its straightest continuation while each edge lies in exactly one chain. A chain that comes back to one of its own
/// vertices is cut there into a loop and the rest. Chains without a strong edge are dropped.
std::vector<EdgeChain> chain_edges(const Mesh& mesh, const Topology& topology, std::vector<CreaseLevel> level,
                                   const std::vector<int>& cad_edge, const ChainOptions& options);

} // namespace tapeline
