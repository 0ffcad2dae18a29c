// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/repair_steps.h"

#include <fmt/format.h>

namespace tapeline {

namespace {

struct Component {
    std::vector<int> faces; ///< in the order met
    int reversed = 0;       ///< how many of them run against the first one
    int conflict_edge = -1; ///< an edge where the two ways round disagree: the component is one-sided
};

/// Collects the triangles that hang together with `seed` across edges with exactly two triangles, and in `reversed`
/// whether each would have to be turned to agree with the seed.
Component flood(const EdgeSides& sides, int seed, int number, std::vector<int>& component, std::vector<char>& reversed)
{
    Component result;
    result.faces.push_back(seed);
    component[seed] = number;
    for (std::size_t i = 0; i < result.faces.size(); ++i) {
        const int face = result.faces[i];
        result.reversed += reversed[face];
        for (const int edge : sides.topology().face_edges(face)) {
            const auto around = sides.sides(edge);
            if (around.size() != 2) {
                continue;
            }
            const int other = around[0].face == face ? around[1].face : around[0].face;
            const bool agree = around[0].forward != around[1].forward;
            const char wanted = agree ? reversed[face] : !reversed[face];
            if (component[other] < 0) {
                component[other] = number;
                reversed[other] = wanted;
                result.faces.push_back(other);
            } else if (reversed[other] != wanted && result.conflict_edge < 0) {
                result.conflict_edge = edge;
            }
        }
    }
    return result;
}

} // namespace

std::vector<int> orient_components(RepairedMesh& work, EdgeSides& sides)
{
    Mesh& mesh = work.mesh;
    RepairReport& report = work.report;
    const int faces = static_cast<int>(mesh.F.rows());
    std::vector<int> component(faces, -1);
    std::vector<char> reversed(faces, 0);
    for (int seed = 0; seed < faces; ++seed) {
        if (component[seed] >= 0) {
            continue;
        }
        const Component found = flood(sides, seed, report.components++, component, reversed);
        if (found.conflict_edge >= 0) {
            ++report.non_orientable_components;
            const MeshEdge& edge = sides.topology().edge(found.conflict_edge);
            report.warnings.push_back(
                fmt::format("a piece of {} triangles is one-sided (like a Möbius strip), which shows at {}; a region "
                            "that touches such an edge is refused",
                            found.faces.size(), edge_place(mesh, edge.a, edge.b)));
            continue;
        }
        const bool turn_reversed = 2 * static_cast<std::size_t>(found.reversed) <= found.faces.size();
        for (const int face : found.faces) {
            if (static_cast<bool>(reversed[face]) == turn_reversed) {
                std::swap(mesh.F(face, 1), mesh.F(face, 2));
                sides.flip(face);
                ++report.flipped_faces;
            }
        }
    }
    return component;
}

} // namespace tapeline
