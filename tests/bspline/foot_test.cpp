// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "tests/bspline/curves.h"

#include <cmath>
#include <ctime>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace tapeline {
namespace {

using testing::circle;
using testing::data_of_spatial_cubic;
using testing::line_of;
using testing::straight;

Vec3 random_point(std::mt19937& sequence, const Vec3& low, const Vec3& high)
{
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
        p[k] = low[k] + (high[k] - low[k]) * (sequence() / 4294967296.0);
    }
    return p;
}

/// Smallest distance over a dense sampling, an upper bound that is close to the true one.
double sampled_distance(const TargetLine& line, const Vec3& p, int samples)
{
    double best = 1e300;
    for (int i = 0; i <= samples; ++i) {
        const double t = line.first_parameter() + (line.last_parameter() - line.first_parameter()) * i / samples;
        best = std::min(best, (line.point(t) - p).norm());
    }
    return best;
}

void expect_nearest(const TargetLine& line, const Vec3& low, const Vec3& high)
{
    std::mt19937 sequence(7);
    const double step = line.length() / 4000;
    for (int i = 0; i < 200; ++i) {
        const Vec3 p = random_point(sequence, low, high);
        const CurveFoot foot = line.foot(p);
        const double sampled = sampled_distance(line, p, 4000);
        EXPECT_LE(foot.distance, sampled + 1e-12);
        EXPECT_GE(foot.distance, sampled - 3 * step);
        EXPECT_EQ(foot.point, line.point(foot.parameter));
        EXPECT_NEAR(foot.distance, (p - foot.point).norm(), 0);
        if (foot.parameter != line.first_parameter() && foot.parameter != line.last_parameter()) {
            EXPECT_NEAR((p - foot.point).dot(foot.tangent), 0, 1e-11 * line.length());
            EXPECT_FALSE(foot.at_end);
        }
    }
}

TEST(Foot, IsNearerThanEverySampleOfACubic)
{
    expect_nearest(line_of(data_of_spatial_cubic()), Vec3(-20, -30, -30), Vec3(70, 30, 30));
}

TEST(Foot, IsNearerThanEverySampleOfARationalCurve)
{
    BSplineData data = data_of_spatial_cubic();
    data.weights = {1, 5, 0.2, 1, 3, 1, 0.5, 1};
    expect_nearest(line_of(data), Vec3(-20, -30, -30), Vec3(70, 30, 30));
}

TEST(Foot, IsNearerThanEverySampleOfAPolygonWithCorners)
{
    BSplineData data = data_of_spatial_cubic();
    data.degree = 1;
    data.knots = {0, 0, 1, 2, 3, 4, 5, 6, 7, 7};
    const TargetLine line = line_of(data);
    std::mt19937 sequence(7);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = random_point(sequence, Vec3(-20, -30, -30), Vec3(70, 30, 30));
        EXPECT_LE(line.foot(p).distance, sampled_distance(line, p, 4000) + 1e-12);
    }
}

TEST(Foot, IsNearerThanEverySampleAtTheHighestDegree)
{
    BSplineData data{25, {}, {}, {}, false};
    data.knots.assign(26, 0.0);
    data.knots.insert(data.knots.end(), 26, 1.0);
    std::mt19937 sequence(3);
    for (int i = 0; i < 26; ++i) {
        data.control_points.push_back(Vec3(10 * i, 0, 0) + random_point(sequence, Vec3(0, -60, -60), Vec3(0, 60, 60)));
    }
    expect_nearest(line_of(data), Vec3(-20, -30, -30), Vec3(270, 30, 30));
}

TEST(Foot, OfAPointOnTheCurveIsThePointToRounding)
{
    const TargetLine line = line_of(data_of_spatial_cubic());
    for (int i = 0; i <= 1000; ++i) {
        const Vec3 p = line.point(i / 1000.0);
        EXPECT_LE(line.foot(p).distance, 1e-13 * line.length());
        EXPECT_FALSE(line.foot(p).at_end);
    }
}

TEST(Foot, StaysExactFarFromTheOriginAndAtEveryScale)
{
    for (const double scale : {1e-6, 1.0, 1e6}) {
        BSplineData data = data_of_spatial_cubic();
        for (Vec3& p : data.control_points) {
            p = scale * (p + Vec3(1500, -700, 300));
        }
        const TargetLine line = line_of(data);
        for (int i = 0; i <= 200; ++i) {
            EXPECT_LE(line.foot(line.point(i / 200.0)).distance, 1e-12 * scale);
        }
    }
}

TEST(Foot, OnACircleIsRadial)
{
    const TargetLine line = circle(Vec3(1, 2, 3), 20);
    std::mt19937 sequence(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p = random_point(sequence, Vec3(-40, -40, -40), Vec3(40, 40, 40));
        const Vec3 radial = Vec3(p.x() - 1, p.y() - 2, 0).normalized();
        EXPECT_NEAR((line.foot(p).point - (Vec3(1, 2, 3) + 20 * radial)).norm(), 0, 1e-11);
        const auto feet = line.all_feet(p);
        ASSERT_EQ(feet.size(), 2u);
        EXPECT_NEAR((feet[1].point - (Vec3(1, 2, 3) - 20 * radial)).norm(), 0, 1e-10);
    }
}

TEST(Foot, AtACirclesCentreIsNotUnique)
{
    const TargetLine line = circle(Vec3(1, 2, 3), 20);
    const auto feet = line.all_feet(Vec3(1, 2, 3));
    EXPECT_GE(feet.size(), 4u);
    EXPECT_LT(feet.size(), 100u);
    for (const CurveFoot& foot : feet) {
        EXPECT_NEAR(foot.distance, 20, 1e-12);
    }
}

TEST(Foot, SaysWhenThePointLiesBeyondAnEnd)
{
    const TargetLine line = straight(Vec3(0, 0, 0), Vec3(10, 0, 0));
    EXPECT_TRUE(line.foot(Vec3(-1, 2, 0)).at_end);
    EXPECT_TRUE(line.foot(Vec3(10.5, 0, 0)).at_end);
    EXPECT_FALSE(line.foot(Vec3(0, 3, 0)).at_end);
    EXPECT_FALSE(line.foot(Vec3(10, 3, 0)).at_end);
    EXPECT_FALSE(line.foot(Vec3(4, 3, 0)).at_end);
    EXPECT_NEAR(line.foot(Vec3(4, 3, 0)).point.x(), 4, 1e-14);
    EXPECT_TRUE(line.all_feet(Vec3(-1, 2, 0)).empty());
    EXPECT_EQ(line.all_feet(Vec3(10, 3, 0)).size(), 1u);
    EXPECT_EQ(line.all_feet(Vec3(4, 3, 0)).size(), 1u);
}

TEST(AllFeet, FindsEveryCrossingOfTheNormalPlane)
{
    const TargetLine line = line_of(data_of_spatial_cubic());
    std::mt19937 sequence(11);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = random_point(sequence, Vec3(-20, -60, -60), Vec3(70, 60, 60));
        int crossings = 0;
        double previous = (p - line.point(0)).dot(line.tangent(0));
        for (int k = 1; k <= 20000; ++k) {
            const double now = (p - line.point(k / 20000.0)).dot(line.tangent(k / 20000.0));
            crossings += previous * now < 0 ? 1 : 0;
            previous = now;
        }
        const auto feet = line.all_feet(p);
        EXPECT_EQ(static_cast<int>(feet.size()), crossings) << p.transpose();
        for (const CurveFoot& foot : feet) {
            EXPECT_NEAR((p - foot.point).dot(foot.tangent), 0, 1e-10 * line.length());
        }
        EXPECT_TRUE(std::ranges::is_sorted(feet, {}, &CurveFoot::distance));
    }
}

TEST(Foot, IsTheSameFromSeveralThreads)
{
    const TargetLine line = line_of(data_of_spatial_cubic());
    std::mt19937 sequence(2);
    std::vector<Vec3> points;
    for (int i = 0; i < 5000; ++i) {
        points.push_back(random_point(sequence, Vec3(-20, -30, -30), Vec3(70, 30, 30)));
    }
    std::vector<double> together(points.size());
    parallel_for(
        static_cast<int>(points.size()), [&](int i) { together[i] = line.foot(points[i]).parameter; }, 16);
    for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(together[i], line.foot(points[i]).parameter);
    }
}

TEST(Foot, TakesMicrosecondsOnALongLine)
{
    BSplineData data{3, {0, 0, 0}, {}, {}, false};
    std::mt19937 sequence(9);
    constexpr int n = 10000;
    for (int i = 0; i < n; ++i) {
        data.control_points.push_back(Vec3(i, 0, 0) + random_point(sequence, Vec3(0, -2, -2), Vec3(0, 2, 2)));
    }
    for (int i = 0; i <= n - 3; ++i) {
        data.knots.push_back(i);
    }
    data.knots.insert(data.knots.end(), 3, n - 3.0);
    const TargetLine line = line_of(data);
    const std::clock_t start = std::clock(); // processor time: the machine may be busy
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        sum += line.foot(random_point(sequence, Vec3(0, -5, -5), Vec3(n, 5, 5))).distance;
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_GT(sum, 0);
    EXPECT_LT(seconds, 5) << "10000 feet on 10000 spans"; // about 0.1 s, with sanitizers 2 s
}

} // namespace
} // namespace tapeline
