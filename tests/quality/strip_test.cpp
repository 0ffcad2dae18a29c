// SPDX-License-Identifier: GPL-3.0-or-later
// A narrow bend beside the line is found by its curvature and goes along with the line as a piece.
#include "kernel/strip.h"
#include "plugin/runner/measures.h"
#include "tests/support/filleted_panel.h"
#include "tests/support/moves.h"
#include "tests/support/side.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

MoveOptions with(Method method, std::optional<double> width = {})
{
    MoveOptions options;
    options.method = method;
    options.strip_width_mm = width;
    return options;
}

/// Largest relative change of an edge's length in the strip, where the strip moved.
double stretch(const FilletedPanel& panel, const Positions& moved)
{
    const Mesh& rest = panel.model.mesh;
    double largest = 0;
    for (int t = 0; t < rest.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = rest.F(t, k), b = rest.F(t, (k + 1) % 3);
            const auto inside = [&](int v) {
                return rest.V(v, 1) >= 0 && rest.V(v, 1) <= panel.width_at(rest.V(v, 0)) &&
                       std::abs(rest.V(v, 0)) < 150;
            };
            // Edges across the line: a section is rigid, along the line a curved one is longer than a straight one.
            if (inside(a) && inside(b) && std::abs(rest.V(a, 0) - rest.V(b, 0)) < 1e-9) {
                const double before = (rest.V.row(a) - rest.V.row(b)).norm();
                largest = std::max(largest, std::abs((moved.row(a) - moved.row(b)).norm() / before - 1));
            }
        }
    }
    return largest;
}

/// Largest distance to the flat floor of the compressed side's vertices beyond `from` (rest) that are not of the strip.
double off_floor(const FilletedPanel& panel, const MoveResult& move, double from)
{
    const Positions& rest = panel.model.mesh.V;
    double largest = 0;
    for (int v = 0; v < rest.rows(); ++v) {
        if (rest(v, 1) >= from) {
            largest = std::max(largest, std::abs(move.V(v, 2) - panel.floor()));
        }
    }
    return largest;
}

QualityReport measured(const MoveResult& move, const TargetCurve& target)
{
    auto quality = measure_quality(quality_input(move, target));
    if (!quality) {
        throw std::runtime_error(quality.error().message);
    }
    return *quality;
}

class StripMove : public ::testing::TestWithParam<Method> {};

} // namespace

TEST(Strip, IsFoundWithItsWidthAngleAndRadiusOnTheBentSideOnly)
{
    for (const double width : {4.0, 8.0, 15.0}) {
        const FilletedPanel panel(width);
        const Strip bend = find_strip(panel.side(panel.model.mesh.V), panel.middle, false);
        EXPECT_NEAR(bend.width_mm, width, 0.12 * width);
        EXPECT_NEAR(bend.turning, 25, 2);
        EXPECT_NEAR(bend.radius_mm, width / (25 * std::acos(-1) / 180), 0.2 * bend.radius_mm);
        EXPECT_FALSE(find_strip(panel.side(panel.model.mesh.V, false), panel.middle, false).found());
    }
}

TEST(Strip, DoesNotDependOnPlaceDirectionAndSize)
{
    const FilletedPanel panel;
    const Mesh side = panel.side(panel.model.mesh.V);
    const Strip bend = find_strip(side, panel.middle, false);
    const RigidMotion motion = some_rigid_motion();
    const Strip moved = find_strip({transformed(side.V, 10, motion.R, motion.shift), side.F}, panel.middle, false);
    EXPECT_NEAR(moved.width_mm, 10 * bend.width_mm, 1e-6);
    EXPECT_NEAR(moved.turning, bend.turning, 1e-6);
    const Strip back = find_strip(side, {panel.middle.rbegin(), panel.middle.rend()}, false);
    EXPECT_NEAR(back.width_mm, bend.width_mm, 0.02 * bend.width_mm);
    EXPECT_NEAR(back.turning, bend.turning, 0.1);
}

TEST(Strip, IsNotSeenInAnEvenlyCurvedSideOrInATightPlaceFartherAway)
{
    const auto strip_of = [](const std::function<double(double)>& height) {
        const Mesh mesh = grid(40, 200, -200, 200, -200, 200, [&](double, double y) { return height(y); });
        const std::vector<int> line = grid_row(40, 100);
        return find_strip(meshes_beside(mesh, line, false).first, line, false);
    };
    EXPECT_FALSE(strip_of([](double y) { return -std::abs(y) * 0.1 - y * y / 500; }).found());
    EXPECT_FALSE(strip_of([](double y) { return std::max(0.0, y) * 0.3; }).found());
    // The same bend right beside the line, and 20 mm away from it.
    const auto bend = [](double y) { return y < 0 ? 0 : (y < 12 ? -0.5 * (y - y * y / 24) : -3.0); };
    EXPECT_TRUE(strip_of(bend).found());
    EXPECT_FALSE(strip_of([&](double y) { return y < 20 ? -0.5 * y : -10 + bend(y - 20); }).found());
}

TEST(Strip, EndsAtSharpEdges)
{
    // A lip: a flat rim of 4 mm, a slope of 45° over 8 mm, and from there steeply down.
    Mesh lip = grid(40, 60, -200, 200, -120, 120, [](double, double) { return 0.0; });
    for (auto row : lip.V.rowwise()) {
        const double slope = std::clamp(row.y() - 4, 0.0, 8.0), wall = std::max(0.0, row.y() - 12);
        row = Eigen::RowVector3d(row.x(), row.y() - 0.9 * wall, -slope - wall);
    }
    EXPECT_FALSE(find_strip(meshes_beside(lip, grid_row(40, 30), false).first, grid_row(40, 30), false).found());
}

TEST_P(StripMove, FollowsTheWidthOfABendThatChangesAlongTheLine)
{
    for (const auto& [first, last] : {std::pair(6.0, 14.0), std::pair(15.0, 8.0)}) {
        const FilletedPanel panel(first, last);
        const Strip before = find_strip(panel.side(panel.model.mesh.V), panel.middle, false);
        ASSERT_EQ(before.widths.size(), panel.middle.size());
        for (size_t i = 0; i < panel.middle.size(); ++i) {
            const double width = panel.width_at(panel.model.mesh.V(panel.middle[i], 0));
            // At the ends, where one side has no neighbours, the fit evens out more of the change.
            const bool end = i < 2 || i + 2 >= panel.middle.size();
            EXPECT_NEAR(before.widths[i], width, (end ? 0.2 : 0.15) * width) << i;
        }
        const MoveResult carried = move_line(panel, level_slide(50), with(GetParam()));
        ASSERT_EQ(carried.placement.compressed, LineSide::left);
        const Strip after = find_strip(panel.side(carried.V), panel.middle, false);
        EXPECT_NEAR(after.turning, before.turning, 0.5);
        ASSERT_EQ(after.widths.size(), panel.middle.size());
        for (size_t i = 0; i < panel.middle.size(); ++i) {
            EXPECT_NEAR(after.widths[i], before.widths[i], 0.05 * before.widths[i]) << i;
        }
        EXPECT_LT(stretch(panel, carried.V), 2e-3);
        for (const int v : carried.strips[0].vertices) {
            const Vec3 p = panel.model.mesh.V.row(v);
            EXPECT_LT(p.y(), 1.5 * panel.width_at(p.x()));
        }
    }
}

TEST_P(StripMove, KeepsTheSectionOfABendThatTheLineRunsInto)
{
    const FilletedPanel panel;
    const ParametricCurve target = level_slide(50);
    const Strip before = find_strip(panel.side(panel.model.mesh.V), panel.middle, false);
    const MoveResult carried = move_line(panel, target, with(GetParam()));
    ASSERT_EQ(carried.placement.compressed, LineSide::left);
    const Strip after = find_strip(panel.side(carried.V), panel.middle, false);
    EXPECT_NEAR(after.width_mm, before.width_mm, 0.03 * before.width_mm);
    EXPECT_NEAR(after.turning, before.turning, 0.5);
    EXPECT_NEAR(after.radius_mm, before.radius_mm, 0.04 * before.radius_mm);
    EXPECT_LT(stretch(panel, carried.V), 2e-3);
    EXPECT_TRUE(carried.strips[0].bend.found());
    EXPECT_FALSE(carried.strips[1].bend.found());

    const MoveResult swallowed = move_line(panel, target, with(GetParam(), 0));
    const Strip rest = find_strip(panel.side(swallowed.V), panel.middle, false);
    EXPECT_TRUE(!rest.found() || rest.turning < 0.5 * before.turning);
    EXPECT_GT(stretch(panel, swallowed.V), 0.05);
    EXPECT_FALSE(swallowed.strips[0].bend.found());

    const QualityReport with_strip = measured(carried, target), without = measured(swallowed, target);
    EXPECT_LE(std::abs(with_strip.bulge_max_mm), std::abs(without.bulge_max_mm) + 1e-3);
    EXPECT_EQ(with_strip.flipped, 0);
    EXPECT_EQ(with_strip.self_intersections, 0);
    EXPECT_GE(with_strip.squash, 0.5);
    EXPECT_LT(with_strip.line_error_max_mm, 1e-9);
    EXPECT_LT(with_strip.crease_max_difference, 1.5);
}

TEST_P(StripMove, LeavesABendWhereTheRegionHasNoRoomForItAndSaysSo)
{
    FilletedPanel panel(24);
    const ParametricCurve target = level_slide(-8, -8 * std::tan(4 * std::acos(-1) / 180));
    EXPECT_TRUE(move_line(panel, target, with(GetParam())).strips[0].bend.found());
    std::vector<int> faces;
    for (int t = 0; t < panel.model.mesh.F.rows(); ++t) {
        const double y =
            (panel.model.mesh.V(panel.model.mesh.F(t, 0), 1) + panel.model.mesh.V(panel.model.mesh.F(t, 1), 1) +
             panel.model.mesh.V(panel.model.mesh.F(t, 2), 1)) /
            3;
        if (y < 50) {
            faces.push_back(t);
        }
    }
    panel.region = region_of_faces(panel.model, faces, false, {});
    const MoveResult move = move_line(panel, target, with(GetParam()));
    EXPECT_FALSE(move.strips[0].bend.found());
    EXPECT_TRUE(std::ranges::any_of(
        move.warnings, [](const std::string& w) { return w.find("a bend beside the line") != std::string::npos; }));
    EXPECT_EQ(measured(move, target).flipped, 0);
}

TEST_P(StripMove, LeavesTheCompressedSideOnTheOldSurfaceFromTheOuterEdgeOn)
{
    const FilletedPanel panel;
    const MoveResult move = move_line(panel, level_slide(50), with(GetParam()));
    EXPECT_LT(off_floor(panel, move, panel.width), 5e-3);
    EXPECT_LT(off_floor(panel, move, move.strips[0].bend.carried_mm), 1e-6);
    EXPECT_LT(move.strips[0].lift_max_mm, 1e-6);
}

TEST_P(StripMove, KeepsTheSectionOfABendThatTheLineLeavesBehind)
{
    const FilletedPanel panel;
    const ParametricCurve target = level_slide(-50, -50 * std::tan(4 * std::acos(-1) / 180));
    const Strip before = find_strip(panel.side(panel.model.mesh.V), panel.middle, false);
    const MoveResult carried = move_line(panel, target, with(GetParam()));
    ASSERT_EQ(carried.placement.compressed, LineSide::right);
    const Strip after = find_strip(panel.side(carried.V), panel.middle, false);
    EXPECT_NEAR(after.width_mm, before.width_mm, 0.03 * before.width_mm);
    EXPECT_NEAR(after.turning, before.turning, 0.5);
    const double kept = stretch(panel, carried.V);
    const double bare = stretch(panel, move_line(panel, target, with(GetParam(), 0)).V);
    EXPECT_LT(kept, 0.02);
    EXPECT_GT(bare, 0.1);
    EXPECT_EQ(measured(carried, target).flipped, 0);
}

TEST_P(StripMove, TurnsTheSectionAboutALineOnTheOldSurfaceSoThatItsEdgeRests)
{
    const FilletedPanel panel;
    const MoveResult move = move_line(panel, level_slide(50, panel.floor()), with(GetParam()));
    EXPECT_GT(move.strips[0].pivot_max, 5);
    EXPECT_LT(move.strips[0].lift_max_mm, 1e-6);
    EXPECT_LT(stretch(panel, move.V), 2e-3);
    EXPECT_LT(off_floor(panel, move, 1.5 * panel.width), 1e-3);
}

TEST_P(StripMove, IsTheIdentityForALineThatStays)
{
    const FilletedPanel panel;
    const MoveResult move = move_line(panel, level_slide(0), with(GetParam()));
    EXPECT_LT((move.V - move.rest.mesh.V).rowwise().norm().maxCoeff(), 1e-9);
}

TEST_P(StripMove, FollowsARigidMotionOfModelAndTarget)
{
    const FilletedPanel panel;
    const RigidMotion motion = some_rigid_motion();
    FilletedPanel turned = panel;
    turned.model.mesh.V = transformed(panel.model.mesh.V, 1, motion.R, motion.shift);
    const ParametricCurve target = level_slide(50);
    const MoveResult move = move_line(panel, target, with(GetParam()));
    const MoveResult other = move_line(turned, mapped(target, motion), with(GetParam()));
    ASSERT_EQ(move.V.rows(), other.V.rows());
    const Positions expected = transformed(move.V, 1, motion.R, motion.shift);
    EXPECT_LT((other.V - expected).rowwise().norm().maxCoeff(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Method, StripMove, ::testing::Values(Method::plate_fl, Method::asan_fl),
                         [](const auto& method) {
                             return method.param == Method::plate_fl ? std::string("PlateFl") : std::string("AsanFl");
                         });

TEST(Strip, IsCarriedAtAGivenWidthOnBothSides)
{
    const FilletedPanel panel;
    const MoveResult move = move_line(panel, level_slide(50), with(Method::plate_fl, 14.5));
    for (const StripReport& strip : move.strips) {
        EXPECT_EQ(strip.bend.carried_mm, 14.5);
        EXPECT_FALSE(strip.vertices.empty());
    }
    double farthest = 0;
    for (const int v : move.strips[0].vertices) {
        farthest = std::max(farthest, panel.model.mesh.V(v, 1));
    }
    EXPECT_GT(farthest, panel.width);
    EXPECT_LE(farthest, 14.5);
}

TEST(Strip, IsLeftToMethodsThatDoNotRetractAndToThePaperAsPublished)
{
    const FilletedPanel panel;
    for (const Method method : {Method::asan, Method::asan_fl_paper}) {
        const MoveResult move = move_line(panel, level_slide(20), with(method));
        EXPECT_FALSE(move.strips[0].bend.found());
    }
}
