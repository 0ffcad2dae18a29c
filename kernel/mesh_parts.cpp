// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh_parts.h"

namespace tapeline {

std::vector<int> mesh_parts(const Topology& topology, const std::vector<VertexPair>& walls)
{
    std::vector<char> open(topology.edge_count());
    for (int e = 0; e < topology.edge_count(); ++e) {
        open[e] = topology.edge(e).face_count == 2;
    }
    for (const VertexPair& wall : walls) {
        if (const int e = topology.find_edge(wall[0], wall[1]); e >= 0) {
            open[e] = 0;
        }
    }
    std::vector<int> part(topology.face_count(), -1);
    int count = 0;
    for (int seed = 0; seed < topology.face_count(); ++seed) {
        if (part[seed] >= 0) {
            continue;
        }
        std::vector<int> front{seed};
        part[seed] = count;
        while (!front.empty()) {
            const int t = front.back();
            front.pop_back();
            for (const int e : topology.face_edges(t)) {
                const int next = open[e] ? topology.face_across(t, e) : -1;
                if (next >= 0 && part[next] < 0) {
                    part[next] = count;
                    front.push_back(next);
                }
            }
        }
        ++count;
    }
    return part;
}

} // namespace tapeline
