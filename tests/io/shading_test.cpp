// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shaders.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

TEST(CornerNormals, AreExactOnAParabolicSheetUpToItsBordersAndSplitAtItsCrease)
{
    const Mesh mesh = crease_panel(40, 30);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const auto sharp = picture::sharp_edges(mesh, topology, 10, {});
    const Positions normals = picture::corner_normals(mesh, topology, sharp);
    double worst = 0;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const double side = (mesh.V(mesh.F(t, 0), 1) + mesh.V(mesh.F(t, 1), 1) + mesh.V(mesh.F(t, 2), 1)) > 0 ? 1 : -1;
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = mesh.V.row(mesh.F(t, k));
            const Vec3 exact =
                Vec3(p.x() / 6000, p.y() / 3000 + side * std::tan(6 * std::numbers::pi / 180), 1).normalized();
            worst = std::max(worst, (Vec3(normals.row(3 * t + k)) - exact).norm());
        }
    }
    // One-sided means at the border would be off by half a cell, 10 / 3000; the sheet's four corners are the worst.
    EXPECT_LT(worst, 1.6e-3);
}

TEST(CornerNormals, AreExactOnASphereWhateverTheShapesOfItsTriangles)
{
    Mesh mesh = grid(24, 24, -1, 1, -1, 1, [](double, double) { return 0.0; });
    for (int v = 0; v < mesh.V.rows(); ++v) {
        // Rows and columns of very unequal widths, sheared: needles and caps.
        const double x = 50 * std::pow(mesh.V(v, 0), 3), y = 20 * mesh.V(v, 1) + 0.4 * x;
        mesh.V.row(v) << x, y, std::sqrt(100 * 100 - x * x - y * y);
    }
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const std::vector<char> sharp(topology.edge_count(), 0);
    const Positions normals = picture::corner_normals(mesh, topology, sharp);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.F(t, k);
            if (!topology.border_vertex(v)) {
                EXPECT_LT((normals.row(3 * t + k) - mesh.V.row(v).normalized()).norm(), 1e-9);
            }
        }
    }
}

TEST(SharpEdges, FollowACreaseUntilItHasFadedIntoTheSurface)
{
    // The slope of both flanks falls evenly from 8 degrees to nothing at x = 80.
    const double steep = std::tan(8 * std::numbers::pi / 180);
    const Mesh mesh = grid(50, 12, 0, 100, -12, 12,
                           [&](double x, double y) { return -std::abs(y) * steep * std::max(0.0, 1 - x / 80); });
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const auto sharp = picture::sharp_edges(mesh, topology, 10, {});
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        if (edge.border()) {
            continue;
        }
        const Vec3 middle = 0.5 * (mesh.V.row(edge.a) + mesh.V.row(edge.b));
        const bool on_line = mesh.V(edge.a, 1) == 0 && mesh.V(edge.b, 1) == 0;
        if (!on_line || middle.x() > 80) {
            EXPECT_FALSE(sharp[e]) << middle.transpose();
        } else if (middle.x() < 60) { // a crease of 4 degrees, far below the 10 that start one
            EXPECT_TRUE(sharp[e]) << middle.transpose();
        }
    }
}
