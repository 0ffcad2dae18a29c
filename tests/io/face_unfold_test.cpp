// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations that are sound in the parameter plane and folded over in space.
#include "io/face_unfold.h"
#include "io/uv_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;

namespace {

constexpr double radius = 100;

/// Facing of the flat ring's triangles, which are seen from above.
std::function<double(int, int, int)> seen_from_above(const UvTriangles& ring)
{
    return
        [&ring](int a, int b, int c) { return facing(ring.points[a], ring.points[b], ring.points[c], Vec3::UnitZ()); };
}

/// Half a flat ring in polar coordinates (u = -angle, v = radius): chords of 10° at the rim, rows of nodes at the given
/// radii, ten to a chord. Rim, innermost row and both ends are fixed.
UvTriangles half_ring(const std::vector<double>& radii)
{
    constexpr int chords = 18, finer = 10;
    UvTriangles ring;
    const auto add = [&](double share, double r, bool fixed) {
        const double angle = std::numbers::pi * share;
        ring.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
        ring.uv.emplace_back(-angle, r);
        ring.fixed.push_back(fixed);
    };
    for (int i = 0; i <= chords; ++i) {
        add(static_cast<double>(i) / chords, radius, true);
    }
    constexpr int row_length = chords * finer + 1;
    for (const double r : radii) {
        for (int j = 0; j < row_length; ++j) {
            add(static_cast<double>(j) / (row_length - 1), r, r == radii.back() || j == 0 || j == row_length - 1);
        }
    }
    const int first = chords + 1;
    for (int i = 0; i < chords; ++i) {
        for (int j = 0; j < finer; ++j) {
            const int own = j < finer / 2 ? i : i + 1, inner = first + finer * i + j;
            ring.triangles.push_back({own, inner + 1, inner});
            if (j == finer / 2 - 1) {
                ring.triangles.push_back({i, i + 1, inner + 1});
            }
        }
    }
    for (size_t row = 0; row + 1 < radii.size(); ++row) {
        for (int j = 0; j + 1 < row_length; ++j) {
            const int outer = first + static_cast<int>(row) * row_length + j, inner = outer + row_length;
            ring.triangles.push_back({outer, outer + 1, inner});
            ring.triangles.push_back({outer + 1, inner + 1, inner});
        }
    }
    return ring;
}

double area(const UvTriangles& ring)
{
    double sum = 0;
    for (const auto& [a, b, c] : ring.triangles) {
        sum += (ring.points[b] - ring.points[a]).cross(ring.points[c] - ring.points[a]).norm() / 2;
    }
    return sum;
}

/// What the polygons of rim and innermost row enclose.
double ring_area(double inner)
{
    const auto half_polygon = [](double r, int sides) {
        return sides * r * r / 2 * std::sin(std::numbers::pi / sides);
    };
    return half_polygon(radius, 18) - half_polygon(inner, 180);
}

} // namespace

TEST(FaceUnfold, TakesOutNodesBetweenAChordAndItsArc)
{
    // The chords lie 0.38 mm inside the circle in their middle: two rows of nodes are nearer to it.
    UvTriangles ring = half_ring({radius - 0.05, radius - 0.2, radius - 2, radius - 10});
    ring.facing = seen_from_above(ring);
    ASSERT_GT(area(ring), ring_area(radius - 10) + 1);
    const Unfolded result = unfold(ring);
    EXPECT_GT(result.found, 18);
    EXPECT_EQ(result.left, 0);
    // Without folds the triangles cover the ring once.
    EXPECT_NEAR(area(ring), ring_area(radius - 10), 1e-9 * area(ring));
    std::vector<char> used(ring.points.size(), 0);
    for (const auto& triangle : ring.triangles) {
        for (const int v : triangle) {
            used[v] = 1;
        }
    }
    for (size_t v = 0; v < used.size(); ++v) {
        EXPECT_TRUE(used[v] || !ring.fixed[v]) << "node " << v << " lies on an edge";
    }
    EXPECT_GT(std::ranges::count(used, 1), 18 * 10 * 2) << "the rows within stay";
}

TEST(FaceUnfold, LeavesASoundTriangulationAsItIs)
{
    UvTriangles ring = half_ring({radius - 2, radius - 10});
    ring.facing = seen_from_above(ring);
    const std::vector<std::array<int, 3>> before = ring.triangles;
    const Unfolded result = unfold(ring);
    EXPECT_EQ(result.found, 0);
    EXPECT_EQ(ring.triangles, before);
}

TEST(FaceUnfold, SaysWhatItCouldNotPutRight)
{
    UvTriangles triangle;
    triangle.points = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0)};
    triangle.uv = {{0, 0}, {1, 0}, {0, 1}};
    triangle.triangles = {{0, 1, 2}};
    triangle.fixed = {1, 1, 1};
    triangle.facing = seen_from_above(triangle);
    const Unfolded result = unfold(triangle);
    EXPECT_EQ(result.found, 1);
    EXPECT_EQ(result.left, 1);
}

TEST(FaceUnfold, CountsATriangleWithoutAreaAsSound)
{
    EXPECT_EQ(facing(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3::UnitZ()), 1);
    EXPECT_EQ(facing(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), std::nullopt), 1);
    EXPECT_NEAR(facing(Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3::UnitZ()), -1, 1e-15);
}
