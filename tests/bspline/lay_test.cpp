// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/slide.h"
#include "kernel/closest_point.h"
#include "tests/bspline/curves.h"
#include "tests/bspline/surfaces.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tapeline {
namespace {

using testing::grid;
using testing::line_of;
using testing::straight;

TEST(Lay, OnAPlaneIsTheProjection)
{
    const Mesh plane = grid(20, 20, -100, 100, -100, 100, [](double, double) { return 0.0; });
    BSplineData data{3, {0, 0, 0, 0, 1, 1, 1, 1}, {}, {}, false};
    data.control_points = {Vec3(-50, 0, 3), Vec3(-20, 40, 30), Vec3(20, -40, -10), Vec3(60, 0, 5)};
    const auto laid = lay_on_surface(line_of(data), plane);
    ASSERT_TRUE(laid) << laid.error().message;
    for (Vec3& p : data.control_points) {
        p.z() = 0;
    }
    const TargetLine expected = line_of(data);
    for (int i = 0; i <= 200; ++i) {
        EXPECT_LE(expected.foot(laid->point(i / 200.0)).distance, 2e-3);
        EXPECT_LE(laid->foot(expected.point(i / 200.0)).distance, 2e-3);
        EXPECT_NEAR(laid->point(i / 200.0).z(), 0, 1e-9);
    }
}

TEST(Lay, LeavesTheLineWithinItsToleranceOfTheSurface)
{
    const Mesh panel = testing::crease_panel(120, 80, testing::Diagonals::random);
    const ClosestPoint surface(panel);
    const TargetLine line = straight(Vec3(-300, 40, 20), Vec3(320, 150, 5));
    for (const double tolerance : {0.0, 0.05, 0.01}) {
        const auto laid = lay_on_surface(line, panel, tolerance);
        ASSERT_TRUE(laid) << laid.error().message;
        for (int i = 0; i <= 3000; ++i) {
            EXPECT_LE(surface.closest(laid->point(i / 3000.0)).distance, tolerance > 0 ? tolerance : 0.063);
        }
    }
}

TEST(Lay, KeepsAClosedLineClosed)
{
    const Mesh ball = testing::sphere(100, 40);
    const auto laid = lay_on_surface(testing::circle(Vec3(0, 0, 30), 110), ball);
    ASSERT_TRUE(laid) << laid.error().message;
    EXPECT_TRUE(laid->closed());
    EXPECT_NEAR((laid->tangent(0) - laid->tangent(1)).norm(), 0, 1e-9);
    const double reach = 100 / std::hypot(110, 30);
    for (int i = 0; i <= 100; ++i) {
        EXPECT_NEAR(laid->point(i / 100.0).z(), 30 * reach, 0.3);
    }
}

TEST(Lay, RefusesALineThatIsElsewhere)
{
    const Mesh plane = grid(20, 20, -100, 100, -100, 100, [](double, double) { return 0.0; });
    const auto far = lay_on_surface(straight(Vec3(0, 0, 500), Vec3(10, 0, 500)), plane);
    ASSERT_FALSE(far);
    EXPECT_NE(far.error().message.find("500"), std::string::npos) << far.error().message;
    EXPECT_FALSE(lay_on_surface(straight(Vec3(0, 0, 0), Vec3(10, 0, 0)), Mesh()));
    // Between two shelves the nearest one changes from one end of the line to the other.
    Mesh shelves = grid(40, 2, -100, 100, -10, 10, [](double x, double) { return x < 0 ? 0.0 : 90.0; });
    for (int t = static_cast<int>(shelves.F.rows()) - 1; t >= 0; --t) {
        Vec3 z;
        for (int k = 0; k < 3; ++k) {
            z[k] = shelves.V(shelves.F(t, k), 2);
        }
        if (z.maxCoeff() != z.minCoeff()) {
            shelves.F.row(t) = shelves.F.row(shelves.F.rows() - 1);
            shelves.F.conservativeResize(shelves.F.rows() - 1, 3);
        }
    }
    const auto torn = lay_on_surface(straight(Vec3(-60, 0, 45), Vec3(60, 0, 45)), shelves);
    ASSERT_FALSE(torn);
    EXPECT_NE(torn.error().message.find("far apart"), std::string::npos) << torn.error().message;
}

} // namespace
} // namespace tapeline
