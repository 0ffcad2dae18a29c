// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/fit.h"
#include "tests/bspline/curves.h"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace tapeline {
namespace {

using testing::data_of_spatial_cubic;
using testing::line_of;

constexpr double pi = std::numbers::pi;

std::vector<Vec3> sample(int n, const std::function<Vec3(double)>& curve)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= n; ++i) {
        points.push_back(curve(static_cast<double>(i) / n));
    }
    return points;
}

/// A flat arc with a tight bend in its middle.
Vec3 bent(double t) { return {1000 * t, 60 * std::atan(12 * (t - 0.5)), 30 * t * t}; }

double largest_distance(const TargetLine& line, const std::vector<Vec3>& points)
{
    double worst = 0;
    for (const Vec3& p : points) {
        worst = std::max(worst, line.foot(p).distance);
    }
    return worst;
}

TEST(Fit, ReproducesABSplineFromItsSamples)
{
    BSplineData data = data_of_spatial_cubic();
    data.knots = {0, 0, 0, 0, 0.2, 0.4, 0.6, 0.8, 1, 1, 1, 1};
    const TargetLine line = line_of(data);
    const auto points = sample(800, [&](double t) { return line.point(t); });
    FitReport report;
    const auto fit = fit_polyline(points, false, {0, 1e-4, 3}, &report);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_LE(report.max_error_mm, 1e-4);
    EXPECT_LE(largest_distance(line, sample(3000, [&](double t) { return fit->point(t); })), 2e-4);
}

TEST(Fit, ObeysAndReportsItsTolerance)
{
    const auto points = sample(300, bent);
    int previous = 0;
    for (const double tolerance : {10.0, 1.0, 0.1, 0.01, 0.001}) {
        FitReport report;
        const auto fit = fit_polyline(points, false, {0, tolerance, 3}, &report);
        ASSERT_TRUE(fit) << fit.error().message;
        EXPECT_LE(report.max_error_mm, tolerance);
        EXPECT_NEAR(report.max_error_mm, largest_distance(*fit, points), 1e-12);
        EXPECT_EQ(report.control_points, static_cast<int>(fit->data().control_points.size()));
        EXPECT_GE(report.control_points, previous);
        previous = report.control_points;
        EXPECT_EQ(fit->point(0), points.front());
        EXPECT_EQ(fit->point(1), points.back());
    }
    EXPECT_LE(previous, 60);
}

TEST(Fit, NeedsFewControlPointsByDefault)
{
    FitReport report;
    const auto arc = sample(100, [](double t) { return Vec3(800 * t, 100 * t * (1 - t), 0); });
    ASSERT_TRUE(fit_polyline(arc, false, {}, &report));
    EXPECT_LE(report.control_points, 6);
    EXPECT_LE(report.max_error_mm, 0.09);
    ASSERT_TRUE(fit_polyline(sample(300, bent), false, {}, &report));
    EXPECT_LE(report.control_points, 20);
}

TEST(Fit, KeepsToTheNumberOfControlPointsAskedFor)
{
    const auto points = sample(200, bent);
    double previous = std::numeric_limits<double>::infinity();
    for (const int n : {2, 3, 4, 8, 16, 32}) {
        FitReport report;
        const auto fit = fit_polyline(points, false, {n, 0, 3}, &report);
        ASSERT_TRUE(fit) << fit.error().message;
        EXPECT_EQ(static_cast<int>(fit->data().control_points.size()), n);
        EXPECT_EQ(fit->data().degree, std::min(3, n - 1));
        EXPECT_LE(report.max_error_mm, previous);
        previous = report.max_error_mm;
    }
    EXPECT_FALSE(fit_polyline(points, false, {4, 1e-3, 3}));
}

TEST(Fit, IsNotPulledByCrowdedPoints)
{
    // The same arc, once evenly sampled and once with nine tenths of the points in its first tenth.
    const auto arc = [](double t) { return Vec3(800 * std::sin(t), 800 * (1 - std::cos(t)), 20 * t); };
    const auto even = sample(400, arc);
    const auto uneven = sample(2000, [&](double t) { return arc(t < 0.9 ? t / 9 : 0.1 + 9 * (t - 0.9)); });
    const auto a = fit_polyline(even, false, {6, 0, 3}), b = fit_polyline(uneven, false, {6, 0, 3});
    ASSERT_TRUE(a && b);
    for (int i = 0; i <= 100; ++i) {
        EXPECT_LE(b->foot(a->point(i / 100.0)).distance, 2e-2);
    }
}

TEST(Fit, FollowsLongStraightEdgesBesideAFineBend)
{
    // What a CAD tessellation gives: 300 mm without a point, a fillet of 60°, 500 mm without a point.
    std::vector<Vec3> points{Vec3(0, 0, 0)};
    for (int i = 0; i <= 12; ++i) {
        const double angle = i * pi / 36;
        points.push_back(Vec3(300 + 40 * std::sin(angle), 40 * (1 - std::cos(angle)), 0));
    }
    points.push_back(points.back() + 500 * Vec3(0.5, std::sqrt(0.75), 0));
    FitReport report;
    const auto fit = fit_polyline(points, false, {0, 0.05, 3}, &report);
    ASSERT_TRUE(fit) << fit.error().message;
    for (int i = 0; i <= 50; ++i) {
        EXPECT_LE(fit->foot(Vec3(6 * i, 0, 0)).distance, 0.1);
        EXPECT_LE(fit->foot(points.back() - 10 * i * Vec3(0.5, std::sqrt(0.75), 0)).distance, 0.1);
    }
}

TEST(Fit, OfAClosedLineIsSmoothAtTheSeam)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 180; ++i) {
        const double a = 2 * pi * i / 180;
        points.push_back(Vec3(300 * std::cos(a), 200 * std::sin(a), 15 * std::cos(3 * a)));
    }
    FitReport report;
    const auto fit = fit_polyline(points, true, {0, 0.01, 3}, &report);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_TRUE(fit->closed());
    EXPECT_LE(largest_distance(*fit, points), 0.01);
    EXPECT_EQ(fit->point(0), fit->point(1));
    EXPECT_NEAR((fit->tangent(0) - fit->tangent(1)).norm(), 0, 1e-9);
    // Second derivatives from both sides of the seam.
    const auto d = fit->data();
    const auto& p = d.control_points;
    const auto& u = d.knots;
    const size_t n = p.size() - 1;
    const Vec3 start = ((p[2] - p[1]) / (u[5] - u[2]) - (p[1] - p[0]) / (u[4] - u[1])) / (u[4] - u[2]);
    const Vec3 end =
        ((p[n] - p[n - 1]) / (u[n + 3] - u[n]) - (p[n - 1] - p[n - 2]) / (u[n + 2] - u[n - 1])) / (u[n + 2] - u[n]);
    EXPECT_NEAR((start - end).norm(), 0, 1e-9 * start.norm());
    const auto counted = fit_polyline(points, true, {12, 0, 3}, &report);
    ASSERT_TRUE(counted) << counted.error().message;
    EXPECT_EQ(report.control_points, 12);
}

TEST(Fit, MovesAndScalesWithItsPoints)
{
    const auto points = sample(150, bent);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    for (const double scale : {1.0, 1e-3}) {
        std::vector<Vec3> moved;
        for (const Vec3& p : points) {
            moved.push_back(scale * (turn * p + Vec3(500, -300, 900)));
        }
        const auto a = fit_polyline(points, false), b = fit_polyline(moved, false);
        ASSERT_TRUE(a && b);
        ASSERT_EQ(a->data().control_points.size(), b->data().control_points.size());
        for (int i = 0; i <= 100; ++i) {
            const Vec3 expected = scale * (turn * a->point(i / 100.0) + Vec3(500, -300, 900));
            EXPECT_LE((b->point(i / 100.0) - expected).norm(), 1e-6 * scale);
        }
    }
}

TEST(Fit, OfASymmetricLineIsSymmetric)
{
    const auto points =
        sample(120, [](double t) -> Vec3 { return Vec3(t - 0.5, 0.3 * std::cos(7 * (t - 0.5)), 0) * 800; });
    const auto fit = fit_polyline(points, false, {0, 0.005, 3});
    ASSERT_TRUE(fit);
    for (int i = 0; i <= 100; ++i) {
        const Vec3 a = fit->point(i / 100.0), b = fit->point(1 - i / 100.0);
        EXPECT_NEAR((a - Vec3(-b.x(), b.y(), b.z())).norm(), 0, 1e-7);
    }
}

TEST(Fit, OfTwoPointsIsTheStraightLineWithHandles)
{
    const auto fit = fit_polyline({Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(11, 2, 3)}, false);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_EQ(fit->data().control_points.size(), 4u);
    EXPECT_NEAR(fit->length(), 10, 1e-12);
}

TEST(Fit, RefusesWhatMakesNoLine)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto message = [](const Result<TargetLine>& line) { return line ? std::string() : line.error().message; };
    EXPECT_NE(message(fit_polyline({}, false)).find("at least 2"), std::string::npos);
    EXPECT_NE(message(fit_polyline({Vec3(1, 1, 1), Vec3(1, 1, 1)}, false)).find("at least 2"), std::string::npos);
    EXPECT_NE(message(fit_polyline({Vec3(0, 0, 0), Vec3(1, 1, 1)}, true)).find("at least 3"), std::string::npos);
    EXPECT_NE(message(fit_polyline({Vec3(0, 0, 0), Vec3(1, nan, 1)}, false)).find("point 1"), std::string::npos);
    const auto points = sample(20, bent);
    for (const FitOptions options : {FitOptions{1, 0, 3}, FitOptions{-4, 0, 3}, FitOptions{0, -1, 3},
                                     FitOptions{0, nan, 3}, FitOptions{0, 0, 0}, FitOptions{0, 0, 40}}) {
        const auto fit = fit_polyline(points, false, options);
        ASSERT_FALSE(fit);
        EXPECT_EQ(fit.error().kind, ErrorKind::usage);
    }
}

TEST(Interpolation, PassesThroughEveryPoint)
{
    for (const int n : {1, 2, 3, 4, 50, 5000}) {
        const auto points = sample(n, bent);
        const auto line = interpolate_points(points, false);
        ASSERT_TRUE(line) << line.error().message;
        EXPECT_LE(largest_distance(*line, points), 1e-9 * line->length());
    }
    const auto loop =
        sample(40, [](double t) { return Vec3(50 * std::cos(2 * pi * t), 50 * std::sin(2 * pi * t), 0); });
    const auto line = interpolate_points(loop, true);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_LE(largest_distance(*line, loop), 1e-9 * line->length());
    EXPECT_NEAR(line->length(), 100 * pi, 1e-3);
    EXPECT_NEAR((line->tangent(0) - line->tangent(1)).norm(), 0, 1e-9);
}

TEST(Interpolation, StaysTameOverUnevenSteps)
{
    std::vector<Vec3> points;
    for (const double x : {0.0, 1.0, 1.01, 1.02, 5.0, 5.001, 9.0, 30.0}) {
        points.push_back(Vec3(x, std::sin(0.3 * x), 0));
    }
    const auto line = interpolate_points(points, false);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_LE(line->length(), 36);
}

} // namespace
} // namespace tapeline
