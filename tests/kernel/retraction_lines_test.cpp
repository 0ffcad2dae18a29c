// SPDX-License-Identifier: GPL-3.0-or-later
// Retraction on sides in which other feature lines or holes lie.
#include "kernel/feature_rails.h"
#include "kernel/retraction.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 40, ny = 40;

RetractionOptions along_y()
{
    RetractionOptions options;
    options.material.stiff_direction = Vec3::UnitY();
    return options;
}

/// The side y > 0 of a panel of 600 × 600 mm, with its other feature lines.
SideMesh side_of(const std::function<double(double, double)>& height)
{
    const Mesh mesh = grid(nx, ny, -300, 300, -300, 300, height);
    ExtendedLine extended = line_across(mesh, grid_row(nx, ny / 2));
    extended.features = other_feature_edges(extended.model, extended.vertices, false);
    auto sides = split_along(extended);
    return sides ? std::move((*sides)[0]) : SideMesh{};
}

/// A slide of the line y = 0 into the side, zero at both ends.
std::vector<Vec3> bell(const SideMesh& side, double size)
{
    std::vector<Vec3> u;
    for (const int v : side.line) {
        u.emplace_back(0, size * std::pow(std::cos(side.mesh.V(v, 0) * std::numbers::pi / 600), 2), 0);
    }
    return u;
}

/// A fold along y = 150 that falls off behind.
SideMesh side_with_fold(double slope)
{
    return side_of([=](double, double y) { return -slope * std::max(0.0, y - 150); });
}

} // namespace

TEST(Retraction, LeavesAParallelLineWhereItIsAndKeepsItsSidesApart)
{
    SideMesh side = side_with_fold(0.5);
    ASSERT_FALSE(side.features.empty());
    const auto result = retract(side, bell(side, 60), along_y());
    ASSERT_TRUE(result);
    EXPECT_EQ(result->flipped, 0);
    EXPECT_GT(squash(side, result->V, Vec3::UnitX()), 0.95 * (1 - 60.0 / 150));
    double moved_off_the_line = 0;
    for (int v = 0; v < side.mesh.V.rows(); ++v) {
        const Vec3 p = side.mesh.V.row(v), q = result->V.row(v);
        if (p.y() == 150) {
            moved_off_the_line = std::max({moved_off_the_line, std::abs(q.y() - 150), std::abs(q.z())});
        } else {
            EXPECT_EQ(p.y() < 150, q.y() < 150) << p.transpose();
        }
    }
    EXPECT_LT(moved_off_the_line, 1e-9);
    // Taken for a smooth surface, the fold is dragged along: the lines matter.
    side.features.clear();
    const auto dragged = retract(side, bell(side, 60), along_y());
    ASSERT_TRUE(dragged);
    double dragged_by = 0;
    for (int v = 0; v < side.mesh.V.rows(); ++v) {
        dragged_by = std::max(dragged_by, side.mesh.V(v, 1) == 150 ? dragged->V(v, 1) - 150 : 0);
    }
    EXPECT_GT(dragged_by, 5);
}

TEST(Retraction, SlidesALineThatRunsTheSameWayAlongItself)
{
    // The moving line steps over a ridge along x = 0.
    const SideMesh side = side_of([](double x, double) { return -0.5 * std::abs(x); });
    ASSERT_FALSE(side.features.empty());
    const auto result = retract(side, bell(side, 100), along_y());
    ASSERT_TRUE(result);
    EXPECT_EQ(result->flipped, 0);
    EXPECT_GT(result->min_area_ratio, 0.6);
    double last = -1;
    for (int v = 0; v < side.mesh.V.rows(); ++v) {
        if (side.mesh.V(v, 0) == 0) {
            EXPECT_NEAR(result->V(v, 0), 0, 1e-9);
            EXPECT_NEAR(result->V(v, 2), 0, 1e-9);
            EXPECT_GT(result->V(v, 1), last);
            last = result->V(v, 1);
        }
    }
    EXPECT_NEAR(result->V(side.line[nx / 2], 1), 100, 1e-9);
}

TEST(Retraction, RefusesATargetBeyondASharpLineAndDragsASoftOneAlong)
{
    const SideMesh sharp = side_with_fold(1.0);
    const auto refused = retract(sharp, bell(sharp, 200), along_y());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::rejected);
    EXPECT_NE(refused.error().message.find("crosses another feature line"), std::string::npos)
        << refused.error().message;
    const SideMesh soft = side_with_fold(0.25);
    ASSERT_FALSE(soft.features.empty());
    const auto dragged = retract(soft, bell(soft, 200), along_y());
    ASSERT_TRUE(dragged) << dragged.error().message;
    EXPECT_EQ(dragged->flipped, 0);
}

TEST(Retraction, PassesAHoleWithAFreeBorderWithoutFolding)
{
    // A round hole of radius 60 with its centre 150 mm before the line; the line slides by 45 of the 90 mm between.
    const auto in_hole = [](double x, double y) { return std::hypot(x, y - 150) < 60; };
    const Mesh mesh = grid(nx, ny, -300, 300, -300, 300, [](double, double) { return 0.0; });
    ExtendedLine extended = line_across(mesh, grid_row(nx, ny / 2), false,
                                        [&](const Vec3& centre) { return !in_hole(centre.x(), centre.y()); });
    std::erase_if(extended.region.fixed_rim, [&](int v) { return std::hypot(mesh.V(v, 0), mesh.V(v, 1) - 150) < 80; });
    const auto sides = split_along(extended);
    ASSERT_TRUE(sides);
    const SideMesh& side = (*sides)[0];
    const auto result = retract(side, bell(side, 45), along_y());
    ASSERT_TRUE(result);
    EXPECT_EQ(result->flipped, 0);
    EXPECT_GT(squash(side, result->V, Vec3::UnitX()), 0.4);
    // The hole keeps its outline: its border's corners stay.
    for (int v = 0; v < side.mesh.V.rows(); ++v) {
        if (std::hypot(side.mesh.V(v, 0), side.mesh.V(v, 1) - 150) < 62) {
            EXPECT_LT((result->V.row(v) - side.mesh.V.row(v)).norm(), 20);
        }
    }
}

TEST(FeatureRails, LeadAlongTheirPolylineToItsEndsAndStopAtCorners)
{
    // Along row 2 of a grid from x = 0 to 30, then up column 3.
    const Mesh mesh = grid(4, 4, 0, 40, 0, 40, [](double, double) { return 0.0; });
    const auto at = [](int i, int j) { return 5 * j + i; };
    std::vector<VertexPair> edges;
    for (int i = 0; i < 3; ++i) {
        edges.push_back({at(i, 2), at(i + 1, 2)});
        edges.push_back({at(3, i % 2 + 2), at(3, i % 2 + 3)});
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const FeatureRails rails(mesh, edges, std::vector<char>(25, 0));
    EXPECT_TRUE(rails.slides(at(1, 2)));
    EXPECT_TRUE(rails.corner(at(3, 2)));
    EXPECT_FALSE(rails.slides(at(0, 2)));
    EXPECT_NEAR(std::abs(rails.tangent(at(1, 2)).x()), 1, 1e-15);
    const double sense = rails.tangent(at(1, 2)).x();
    EXPECT_LT((rails.along(at(1, 2), 14 * sense) - Vec3(24, 20, 0)).norm(), 1e-12);
    EXPECT_LT((rails.along(at(1, 2), 99 * sense) - Vec3(30, 20, 0)).norm(), 1e-12);
    EXPECT_LT((rails.along(at(1, 2), -99 * sense) - Vec3(0, 20, 0)).norm(), 1e-12);
    ASSERT_EQ(rails.pieces(at(3, 2)).size(), 2U);
    EXPECT_NEAR(rails.pieces(at(3, 2))[0].length(), 30, 1e-12);
    const RailFoot foot = nearest_on(rails.pieces(at(3, 2))[0], Vec3(12, 3, 7));
    EXPECT_LT((foot.point - Vec3(12, 20, 0)).norm(), 1e-12);
    EXPECT_NEAR(foot.arc, 18, 1e-12);
}
