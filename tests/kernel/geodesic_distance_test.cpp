// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geodesic_distance.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::vector<double> distances(const Mesh& mesh, const std::vector<int>& from)
{
    std::vector<DistanceSeed> seeds;
    for (const int v : from) {
        seeds.push_back({v, 0, mesh.V.row(v)});
    }
    return geodesic_distance(mesh, Topology(mesh.F, static_cast<int>(mesh.V.rows())), seeds);
}

double flat(double, double) { return 0; }

} // namespace

TEST(GeodesicDistance, OfAPointOnAPlaneIsExactForAnyTriangles)
{
    // Square cells, cells ten times as long as wide in both directions, and a sheared grid of slivers.
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        for (const auto& [nx, ny] : {std::pair{40, 40}, {200, 20}, {20, 200}}) {
            const Mesh mesh = grid(nx, ny, -1, 1, -1, 1, flat, diagonals);
            const int centre = ny / 2 * (nx + 1) + nx / 2;
            const auto distance = distances(mesh, {centre});
            for (int v = 0; v < mesh.V.rows(); ++v) {
                const double exact = (mesh.V.row(v) - mesh.V.row(centre)).norm();
                ASSERT_NEAR(distance[v], exact, 1e-4 * exact) << nx << " x " << ny << " vertex " << v;
            }
        }
    }
}

TEST(GeodesicDistance, OfASegmentOnAPlaneIsExactBesideItAndRoundItsEnds)
{
    const Mesh mesh = grid(40, 40, -1, 1, -1, 1, flat);
    std::vector<int> segment;
    for (int i = 10; i <= 30; ++i) {
        segment.push_back(20 * 41 + i);
    }
    const auto distance = distances(mesh, segment);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const double beyond = std::max(0.0, std::abs(mesh.V(v, 0)) - 0.5);
        ASSERT_NEAR(distance[v], std::hypot(beyond, mesh.V(v, 1)), 1e-3) << v;
    }
}

TEST(GeodesicDistance, IsNotNegativeInTheObtuseCornerOfABorder)
{
    // A cap whose long edge is a border: nothing can be unfolded there, and its ends have sources of their own.
    Mesh cap{Positions(3, 3), Triangles(1, 3)};
    cap.V << 0, 0, 0, 28, 0, 0, -49.6, 1.3, 0;
    cap.F << 0, 1, 2;
    const Vec3 beside = cap.V.row(1) + 6.36 * (cap.V.row(2) - cap.V.row(1)).normalized();
    const auto distance = geodesic_distance(cap, Topology(cap.F, 3), {{1, 6.36, beside}, {2, 0, cap.V.row(2)}});
    EXPECT_GE(distance[0], 0.9 * beside.norm());
}

TEST(GeodesicDistance, OnAConeIsThatOfTheUnrolledCone)
{
    const double half_angle = 0.5;
    const Mesh mesh = cone(120, 60, half_angle);
    const int from = 30 * 120;
    const Vec3 p = mesh.V.row(from);
    const auto distance = distances(mesh, {from});
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const double r = mesh.V.row(v).norm(), r0 = p.norm();
        const double unrolled =
            std::remainder(std::atan2(mesh.V(v, 1), mesh.V(v, 0)), 2 * std::numbers::pi) * std::sin(half_angle);
        const double exact = std::sqrt(r * r + r0 * r0 - 2 * r * r0 * std::cos(unrolled));
        ASSERT_NEAR(distance[v], exact, 0.005 * exact + 1e-9) << v;
    }
}

TEST(GeodesicDistance, OverARidgeIsThatOfTheUnfoldedSides)
{
    const Mesh mesh = flat_roof(40, 20);
    const int from = 4 * 41 + 20; // on one side, 600 mm from the ridge in plan
    const auto distance = distances(mesh, {from});
    const double stretch = std::sqrt(1 + 0.3 * 0.3);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const double exact = std::hypot(mesh.V(v, 0) - mesh.V(from, 0), stretch * (mesh.V(v, 1) - mesh.V(from, 1)));
        ASSERT_NEAR(distance[v], exact, 0.002 * exact + 1e-9) << v;
    }
}

TEST(GeodesicDistance, EndsAtTheLimitAndDoesNotCrossGaps)
{
    Mesh mesh = grid(10, 10, 0, 10, 0, 10, flat);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const auto distance = geodesic_distance(mesh, topology, {{0, 0, mesh.V.row(0)}}, 3.5);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        EXPECT_EQ(std::isfinite(distance[v]), mesh.V.row(v).norm() <= 3.5) << v;
    }
    const Triangles all = mesh.F;
    mesh.F = all.topRows(20); // the lowest row of cells only
    EXPECT_TRUE(std::isinf(distances(mesh, {0}).back()));
}
