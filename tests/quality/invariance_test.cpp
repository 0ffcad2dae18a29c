// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/moves.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 60, ny = 40;
constexpr double slide = 80;

/// What must hold for each method that moves on the surface.
class Move : public ::testing::TestWithParam<Method> {
protected:
    Move() { options_.method = GetParam(); }

    MeasuredMove reference(Diagonals diagonals = Diagonals::alternating) const
    {
        return move_and_measure(model_of(crease_panel(nx, ny, diagonals)), crease_panel_line(nx, ny),
                                crease_slide_target(slide), options_);
    }

    MoveOptions options_;
};

} // namespace

TEST_P(Move, OfASymmetricModelIsSymmetric)
{
    const auto [move, quality] = reference();
    double worst = 0;
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            Vec3 mirrored = move.V.row(j * (nx + 1) + nx - i);
            mirrored.x() *= -1;
            worst = std::max(worst, (mirrored - Vec3(move.V.row(j * (nx + 1) + i))).norm());
        }
    }
    EXPECT_LE(worst, 1e-6);
}

TEST_P(Move, OfARigidlyMovedModelIsTheRigidlyMovedResult)
{
    const RigidMotion motion = some_rigid_motion();
    Model model = model_of(crease_panel(nx, ny, Diagonals::random));
    for (int v = 0; v < model.mesh.V.rows(); ++v) {
        model.mesh.V.row(v) = motion(model.mesh.V.row(v)).transpose();
    }
    const auto moved =
        move_and_measure(model, crease_panel_line(nx, ny), mapped(crease_slide_target(slide), motion), options_);
    const auto original = reference(Diagonals::random);
    ASSERT_EQ(moved.move.V.rows(), original.move.V.rows());
    double worst = 0;
    for (int v = 0; v < moved.move.V.rows(); ++v) {
        worst = std::max(worst, (motion(original.move.V.row(v)) - Vec3(moved.move.V.row(v))).norm());
    }
    EXPECT_LE(worst, 1e-6);
}

TEST_P(Move, OfAScaledModelIsTheScaledResult)
{
    constexpr double scale = 0.01;
    Model model = model_of(crease_panel(nx, ny));
    model.mesh.V *= scale;
    const RigidMotion stay{Eigen::Matrix3d::Identity(), Vec3::Zero()};
    const auto moved =
        move_and_measure(model, crease_panel_line(nx, ny), mapped(crease_slide_target(slide), stay, scale), options_);
    EXPECT_LE((moved.move.V - scale * reference().move.V).rowwise().norm().maxCoeff(), 1e-6 * scale);
}

TEST_P(Move, GivesTheSameBitsForOneAndTwoThreads)
{
    const auto run = [this](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return reference(Diagonals::random).move.V;
    };
    const Positions one = run(1), two = run(2), again = run(2);
    EXPECT_TRUE(one == two);
    EXPECT_TRUE(two == again);
}

TEST_P(Move, LeavesFixedVerticesBitIdenticalAndKeepsTheOrder)
{
    const auto [move, quality] = reference(Diagonals::random);
    const Mesh before = crease_panel(nx, ny, Diagonals::random);
    ASSERT_GE(move.V.rows(), before.V.rows());
    EXPECT_TRUE(move.rest.mesh.V.topRows(before.V.rows()) == before.V);
    for (const int v : move.region.fixed_rim) {
        EXPECT_TRUE(move.V.row(v) == move.rest.mesh.V.row(v));
    }
}

TEST_P(Move, OfAFlatSideStaysInItsPlane)
{
    const Model model = model_of(flat_roof(60, 40, Diagonals::random));
    const ParametricCurve target([](double x) { return Vec3(x, 350, -105); }, [](double) { return Vec3::UnitX(); },
                                 -1200, 1200);
    const auto [move, quality] = move_and_measure(model, crease_panel_line(60, 40), target, options_);
    EXPECT_EQ(move.placement.compressed, LineSide::left);
    for (const int t : move.left_faces) {
        for (int k = 0; k < 3; ++k) {
            const auto p = move.V.row(move.rest.mesh.F(t, k));
            EXPECT_NEAR(p[2], -0.3 * p[1], 1e-6 * 350);
        }
    }
    EXPECT_EQ(quality.flipped, 0);
}

INSTANTIATE_TEST_SUITE_P(Under, Move, ::testing::Values(Method::plate_fl, Method::asan_fl),
                         [](const auto& entry) { return entry.param == Method::plate_fl ? "PlateFl" : "AsanFl"; });
