// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/join.h"
#include "tests/bspline/curves.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tapeline {
namespace {

using testing::circle;
using testing::data_of_spatial_cubic;
using testing::line_of;

/// Quarter k of a circle of radius 30 about the origin, exact; every other one with other weights of the same curve.
BSplineData quarter(int k)
{
    const auto at = [](double angle, double r) -> Vec3 { return r * Vec3(std::cos(angle), std::sin(angle), 0); };
    const double a = k * std::numbers::pi / 2, factor = k % 2 == 0 ? 1 : 5;
    return {2,
            {0, 0, 0, 1.0 + k, 1.0 + k, 1.0 + k},
            {factor, factor * std::sqrt(0.5), factor},
            {at(a, 30), at(a + std::numbers::pi / 4, 30 * std::sqrt(2)), at(a + std::numbers::pi / 2, 30)},
            false};
}

BSplineData reversed(BSplineData data)
{
    std::ranges::reverse(data.control_points);
    std::ranges::reverse(data.weights);
    return data;
}

TEST(Join, OfOneCurveIsTheCurve)
{
    const auto line = join_lines({data_of_spatial_cubic()}, 1e-6);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_EQ(line->data().knots, data_of_spatial_cubic().knots);
    EXPECT_EQ(line->data().control_points, data_of_spatial_cubic().control_points);
}

TEST(Join, OfQuartersIsTheCircle)
{
    const auto line = join_lines({quarter(0), quarter(2), reversed(quarter(1)), reversed(quarter(3))}, 1e-9);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_TRUE(line->closed());
    EXPECT_NEAR(line->length(), 60 * std::numbers::pi, 1e-10);
    const TargetLine whole = circle(Vec3::Zero(), 30);
    for (int i = 0; i <= 100; ++i) {
        const double s = line->length() * i / 100;
        EXPECT_NEAR((line->point(line->parameter_at(s)) - whole.point(whole.parameter_at(s))).norm(), 0, 1e-10);
    }
}

TEST(Join, KeepsTheFirstCurvesSense)
{
    const auto line = join_lines({reversed(quarter(1)), quarter(0), quarter(2)}, 1e-9);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_FALSE(line->closed());
    EXPECT_NEAR((line->point(line->first_parameter()) - Vec3(0, -30, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((line->point(line->last_parameter()) - Vec3(30, 0, 0)).norm(), 0, 1e-12);
}

TEST(Join, ClosesGapsUpToItsToleranceOnly)
{
    BSplineData moved = quarter(1);
    for (Vec3& p : moved.control_points) {
        p.z() += 1e-4;
    }
    EXPECT_FALSE(join_lines({quarter(0), moved}, 1e-5));
    const auto line = join_lines({quarter(0), moved}, 1e-3);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_NEAR(line->length(), 30 * std::numbers::pi, 1e-3);
    EXPECT_NEAR(line->foot(Vec3(0, 30, 5e-5)).distance, 0, 1e-12);
}

TEST(Join, CountsSeparateLines)
{
    const auto line = join_lines({quarter(0), quarter(2)}, 1e-6);
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.find("2 separate lines"), std::string::npos) << line.error().message;
    EXPECT_FALSE(join_lines({}, 1));
    EXPECT_FALSE(join_lines({quarter(0), data_of_spatial_cubic()}, 1e9));
}

} // namespace
} // namespace tapeline
