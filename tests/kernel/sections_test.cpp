// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/sections.h"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

using namespace tapeline;

namespace {

constexpr double pi = std::numbers::pi;

/// A curve y(x) over [0, length] as a triangulation's section would show it: uneven points, each off the curve by up to
/// `zigzag`.
std::vector<Vec3> section_of(const std::function<double(double)>& y, double length, int points, double zigzag,
                             unsigned seed)
{
    std::mt19937 sequence(seed);
    const auto uniform = [&] { return sequence() / 4294967296.0; };
    std::vector<Vec3> polyline;
    for (int i = 0; i < points; ++i) {
        const bool end = i == 0 || i == points - 1;
        const double x = length * (i + (end ? 0 : 0.8 * (uniform() - 0.5))) / (points - 1);
        polyline.emplace_back(x, 0, y(x) - zigzag * uniform());
    }
    return polyline;
}

std::vector<Vec3> arc(double radius, double degrees, int segments)
{
    std::vector<Vec3> polyline;
    for (int i = 0; i <= segments; ++i) {
        const double a = degrees * pi / 180 * i / segments;
        polyline.emplace_back(radius * std::cos(a), 0, radius * std::sin(a));
    }
    return polyline;
}

const Vec3 across = Vec3::UnitY();

} // namespace

TEST(SectionShape, OfACircleArcTurnsByTheArcsAngle)
{
    for (const double angle : {1.0, 30.0, 90.0, 200.0}) {
        const SectionShape shape = section_shape(arc(100, angle, 40), across);
        EXPECT_NEAR(shape.turning, angle, 0.005 * angle);
        EXPECT_EQ(shape.inflections, 0);
    }
}

TEST(SectionShape, HasCurvatureVectorsOfOneOverRadiusTowardsTheCentre)
{
    const SectionShape shape = section_shape(arc(100, 60, 60), across);
    ASSERT_FALSE(shape.points.empty());
    for (size_t i = 0; i < shape.points.size(); ++i) {
        EXPECT_NEAR((shape.curvature[i] + shape.points[i] / 1e4).norm(), 0, 3e-4) << "sample " << i;
    }
}

TEST(SectionShape, OfAStraightLineIsStraightDespiteUnevenPoints)
{
    const SectionShape shape = section_shape(section_of([](double x) { return 0.3 * x; }, 300, 25, 0, 1), across);
    EXPECT_EQ(shape.inflections, 0);
    EXPECT_NEAR(shape.turning, 0, 1e-9);
}

TEST(SectionShape, OfARoughParabolaHasNoInflection)
{
    // 20 uneven segments, each point low by up to the sagitta of a 20 mm edge across the section.
    for (unsigned seed = 1; seed <= 300; ++seed) {
        const auto polyline = section_of([](double x) { return -x * x / 6000; }, 300, 21, 400.0 / 8 / 3000, seed);
        const SectionShape shape = section_shape(polyline, across);
        EXPECT_EQ(shape.inflections, 0) << "seed " << seed;
        EXPECT_NEAR(shape.turning, std::atan(0.1) * 180 / pi, 0.6) << "seed " << seed;
    }
}

TEST(SectionShape, FindsTheOneInflectionOfAFaintSBend)
{
    // 0.2 mm on 300 mm, among a zigzag of 0.015 mm.
    for (unsigned seed = 1; seed <= 300; ++seed) {
        const auto bend = [](double x) { return 0.2 * std::sin(2 * pi * x / 300); };
        const SectionShape shape = section_shape(section_of(bend, 300, 31, 0.015, seed), across);
        ASSERT_EQ(shape.inflections, 1) << "seed " << seed;
        EXPECT_NEAR(shape.inflection_points[0].x(), 150, 100) << "seed " << seed;
    }
}

TEST(SectionShape, CountsEveryBendOfAWave)
{
    for (const int waves : {1, 2, 3}) {
        const auto wave = [&](double x) { return 5 * std::cos(2 * pi * waves * x / 300); };
        EXPECT_EQ(section_shape(section_of(wave, 300, 61, 0.01, 7), across).inflections, 2 * waves) << waves;
    }
}

TEST(SectionShape, FollowsASectionThatFoldsOver)
{
    // Up a half circle and down the next: turns 180 degrees twice, one inflection.
    std::vector<Vec3> polyline;
    for (int i = 0; i <= 400; ++i) {
        const double a = pi - pi * i / 200;
        const Vec3 first(std::cos(a), 0, std::sin(a)), second(2 - std::cos(a), 0, std::sin(a));
        polyline.push_back(i <= 200 ? first : second);
    }
    const SectionShape shape = section_shape(polyline, across);
    EXPECT_EQ(shape.inflections, 1);
    EXPECT_NEAR(shape.turning, 360, 5);
}

TEST(SectionShape, IsTheSameReversedAndRotatedAndScaled)
{
    const auto bend = [](double x) { return 2 * std::sin(2 * pi * x / 300); };
    std::vector<Vec3> polyline = section_of(bend, 300, 31, 0.01, 3);
    const SectionShape shape = section_shape(polyline, across);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : polyline) {
        p = 1e-3 * (turn * p) + Vec3(5, -3, 2);
    }
    const SectionShape moved = section_shape(polyline, turn * across);
    EXPECT_EQ(moved.inflections, shape.inflections);
    EXPECT_NEAR(moved.turning, shape.turning, 1e-6);
    std::reverse(polyline.begin(), polyline.end());
    const SectionShape reversed = section_shape(polyline, turn * across);
    EXPECT_EQ(reversed.inflections, shape.inflections);
    EXPECT_NEAR(reversed.turning, shape.turning, 1e-6);
}

TEST(SectionShape, OfDegenerateInputIsStraight)
{
    EXPECT_EQ(section_shape({}, across).turning, 0);
    const std::vector<Vec3> same(5, Vec3(1, 2, 3));
    EXPECT_EQ(section_shape(same, across).turning, 0);
    const std::vector<Vec3> two{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)};
    EXPECT_EQ(section_shape(two, across).inflections, 0);
}
