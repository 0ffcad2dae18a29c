// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/edit.h"
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

constexpr double pi = std::numbers::pi;

TargetLine fitted_loop()
{
    std::vector<Vec3> points;
    for (int i = 0; i < 90; ++i) {
        const double a = 2 * pi * i / 90;
        points.push_back(Vec3(300 * std::cos(a), 200 * std::sin(a), 15 * std::cos(3 * a)));
    }
    const auto line = fit_polyline(points, true, {14, 0, 3});
    if (!line) {
        throw std::runtime_error(line.error().message);
    }
    return *line;
}

/// Jumps of C''' at the inner knots of a cubic, by its constant third derivative on each span.
double jump_sum(const TargetLine& line)
{
    const BSplineData data = line.data();
    std::vector<Vec3> third;
    for (size_t k = 3; k < data.control_points.size(); ++k) {
        // Third differences of four samples inside one span are exact for a cubic.
        const double a = data.knots[k], h = (data.knots[k + 1] - a) / 3;
        if (h > 0) {
            const Vec3 d = line.point(a + 3 * h) - 3 * line.point(a + 2 * h) + 3 * line.point(a + h) - line.point(a);
            third.push_back(d / (h * h * h));
        }
    }
    double sum = 0;
    for (size_t i = 1; i < third.size(); ++i) {
        sum += (third[i] - third[i - 1]).norm();
    }
    return sum;
}

/// A long wave, its control points at the knots' averages, all but two at each end shaken by up to half a millimetre.
TargetLine noisy_line()
{
    BSplineData data{3, {0, 0, 0}, {}, {}, false};
    for (int i = 0; i <= 17; ++i) {
        data.knots.push_back(i);
    }
    data.knots.insert(data.knots.end(), 3, 17.0);
    std::mt19937 sequence(4);
    for (int i = 0; i < 20; ++i) {
        const double mean = (data.knots[i + 1] + data.knots[i + 2] + data.knots[i + 3]) / 3;
        const double noise = i > 1 && i < 18 ? sequence() / 4294967296.0 - 0.5 : 0;
        data.control_points.push_back(Vec3(50 * mean, 80 * std::sin(0.15 * mean) + noise, noise));
    }
    return line_of(data);
}

TEST(MoveControlPoints, MovesThemToOrBy)
{
    const TargetLine line = line_of(data_of_spatial_cubic());
    const auto moved = move_control_points(line, {{2, Vec3(1, 2, 3), false}, {5, Vec3(1, 1, 1), true}});
    ASSERT_TRUE(moved) << moved.error().message;
    EXPECT_EQ(moved->data().control_points[2], Vec3(1, 2, 3));
    EXPECT_EQ(moved->data().control_points[5], Vec3(34, 6, 5));
    EXPECT_EQ(moved->data().control_points[4], line.data().control_points[4]);
    EXPECT_EQ(moved->data().knots, line.data().knots);
}

TEST(MoveControlPoints, NamesTheRangeWhenAnIndexIsOutsideIt)
{
    const TargetLine line = line_of(data_of_spatial_cubic());
    for (const int index : {-1, 8, 2000000000}) {
        const auto moved = move_control_points(line, {{index, Vec3::Zero(), true}});
        ASSERT_FALSE(moved);
        EXPECT_NE(moved.error().message.find("0 to 7"), std::string::npos) << moved.error().message;
    }
    EXPECT_FALSE(move_control_points(line, {{1, Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0), true}}));
}

TEST(MoveControlPoints, KeepsAClosedLineClosedAndSmooth)
{
    for (const TargetLine& line : {fitted_loop(), circle(Vec3(1, 2, 3), 40)}) {
        const int last = static_cast<int>(line.data().control_points.size()) - 1;
        for (const int index : {0, 1, 2, last - 1, last}) {
            const auto moved = move_control_points(line, {{index, Vec3(5, -3, 4), true}});
            ASSERT_TRUE(moved) << moved.error().message;
            EXPECT_TRUE(moved->closed());
            const double first = moved->first_parameter(), end = moved->last_parameter();
            EXPECT_EQ(moved->point(first), moved->point(end));
            EXPECT_NEAR((moved->tangent(first) - moved->tangent(end)).norm(), 0, 1e-12) << index;
            EXPECT_NEAR(
                (moved->data().control_points[index] - line.data().control_points[index] - Vec3(5, -3, 4)).norm(), 0,
                1e-12);
        }
    }
}

TEST(Fairing, EvensOutTheThirdDerivativeAndObeysItsLimit)
{
    const TargetLine line = noisy_line();
    double previous = jump_sum(line);
    for (const double limit : {0.05, 0.3, 1.0}) {
        const auto fairer = fair(line, limit);
        ASSERT_TRUE(fairer) << fairer.error().message;
        EXPECT_LT(jump_sum(*fairer), previous);
        previous = jump_sum(*fairer);
        for (size_t i = 0; i < line.data().control_points.size(); ++i) {
            const double moved = (fairer->data().control_points[i] - line.data().control_points[i]).norm();
            EXPECT_LE(moved, limit * (1 + 1e-12));
            EXPECT_TRUE(moved == 0 || (i > 1 && i + 2 < line.data().control_points.size()));
        }
    }
    EXPECT_LT(previous, 0.3 * jump_sum(line));
}

TEST(Fairing, LeavesAPolynomialAsItIs)
{
    // One cubic polynomial written with many knots has no jumps at all.
    const auto point = [](double t) { return Vec3(100 * t, 40 * t * t, 30 * t * t * t - t); };
    std::vector<Vec3> points;
    for (int i = 0; i <= 400; ++i) {
        points.push_back(point(i / 400.0));
    }
    BSplineData data{3, {0, 0, 0, 0, 0.2, 0.35, 0.6, 0.8, 1, 1, 1, 1}, {}, {}, false};
    for (int i = 0; i < 8; ++i) { // poles by blossoming: f(t_(i+1), t_(i+2), t_(i+3))
        const double a = data.knots[i + 1], b = data.knots[i + 2], c = data.knots[i + 3], mean = (a + b + c) / 3;
        data.control_points.push_back(Vec3(100 * mean, 40 * (a * b + b * c + c * a) / 3, 30 * a * b * c - mean));
    }
    const TargetLine line = line_of(data);
    ASSERT_NEAR((line.point(0.47) - point(0.47)).norm(), 0, 1e-12);
    const auto fairer = fair(line, 1);
    ASSERT_TRUE(fairer);
    for (int i = 0; i < 8; ++i) {
        EXPECT_NEAR((fairer->data().control_points[i] - data.control_points[i]).norm(), 0, 1e-9);
    }
}

TEST(Fairing, TakesCurvesOfEveryKind)
{
    BSplineData weighted = data_of_spatial_cubic();
    weighted.weights = {1, 2, 1, 1, 0.5, 1, 1, 1};
    for (const TargetLine& line : {line_of(weighted), circle(Vec3::Zero(), 100)}) {
        const auto fairer = fair(line, 0.5);
        ASSERT_TRUE(fairer) << fairer.error().message;
        EXPECT_EQ(fairer->closed(), line.closed());
        for (int i = 0; i <= 100; ++i) {
            const double t =
                fairer->first_parameter() + (fairer->last_parameter() - fairer->first_parameter()) * i / 100;
            EXPECT_LE(line.foot(fairer->point(t)).distance, 0.5);
        }
    }
    EXPECT_FALSE(fair(line_of(weighted), 0));
    EXPECT_FALSE(fair(line_of(weighted), std::numeric_limits<double>::quiet_NaN()));
}

} // namespace
} // namespace tapeline
