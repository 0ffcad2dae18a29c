// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/topology.h"
#include "tests/support/shapes.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

TEST(Topology, OfAGridHasEulerCharacteristicOne)
{
    const Mesh mesh = crease_panel(6, 4);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    EXPECT_EQ(topology.vertex_count() - topology.edge_count() + topology.face_count(), 1);
}

TEST(Topology, FindsTheTriangleLeftOfADirectedEdge)
{
    const Mesh mesh = crease_panel(6, 4);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const auto line = crease_panel_line(6, 4);
    const int left = topology.face_left_of(line[2], line[3]);
    const int right = topology.face_left_of(line[3], line[2]);
    ASSERT_GE(left, 0);
    ASSERT_GE(right, 0);
    // Seen from +z along +x, left is +y.
    const auto mean_y = [&](int t) {
        return (mesh.V(mesh.F(t, 0), 1) + mesh.V(mesh.F(t, 1), 1) + mesh.V(mesh.F(t, 2), 1)) / 3;
    };
    EXPECT_GT(mean_y(left), 0);
    EXPECT_LT(mean_y(right), 0);
    EXPECT_EQ(topology.face_across(left, topology.find_edge(line[2], line[3])), right);
}
