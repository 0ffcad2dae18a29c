// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/target_line.h"
#include "tests/bspline/curves.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace tapeline {
namespace {

using testing::circle;
using testing::data_of_spatial_cubic;
using testing::line_of;
using testing::straight;

constexpr double pi = std::numbers::pi;

TEST(TargetLine, GivesBackTheDataItWasMadeOf)
{
    const BSplineData data = data_of_spatial_cubic();
    const BSplineData again = line_of(data).data();
    EXPECT_EQ(again.degree, data.degree);
    EXPECT_EQ(again.knots, data.knots);
    EXPECT_EQ(again.weights, data.weights);
    EXPECT_EQ(again.control_points, data.control_points);
    EXPECT_EQ(again.closed, data.closed);
}

TEST(TargetLine, FollowsTheClosedFormOfACircle)
{
    const TargetLine line = circle(Vec3(3, -2, 7), 50);
    EXPECT_TRUE(line.closed());
    EXPECT_NEAR(line.length(), 100 * pi, 1e-12 * 100 * pi);
    for (int i = 0; i <= 40; ++i) {
        const double s = line.length() * i / 40, angle = s / 50;
        const double t = line.parameter_at(s);
        EXPECT_NEAR((line.point(t) - Vec3(3 + 50 * std::cos(angle), -2 + 50 * std::sin(angle), 7)).norm(), 0, 1e-11);
        EXPECT_NEAR((line.tangent(t) - Vec3(-std::sin(angle), std::cos(angle), 0)).norm(), 0, 1e-12);
        EXPECT_NEAR(line.arc_length(t), s, 1e-12 * line.length());
    }
}

TEST(TargetLine, HasTheLengthOfAParabola)
{
    // y = x² on [0, 2]: length = sqrt(17) + asinh(4) / 4.
    BSplineData data{2, {0, 0, 0, 1, 1, 1}, {}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 4, 0)}, false};
    const double exact = std::sqrt(17.0) + std::asinh(4.0) / 4;
    EXPECT_NEAR(line_of(data).length(), exact, 1e-12 * exact);
}

TEST(TargetLine, HasTheLengthOfACurveWithACusp)
{
    // (t³, t²) on [-1, 1] has a cusp in its middle; length = 2 (13 sqrt(13) - 8) / 27.
    BSplineData data{3, {0, 0, 0, 0, 1, 1, 1, 1}, {}, {}, false};
    data.control_points = {Vec3(-1, 1, 0), Vec3(1, -1.0 / 3, 0), Vec3(-1, -1.0 / 3, 0), Vec3(1, 1, 0)};
    const double exact = 2 * (13 * std::sqrt(13.0) - 8) / 27;
    const TargetLine line = line_of(data);
    EXPECT_NEAR(line.length(), exact, 1e-12 * exact);
    EXPECT_TRUE(line.tangent(0.5).allFinite());
    EXPECT_NEAR(line.tangent(0.5).norm(), 1, 1e-12);
}

TEST(TargetLine, TakesParametersAndLengthsInverseToEachOther)
{
    const TargetLine line = line_of(data_of_spatial_cubic());
    for (int i = 0; i <= 50; ++i) {
        const double t = line.first_parameter() + (line.last_parameter() - line.first_parameter()) * i / 50;
        EXPECT_NEAR(line.parameter_at(line.arc_length(t)), t, 1e-11);
    }
    EXPECT_EQ(line.parameter_at(-5), line.first_parameter());
    EXPECT_EQ(line.parameter_at(line.length() + 5), line.last_parameter());
    const TargetLine loop = circle(Vec3::Zero(), 10);
    EXPECT_NEAR((loop.point(loop.parameter_at(loop.length() * 1.25)) - Vec3(0, 10, 0)).norm(), 0, 1e-10);
}

TEST(TargetLine, ClampsAnUnclampedCurveWithoutChangingIt)
{
    BSplineData data = data_of_spatial_cubic();
    data.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    data.weights = {1, 2, 0.5, 1, 3, 1, 1, 0.25};
    const TargetLine line = line_of(data);
    EXPECT_EQ(line.first_parameter(), 3);
    EXPECT_EQ(line.last_parameter(), 8);
    // A uniform cubic at its knot: (w0 P0 + 4 w1 P1 + w2 P2) / (w0 + 4 w1 + w2).
    const auto& p = data.control_points;
    for (int k = 0; k < 6; ++k) {
        const double w0 = data.weights[k], w1 = 4 * data.weights[k + 1], w2 = data.weights[k + 2];
        const Vec3 expected = (w0 * p[k] + w1 * p[k + 1] + w2 * p[k + 2]) / (w0 + w1 + w2);
        EXPECT_NEAR((line.point(3 + k) - expected).norm(), 0, 1e-12);
    }
    EXPECT_EQ(line.data().knots[3], 3);
    EXPECT_EQ(line.data().knots[0], 3);
}

TEST(TargetLine, RefusesDataThatMakesNoCurveInOneSentence)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refuse = [](const std::function<void(BSplineData&)>& spoil, const std::string& word) {
        BSplineData data = data_of_spatial_cubic();
        spoil(data);
        const auto line = TargetLine::from_data(data);
        ASSERT_FALSE(line) << word;
        EXPECT_EQ(line.error().kind, ErrorKind::rejected);
        EXPECT_NE(line.error().message.find(word), std::string::npos) << word << ": " << line.error().message;
    };
    refuse([](BSplineData& d) { d.degree = 0; }, "degree");
    refuse([](BSplineData& d) { d.degree = 1000000000; }, "degree");
    refuse([](BSplineData& d) { d.knots.pop_back(); }, "knots");
    refuse([](BSplineData& d) { d.weights = {1, 2}; }, "weights");
    refuse([](BSplineData& d) { d.weights.assign(8, 1), d.weights[3] = -1; }, "weight 3");
    refuse([](BSplineData& d) { d.control_points.resize(2); }, "control points");
    refuse([=](BSplineData& d) { d.control_points[4].y() = nan; }, "control point 4");
    refuse([](BSplineData& d) { d.control_points[2].z() = 1e200; }, "control point 2");
    refuse([=](BSplineData& d) { d.knots[5] = nan; }, "knot 5");
    refuse([](BSplineData& d) { d.knots[5] = -1; }, "knot 5");
    refuse([](BSplineData& d) { d.knots.assign(12, 1.0); }, "range");
    refuse([](BSplineData& d) { d.knots = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}; }, "repeated");
    refuse([](BSplineData& d) { d.knots[5] = std::nextafter(d.knots[4], 2); }, "knots");
    refuse([](BSplineData& d) { d.closed = true; }, "closed");
    refuse([](BSplineData& d) { d.control_points.assign(8, Vec3(1, 2, 3)); }, "length");
}

} // namespace
} // namespace tapeline
