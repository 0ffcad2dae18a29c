// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh_parts.h"
#include "tests/support/shapes.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

Topology topology_of(const Mesh& mesh) { return {mesh.F, static_cast<int>(mesh.V.rows())}; }

std::vector<VertexPair> pairs_along(const std::vector<int>& line)
{
    std::vector<VertexPair> pairs;
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        pairs.push_back(vertex_pair(line[i], line[i + 1]));
    }
    return pairs;
}

} // namespace

TEST(MeshParts, AWallAcrossTheWholeMeshLeavesOnePartOnEitherSide)
{
    const Mesh mesh = crease_panel(6, 4);
    const std::vector<int> part = mesh_parts(topology_of(mesh), pairs_along(crease_panel_line(6, 4)));
    ASSERT_EQ(static_cast<int>(part.size()), mesh.F.rows());
    EXPECT_EQ(part.front(), 0);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const double y = (mesh.V(mesh.F(t, 0), 1) + mesh.V(mesh.F(t, 1), 1) + mesh.V(mesh.F(t, 2), 1)) / 3;
        EXPECT_EQ(part[t], y < 0 ? 0 : 1);
    }
}

TEST(MeshParts, AWallWithAGapPartsNothing)
{
    const Mesh mesh = crease_panel(6, 4);
    std::vector<VertexPair> walls = pairs_along(crease_panel_line(6, 4));
    walls.erase(walls.begin() + 2);
    for (const int p : mesh_parts(topology_of(mesh), walls)) {
        EXPECT_EQ(p, 0);
    }
}

TEST(MeshParts, TrianglesThatTouchAtAVertexOrAtAnEdgeOfThreeAreApart)
{
    Mesh mesh;
    mesh.V = Positions::Zero(7, 3);
    mesh.F.resize(4, 3);
    mesh.F << 0, 1, 2, 1, 0, 3, 0, 1, 4, 4, 5, 6; // three on the edge 0-1, and one that touches at vertex 4
    EXPECT_EQ(mesh_parts(topology_of(mesh)), (std::vector<int>{0, 1, 2, 3}));
}
