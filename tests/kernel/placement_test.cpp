// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/placement.h"
#include "tests/support/moves.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 20, ny = 12;

PlacementResult place(const Vec3& u)
{
    const Model model = model_of(flat_roof(nx, ny));
    const FeatureLine line = line_of(model, crease_panel_line(nx, ny));
    return decide_placement(model.mesh, whole_model(model), sends(model, line, std::vector<Vec3>(nx + 1, u)));
}

} // namespace

TEST(Placement, OfASlideIntoOneSideCompressesThatSide)
{
    const PlacementResult left = place(Vec3(0, 100, -30)), right = place(Vec3(0, -100, -30));
    EXPECT_EQ(left.verdict, Placement::on_surface);
    EXPECT_EQ(left.compressed, LineSide::left);
    EXPECT_EQ(right.compressed, LineSide::right);
    // The slide lies in the left plane: its whole length there is along the conormal.
    const double length = Vec3(0, 100, -30).norm();
    EXPECT_NEAR(left.c_left, 4000 * length, 1e-6 * 4000 * length);
    EXPECT_NEAR(left.s_alpha, nx * length, 1e-9 * nx * length);
    EXPECT_LT(left.s_beta, left.s_alpha);
    EXPECT_NEAR(left.off_fraction, 0, 1e-12);
}

TEST(Placement, OfALiftIsOffSurface)
{
    const PlacementResult lift = place(Vec3(0, 0, 50));
    EXPECT_EQ(lift.verdict, Placement::off_surface);
    EXPECT_NEAR(lift.off_fraction, 1, 1e-12);
}

TEST(Placement, SlightlyAboveTheSurfaceIsStillOnSurface)
{
    EXPECT_EQ(place(Vec3(0, 100, -10)).verdict, Placement::on_surface);
}

TEST(Placement, SignDecidesWhereThePaperRuleTies)
{
    // On a flat sheet both planes hold the displacement, so that the unsigned sums are equal.
    const Model model = model_of(grid(nx, ny, 0, 100, -50, 50, [](double, double) { return 0.0; }));
    const FeatureLine line = line_of(model, crease_panel_line(nx, ny));
    const auto placed =
        decide_placement(model.mesh, whole_model(model), sends(model, line, std::vector<Vec3>(nx + 1, Vec3(0, -5, 0))));
    EXPECT_DOUBLE_EQ(placed.s_alpha, placed.s_beta);
    EXPECT_EQ(placed.compressed, LineSide::right);
    EXPECT_GT(placed.c_right, 0);
    EXPECT_LT(placed.c_left, 0);
}

TEST(SignedCreaseAngles, OfARoofAreTheAngleBetweenItsSides)
{
    const Model model = model_of(flat_roof(nx, ny));
    const FeatureLine line = line_of(model, crease_panel_line(nx, ny));
    const double angle = 2 * std::atan(0.3) * 180 / std::numbers::pi;
    Positions valley = model.mesh.V;
    valley.col(2) *= -1;
    const auto ridge_angles = signed_crease_angles(model.mesh, model.mesh.V, line);
    const auto valley_angles = signed_crease_angles(model.mesh, valley, line);
    ASSERT_EQ(ridge_angles.size(), static_cast<size_t>(nx));
    for (size_t i = 0; i < ridge_angles.size(); ++i) {
        EXPECT_NEAR(std::abs(ridge_angles[i]), angle, 1e-9);
        EXPECT_NEAR(valley_angles[i], -ridge_angles[i], 1e-9);
    }
}
