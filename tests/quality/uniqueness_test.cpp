// SPDX-License-Identifier: GPL-3.0-or-later
// Two starts, one answer? Under compression plain methods snap to whichever fold is near; the retraction takes the
// compression away.
#include "tests/support/moves.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

MoveResult slide_from_two_starts(Method method, int nx, int ny, double slide)
{
    MoveOptions options;
    options.method = method;
    options.check_unique = true;
    return move_and_measure(model_of(crease_panel(nx, ny)), crease_panel_line(nx, ny), crease_slide_target(slide),
                            options)
        .move;
}

} // namespace

TEST(Uniqueness, IsLostBySpokesAndRimsUnderCompressionAtEqualEnergy)
{
    const MoveResult move = slide_from_two_starts(Method::arap_sr, 60, 40, 60);
    const UniquenessReport& u = move.uniqueness;
    EXPECT_TRUE(move.converged());
    EXPECT_TRUE(u.checked);
    EXPECT_GT(u.distance_mm, 100);
    EXPECT_LT(u.distance_mm, 160);
    ASSERT_EQ(u.energies.size(), 1U);
    EXPECT_NEAR(u.energies[0].rest / u.energies[0].harmonic, 1, 0.05);
    EXPECT_TRUE(move.ambiguous());
}

TEST(Uniqueness, IsGivenBackByTheRetraction)
{
    for (const Method method : {Method::asan_fl, Method::asan_fl_paper}) {
        const MoveResult move = slide_from_two_starts(method, 60, 40, 60);
        EXPECT_TRUE(move.converged());
        EXPECT_EQ(move.uniqueness.energies.size(), 2U); // each side for itself
        EXPECT_LT(move.uniqueness.distance_mm, 0.05);
        EXPECT_FALSE(move.ambiguous());
        RecordProperty(fmt::format("distance_mm_{}", method_info(method).name),
                       fmt::format("{}", move.uniqueness.distance_mm));
    }
}

TEST(Uniqueness, IsThereByConstructionForLinearMethods)
{
    const MoveResult move = slide_from_two_starts(Method::lri, 24, 16, 60);
    EXPECT_TRUE(move.uniqueness.checked);
    EXPECT_EQ(move.uniqueness.distance_mm, 0);
    EXPECT_FALSE(move.ambiguous());
}

TEST(Uniqueness, IsNotJudgedUnlessAskedFor)
{
    MoveOptions options;
    options.method = Method::arap_sr;
    const MoveResult move =
        move_and_measure(model_of(crease_panel(24, 16)), crease_panel_line(24, 16), crease_slide_target(60), options)
            .move;
    EXPECT_FALSE(move.uniqueness.checked);
    EXPECT_FALSE(move.ambiguous());
}

TEST(Uniqueness, IsJudgedOnTheScaleOfTheRegion)
{
    // The same panel a thousand times smaller is as ambiguous as before, although nothing is 0.1 mm away.
    Mesh small = crease_panel(60, 40);
    small.V /= 1000;
    MoveOptions options;
    options.method = Method::arap_sr;
    options.check_unique = true;
    const ParametricCurve target = mapped(crease_slide_target(60), {Eigen::Matrix3d::Identity(), Vec3::Zero()}, 1e-3);
    const MoveResult move = move_and_measure(model_of(small), crease_panel_line(60, 40), target, options).move;
    EXPECT_LT(move.uniqueness.limit_mm, 1e-3);
    EXPECT_TRUE(move.ambiguous());
}
