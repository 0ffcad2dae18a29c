// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/feature_lines.h"
#include "tests/support/files.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// A height field that is a ridge z = -slope(x) |y| along y = 0, 40 × 20 cells on [0, 400] × [-100, 100].
Mesh ridge(const std::function<double(double)>& slope)
{
    return grid(40, 20, 0, 400, -100, 100, [&](double x, double y) { return -slope(x) * std::abs(y); });
}

/// Lines as point sequences that do not depend on direction or start: every edge's two points, sorted, per line.
std::set<std::vector<std::vector<double>>> as_points(const Mesh& mesh, const std::vector<FeatureLine>& lines)
{
    std::set<std::vector<std::vector<double>>> set;
    for (const FeatureLine& line : lines) {
        std::vector<std::vector<double>> edges;
        const size_t n = line.vertices.size();
        for (size_t i = 0; i + 1 < n + (line.closed ? 1 : 0); ++i) {
            std::vector<double> p(mesh.V.row(line.vertices[i]).begin(), mesh.V.row(line.vertices[i]).end());
            std::vector<double> q(mesh.V.row(line.vertices[(i + 1) % n]).begin(),
                                  mesh.V.row(line.vertices[(i + 1) % n]).end());
            if (q < p) {
                std::swap(p, q);
            }
            p.insert(p.end(), q.begin(), q.end());
            edges.push_back(p);
        }
        std::ranges::sort(edges);
        set.insert(edges);
    }
    return set;
}

} // namespace

TEST(CreaseAngle, IsTheAngleBetweenTheTwoFlatSidesOfARoof)
{
    const Mesh mesh = flat_roof(8, 4);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const int ridge_edge = topology.find_edge(2 * 9 + 3, 2 * 9 + 4);
    EXPECT_NEAR(crease_angle(mesh, topology, ridge_edge), 2 * std::atan(0.3) * degrees, 1e-10);
    EXPECT_EQ(crease_angle(mesh, topology, topology.find_edge(0, 1)), 0) << "a border has no crease angle";
}

TEST(FeatureLines, OfACubeAreItsTwelveEdges)
{
    const Model model = model_of(cube(5));
    const auto lines = find_feature_lines(model);
    ASSERT_EQ(lines.size(), 12U);
    for (const FeatureLine& line : lines) {
        EXPECT_FALSE(line.closed);
        EXPECT_EQ(line.vertices.size(), 6U);
        EXPECT_NEAR(line.length_mm, 2, 1e-12);
        EXPECT_NEAR(line.crease_angle_min, 90, 1e-9);
        EXPECT_NEAR(line.crease_angle_max, 90, 1e-9);
        EXPECT_LT(line.vertices.front(), line.vertices.back());
    }
}

TEST(FeatureLines, OfEqualLengthAreOrderedByTheirSmallestVertex)
{
    const auto lines = find_feature_lines(model_of(cube(4)));
    for (size_t i = 0; i + 1 < lines.size(); ++i) {
        EXPECT_LE(std::ranges::min(lines[i].vertices), std::ranges::min(lines[i + 1].vertices));
        EXPECT_EQ(lines[i].id, static_cast<int>(i));
    }
}

TEST(FeatureLines, OfACylinderAreItsTwoCirclesHoweverCoarseItsWall)
{
    for (const int segments : {12, 18, 36, 72}) {
        const Model model = model_of(cylinder(segments, 6, 10, 30));
        const auto lines = find_feature_lines(model);
        ASSERT_EQ(lines.size(), 2U) << segments;
        for (const FeatureLine& line : lines) {
            EXPECT_TRUE(line.closed);
            EXPECT_EQ(static_cast<int>(line.vertices.size()), segments);
            EXPECT_NEAR(line.length_mm, 2 * 10 * segments * std::sin(std::numbers::pi / segments), 1e-9);
            EXPECT_EQ(line.vertices.front(), std::ranges::min(line.vertices));
            EXPECT_LT(line.vertices[1], line.vertices.back());
        }
    }
}

TEST(FeatureLines, AreNotFoundOnACoarseSphere)
{
    for (const int slices : {12, 18, 36}) {
        EXPECT_TRUE(find_feature_lines(model_of(ball(slices))).empty()) << slices;
    }
}

TEST(FeatureLines, OfTheCreasePanelIsItsCreaseOnAnyTriangulation)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const auto lines = find_feature_lines(model_of(crease_panel(60, 40, diagonals)));
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].vertices, crease_panel_line(60, 40));
        EXPECT_NEAR(lines[0].crease_angle_mean, 12, 0.5);
    }
}

TEST(FeatureLines, StartAtTheHighThresholdAndGoOnAtTheLowOne)
{
    // The ridge's angle falls from 20 degrees at x = 0 to 0 at x = 400.
    const auto slope = [](double x) { return std::tan((20 - x / 20) / 2 / degrees); };
    const Model model = model_of(ridge(slope));
    const auto end_of = [&](double high, double low) {
        FeatureLineOptions options;
        options.crease_angle = high;
        options.crease_angle_low = low;
        const auto lines = find_feature_lines(model, options);
        return lines.empty() ? 0.0 : model.mesh.V(lines.front().vertices.back(), 0);
    };
    EXPECT_NEAR(end_of(10, 5), 300, 10);
    EXPECT_NEAR(end_of(10, 10), 200, 10);
    EXPECT_EQ(end_of(25, 5), 0);
}

TEST(FeatureLines, PassStraightThroughACrossing)
{
    const Model model = model_of(
        grid(20, 20, -100, 100, -100, 100, [](double x, double y) { return -0.3 * std::abs(x) - 0.3 * std::abs(y); }));
    const auto lines = find_feature_lines(model);
    ASSERT_EQ(lines.size(), 2U);
    for (const FeatureLine& line : lines) {
        ASSERT_EQ(line.vertices.size(), 21U);
        const Vec3 chord = model.mesh.V.row(line.vertices.back()) - model.mesh.V.row(line.vertices.front());
        EXPECT_NEAR(chord.norm(), 200, 1e-9) << "the line turned off at the crossing";
    }
}

TEST(FeatureLines, HoldEachCreaseEdgeExactlyOnceAndNoVertexTwice)
{
    const Model model = model_of(cube(4));
    FeatureLineOptions options;
    options.max_turn = 95; // lets lines turn round the cube's corners
    const auto lines = find_feature_lines(model, options);
    std::set<std::pair<int, int>> edges;
    for (const FeatureLine& line : lines) {
        EXPECT_EQ(std::set(line.vertices.begin(), line.vertices.end()).size(), line.vertices.size());
        for (size_t i = 0; i + 1 < line.vertices.size() + (line.closed ? 1 : 0); ++i) {
            const auto edge = std::minmax(line.vertices[i], line.vertices[(i + 1) % line.vertices.size()]);
            EXPECT_TRUE(edges.insert(edge).second);
        }
    }
    EXPECT_EQ(edges.size(), 48U);
    EXPECT_LT(lines.size(), 12U);
}

TEST(FeatureLines, ShorterThanTheLimitsAreDropped)
{
    const Model model = model_of(cube(2));
    EXPECT_TRUE(find_feature_lines(model).empty());
    FeatureLineOptions options;
    options.min_edges = 2;
    EXPECT_EQ(find_feature_lines(model, options).size(), 12U);
    options.min_length_mm = 2.5;
    EXPECT_TRUE(find_feature_lines(model, options).empty());
}

TEST(FeatureLines, AreTheSamePointsWhenTheMeshIsRenumbered)
{
    for (const Mesh& mesh : {cube(4), cylinder(24, 5, 10, 30), crease_panel(30, 20, Diagonals::random)}) {
        const Mesh other = renumbered(mesh, 99);
        const auto lines = find_feature_lines(model_of(mesh)), others = find_feature_lines(model_of(other));
        EXPECT_EQ(lines.size(), others.size());
        EXPECT_EQ(as_points(mesh, lines), as_points(other, others));
    }
}

TEST(FeatureLines, OfTheFandiskHoldItsLongCrease)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto lines = find_feature_lines(model_of(plain_off(*data / "models/fandisk_pmp.off")));
    const auto found = std::ranges::find_if(lines, [](const FeatureLine& line) {
        return std::ranges::count(line.vertices, 25) == 1 && std::ranges::count(line.vertices, 1279) == 1;
    });
    ASSERT_NE(found, lines.end());
    const auto from = std::ranges::find(found->vertices, 25), to = std::ranges::find(found->vertices, 1279);
    EXPECT_EQ(std::abs(to - from), 58);
}

TEST(FeatureLines, OfTheRookAreClosedCircles)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const Mesh mesh = plain_stl(*data / "models/rook.stl");
    const auto lines = find_feature_lines(model_of(mesh));
    ASSERT_GE(lines.size(), 4U);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(lines[i].closed);
        std::vector<double> radii;
        for (const int v : lines[i].vertices) {
            radii.push_back(std::hypot(mesh.V(v, 0), mesh.V(v, 1)));
        }
        EXPECT_NEAR(std::ranges::min(radii), std::ranges::max(radii), 1e-4 * radii.front());
    }
}
