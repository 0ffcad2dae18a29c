// SPDX-License-Identifier: GPL-3.0-or-later
// Linear rotation-invariant coordinates: what they must reproduce exactly, and the turns of a line's frames.
#include "kernel/baselines/linear_frames.h"
#include "tests/support/moves.h"
#include "tests/support/pull.h"
#include "tests/support/side.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::vector<Vec3> places(const Positions& V, const std::vector<int>& vertices)
{
    std::vector<Vec3> result;
    for (const int v : vertices) {
        result.push_back(V.row(v));
    }
    return result;
}

/// A quarter of a cylinder of radius 100 mm about the y axis, open along two rulings and two arcs.
Mesh quarter_pipe(int nx, int ny)
{
    Mesh mesh = grid(nx, ny, 0, 1.5, 0, 200, [](double, double) { return 0.0; });
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double angle = mesh.V(v, 0);
        mesh.V(v, 0) = 100 * std::sin(angle);
        mesh.V(v, 2) = 100 * std::cos(angle);
    }
    return mesh;
}

} // namespace

TEST(LinearFrames, ReproduceRigidMotionsOfAllConstraints)
{
    const Pull pull = off_surface_pull(12, 10, Diagonals::random);
    const RigidMotion motion = some_rigid_motion();
    const Positions moved = transformed(pull.mesh.V, 1, motion.R, motion.shift);
    const std::vector<Eigen::Matrix3d> turns(pull.constrained.size(), motion.R);
    const auto result = deform_linear_frames(pull.mesh, pull.constrained, pull.sent_to(moved), turns);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->converged);
    EXPECT_EQ(result->iterations, 1);
    EXPECT_LT(result->error_estimate_mm, 1e-9);
    EXPECT_LT(largest_difference(result->V, moved), 1e-9);
    EXPECT_LT(result->energy, 1e-12);
}

TEST(LinearFrames, TurnTheWholeMeshWhenTheLineAndItsFramesTurn)
{
    // Only the line is given, so nothing but its frames says where the sides go.
    const Mesh mesh = crease_panel(12, 10, Diagonals::random);
    const std::vector<int> line = crease_panel_line(12, 10);
    const RigidMotion motion = some_rigid_motion();
    const Positions moved = transformed(mesh.V, 1, motion.R, motion.shift);
    const std::vector<Eigen::Matrix3d> turns(line.size(), motion.R);
    const auto result = deform_linear_frames(mesh, line, moved(line, Eigen::all), turns);
    ASSERT_TRUE(result);
    EXPECT_LT(largest_difference(result->V, moved), 1e-9);
    // The line alone, a straight one, would leave the sides where they were but for its frames.
    const std::vector<Eigen::Matrix3d> still(line.size(), Eigen::Matrix3d::Identity());
    const auto unturned = deform_linear_frames(mesh, line, mesh.V(line, Eigen::all), turns);
    const auto nothing = deform_linear_frames(mesh, line, mesh.V(line, Eigen::all), still);
    ASSERT_TRUE(unturned && nothing);
    EXPECT_GT(largest_difference(unturned->V, mesh.V), 100);
    EXPECT_LT(largest_difference(nothing->V, mesh.V), 1e-9);
}

TEST(LinearFrames, SpreadATurnEvenlyAlongAStrip)
{
    // A long flat strip whose far end is twisted about its axis: each entry of the turns is linear along it, and made a
    // rotation it turns the middle by half.
    const Mesh strip = grid(40, 2, 0, 400, -10, 10, [](double, double) { return 0.0; });
    std::vector<int> ends;
    std::vector<Eigen::Matrix3d> turns;
    const Eigen::Matrix3d twist = Eigen::AngleAxisd(1, Vec3::UnitX()).toRotationMatrix();
    Positions twisted = strip.V;
    for (int v = 0; v < strip.V.rows(); ++v) {
        if (strip.V(v, 0) == 0 || strip.V(v, 0) == 400) {
            ends.push_back(v);
            turns.push_back(strip.V(v, 0) == 0 ? Eigen::Matrix3d::Identity() : twist);
            twisted.row(v) = (turns.back() * strip.V.row(v).transpose()).transpose();
        }
    }
    const auto result = deform_linear_frames(strip, ends, twisted(ends, Eigen::all), turns);
    ASSERT_TRUE(result);
    for (int v = 0; v < strip.V.rows(); ++v) {
        if (strip.V(v, 0) == 200 && strip.V(v, 1) > 0) {
            EXPECT_NEAR(std::atan2(result->V(v, 2), result->V(v, 1)), 0.5, 1e-3);
        }
    }
}

TEST(LinearFrames, WantATurnForEveryConstraint)
{
    const Pull pull = off_surface_pull(8, 6);
    const auto refused = deform_linear_frames(pull.mesh, pull.constrained, pull.targets, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
}

TEST(DarbouxTurns, AreNoneWhereTheLineStays)
{
    const Mesh mesh = crease_panel(12, 10, Diagonals::random);
    const std::vector<int> line = crease_panel_line(12, 10);
    for (const bool on_surface : {true, false}) {
        for (const Eigen::Matrix3d& turn : darboux_turns(mesh, line, false, places(mesh.V, line), on_surface)) {
            EXPECT_LT((turn - Eigen::Matrix3d::Identity()).norm(), 1e-12);
        }
    }
}

TEST(DarbouxTurns, FollowTheSurfaceRoundABend)
{
    // A ruling slid round a pipe by a third of a radian turns by just that about the pipe's axis.
    const Mesh pipe = quarter_pipe(90, 8);
    std::vector<int> ruling;
    for (int j = 0; j <= 8; ++j) {
        ruling.push_back(j * 91 + 30);
    }
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(1.0 / 3, Vec3::UnitY()).toRotationMatrix();
    const std::vector<Vec3> targets = places(transformed(pipe.V, 1, expected, Vec3::Zero()), ruling);
    for (const Eigen::Matrix3d& turn : darboux_turns(pipe, ruling, false, targets, true)) {
        EXPECT_LT((turn - expected).norm(), 1e-3);
    }
    // Without the surface only the tangents speak, and they have not turned.
    for (const Eigen::Matrix3d& turn : darboux_turns(pipe, ruling, false, targets, false)) {
        EXPECT_LT((turn - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    }
}

TEST(DarbouxTurns, TakeTheSmallestTurnOffTheSurface)
{
    const Mesh mesh = crease_panel(12, 10);
    const std::vector<int> line = crease_panel_line(12, 10);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vec3::UnitY()).toRotationMatrix();
    const std::vector<Vec3> targets = places(transformed(mesh.V, 1, turn, {0, 0, 50}), line);
    for (const Eigen::Matrix3d& found : darboux_turns(mesh, line, false, targets, false)) {
        EXPECT_LT((found - turn).norm(), 1e-9);
    }
}
