// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/rim.h"

#include "kernel/crease_edges.h"

#include <algorithm>

namespace tapeline {

std::vector<int> tilting_rim(const Model& model, const Region& region, RimControl control, double crease_angle)
{
    if (control != RimControl::automatic) {
        return control == RimControl::position ? region.fixed_rim : std::vector<int>{};
    }
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    std::vector<char> inside(model.mesh.F.rows(), 0);
    for (const int t : region.faces) {
        inside[t] = 1;
    }
    const std::vector<CreaseLevel> creases = crease_edges(model, topology, crease_angle, crease_angle);
    std::vector<int> tilting;
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        const bool left = edge.left >= 0 && inside[edge.left], right = edge.right >= 0 && inside[edge.right];
        if (left != right && (edge.face_count != 2 || creases[e] != CreaseLevel::none)) {
            tilting.push_back(edge.a);
            tilting.push_back(edge.b);
        }
    }
    std::ranges::sort(tilting);
    tilting.erase(std::unique(tilting.begin(), tilting.end()), tilting.end());
    std::erase_if(tilting, [&](int v) { return !std::ranges::binary_search(region.fixed_rim, v); });
    return tilting;
}

} // namespace tapeline
