// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/moves.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// The panel's line lifted by a bell of the given height.
ParametricCurve lifted(double height)
{
    const double w = std::numbers::pi / 400;
    return {[=](double x) {
                const double bell = std::cos(w * x) * std::cos(w * x);
                return Vec3(x, 0, crease_panel_height(x, 0) + height * bell);
            },
            [=](double x) { return Vec3(1, 0, -x / 6000 - height * w * std::sin(2 * w * x)); }, -200, 200};
}

} // namespace

TEST(OffSurfaceMove, LiftsTheWholeRegionWithoutACut)
{
    const Model model = model_of(crease_panel(60, 40));
    const auto [move, quality] = move_and_measure(model, crease_panel_line(60, 40), lifted(60));
    EXPECT_EQ(move.placement.verdict, Placement::off_surface);
    EXPECT_FALSE(move.retraction.applied);
    EXPECT_TRUE(move.appended.empty());
    ASSERT_EQ(move.solves.size(), 1u);
    EXPECT_TRUE(move.converged());
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
    EXPECT_EQ(quality.flipped, 0);
}

TEST(OffSurfaceMove, OfZeroHeightMovesNothing)
{
    const Model model = model_of(crease_panel(60, 40));
    const auto [move, quality] = move_and_measure(model, crease_panel_line(60, 40), lifted(0));
    EXPECT_LE((move.V - move.rest.mesh.V).rowwise().norm().maxCoeff(), 1e-6);
}
