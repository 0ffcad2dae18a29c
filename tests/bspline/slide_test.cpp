// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/fit.h"
#include "bspline/slide.h"
#include "kernel/closest_point.h"
#include "tests/bspline/curves.h"
#include "tests/bspline/surfaces.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace tapeline {
namespace {

using testing::crease_panel;
using testing::crease_panel_height;
using testing::cylinder;
using testing::Diagonals;
using testing::grid;
using testing::sphere;
using testing::straight;

constexpr double pi = std::numbers::pi;
double flat(double, double) { return 0; }

SlideLaw constant(double distance) { return {{{0.0, distance}}}; }

TargetLine fitted(int n, bool closed, const std::function<Vec3(double)>& curve)
{
    std::vector<Vec3> points;
    for (int i = 0; i < n + (closed ? 0 : 1); ++i) {
        points.push_back(curve(static_cast<double>(i) / n));
    }
    const auto line = fit_polyline(points, closed, {0, 1e-4, 3});
    if (!line) {
        throw std::runtime_error(line.error().message);
    }
    return *line;
}

void expect_each(const TargetLine& line, const std::function<double(const Vec3&)>& error, double limit)
{
    for (int i = 0; i <= 200; ++i) {
        const Vec3 p = line.point(line.first_parameter() + (line.last_parameter() - line.first_parameter()) * i / 200);
        EXPECT_LE(std::abs(error(p)), limit) << p.transpose();
    }
}

TEST(Slide, OnAPlaneIsTheParallelLine)
{
    const Mesh plane = grid(31, 17, -100, 100, -60, 60, flat, Diagonals::random);
    const TargetLine line = straight(Vec3(-80, 3, 0), Vec3(80, -9, 0));
    const Vec3 left = Vec3(12, 160, 0).normalized();
    for (const double distance : {25.0, -25.0, 1e-3}) {
        const auto slid = slide_on_surface(line, plane, constant(distance));
        ASSERT_TRUE(slid) << slid.error().message;
        EXPECT_NEAR((slid->point(slid->first_parameter()) - (Vec3(-80, 3, 0) + distance * left)).norm(), 0, 1e-7);
        expect_each(
            *slid, [&](const Vec3& p) { return (p - Vec3(-80, 3, 0)).dot(left) - distance; }, 1e-6);
        expect_each(
            *slid, [](const Vec3& p) { return p.z(); }, 1e-9);
    }
}

TEST(Slide, OnAPlaneIsTheOffsetOfAnArc)
{
    const Mesh plane = grid(40, 40, -100, 100, -100, 100, flat, Diagonals::random);
    const TargetLine arc = fitted(100, false, [](double t) { return Vec3(60 * std::cos(t), 60 * std::sin(t), 0); });
    // Counter-clockwise, so the left is towards the centre.
    const auto slid = slide_on_surface(arc, plane, constant(15));
    ASSERT_TRUE(slid) << slid.error().message;
    expect_each(
        *slid, [](const Vec3& p) { return p.norm() - 45; }, 2e-3);
    const auto folded = slide_on_surface(arc, plane, constant(70));
    ASSERT_FALSE(folded);
    EXPECT_NE(folded.error().message.find("folds"), std::string::npos) << folded.error().message;
}

TEST(Slide, OnACylinderGoesRoundByTheAngle)
{
    // Radius 50 about x; the line runs along x at the top, so its left is towards +y.
    const Mesh tube = cylinder(50, 200, 60, 360);
    const TargetLine line = straight(Vec3(10, 0, 50), Vec3(190, 0, 50));
    const double angle = 40.0 / 50;
    const auto slid = slide_on_surface(line, tube, constant(40));
    ASSERT_TRUE(slid) << slid.error().message;
    expect_each(
        *slid,
        [&](const Vec3& p) { return (Vec3(0, p.y(), p.z()) - 50 * Vec3(0, std::sin(angle), std::cos(angle))).norm(); },
        0.01); // the facets' chord height is 50 (1 - cos(0.5°)) = 0.002
}

TEST(Slide, OfASpheresEquatorIsAParallelOfLatitude)
{
    const Mesh ball = sphere(100, 90);
    const TargetLine equator =
        fitted(200, true, [](double t) { return Vec3(100 * std::cos(2 * pi * t), 100 * std::sin(2 * pi * t), 0); });
    for (const double distance : {30.0, -50.0}) {
        const auto slid = slide_on_surface(equator, ball, constant(distance));
        ASSERT_TRUE(slid) << slid.error().message;
        EXPECT_TRUE(slid->closed());
        const double latitude = distance / 100;
        expect_each(
            *slid, [&](const Vec3& p) { return p.z() - 100 * std::sin(latitude); }, 0.05);
        expect_each(
            *slid, [&](const Vec3& p) { return p.head<2>().norm() - 100 * std::cos(latitude); }, 0.05);
    }
}

TEST(Slide, AlongACreaseUsesTheSideItGoesTo)
{
    // A roof: the line on its ridge slides down one flank or the other, by the distance measured on the flank.
    for (const double slope : {0.3, -0.3, 2.0, -2.0}) {
        const Mesh roof = grid(41, 30, -200, 200, -100, 100, [&](double, double y) { return -slope * std::abs(y); },
                               Diagonals::random, {15});
        const TargetLine ridge = straight(Vec3(-150, 0, 0), Vec3(150, 0, 0));
        for (const double distance : {37.0, -37.0}) {
            const auto slid = slide_on_surface(ridge, roof, constant(distance));
            ASSERT_TRUE(slid) << slid.error().message;
            const double y = distance / std::hypot(1, slope);
            expect_each(
                *slid, [&](const Vec3& p) { return p.y() - y; }, 1e-6);
            expect_each(
                *slid, [&](const Vec3& p) { return p.z() + slope * std::abs(y); }, 1e-6);
        }
    }
}

TEST(Slide, FollowsItsLawOnTheCreasePanel)
{
    const Mesh panel = testing::crease_panel(120, 80, Diagonals::random);
    const TargetLine crease =
        fitted(100, false, [](double t) { return Vec3(800 * t - 400, 0, -std::pow(800 * t - 400, 2) / 12000); });
    const SlideLaw law{{{0, 0}, {0.25, 0}, {0.5, 60}, {0.75, 0}, {1, 0}}};
    const auto slid = slide_on_surface(crease, panel, law);
    ASSERT_TRUE(slid) << slid.error().message;
    const ClosestPoint surface(panel);
    expect_each(
        *slid, [&](const Vec3& p) { return surface.closest(p).distance; }, 0.01);
    const double middle = slid->point(slid->parameter_at(slid->length() / 2)).y();
    EXPECT_NEAR(middle, 59.6, 0.3); // 60 along a flank that falls by 6° and more
    EXPECT_NEAR(slid->point(slid->first_parameter()).y(), 0, 1e-9);
    expect_each(
        *slid, [](const Vec3& p) { return std::min(p.y(), 0.0); }, 0.05);
}

TEST(Slide, HasTheNumberOfControlPointsAskedForAndSaysHowFarItStrays)
{
    const Mesh mesh = crease_panel(64, 48);
    const TargetLine line = *interpolate_points({{-240, 0, crease_panel_height(-240, 0)},
                                                 {-80, 0, crease_panel_height(-80, 0)},
                                                 {80, 0, crease_panel_height(80, 0)},
                                                 {240, 0, crease_panel_height(240, 0)}},
                                                false);
    const SlideLaw law{{{0, 0}, {0.25, 20}, {0.5, 30}, {0.75, 20}, {1, 0}}};
    double before = 1e9;
    for (const int count : {5, 8, 14}) {
        double off = -1;
        const auto slid = slide_on_surface(line, mesh, law, 0, nullptr, count, &off);
        ASSERT_TRUE(slid) << slid.error().message;
        EXPECT_EQ(slid->data().control_points.size(), static_cast<size_t>(count));
        const ClosestPoint surface(mesh);
        for (int k = 0; k <= 100; ++k) {
            const Vec3 p = slid->point(slid->parameter_at(slid->length() * k / 100));
            EXPECT_LE(surface.closest(p).distance, 1.02 * off);
        }
        EXPECT_LT(off, before);
        before = off;
    }
    EXPECT_LT(before, 0.2);
    const auto refused = slide_on_surface(line, mesh, law, 0.01, nullptr, 5);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("allow more"), std::string::npos) << refused.error().message;
}

TEST(Slide, OfALineToTheBordersFollowsThem)
{
    const Mesh panel = testing::crease_panel(60, 40, Diagonals::random);
    const TargetLine crease =
        fitted(100, false, [](double t) { return Vec3(800 * t - 400, 0, -std::pow(800 * t - 400, 2) / 12000); });
    for (const double distance : {50.0, -120.0}) {
        const auto slid = slide_on_surface(crease, panel, constant(distance));
        ASSERT_TRUE(slid) << slid.error().message;
        EXPECT_NEAR(slid->point(slid->first_parameter()).x(), -400, 1e-9);
        EXPECT_NEAR(slid->point(slid->last_parameter()).x(), 400, 1e-9);
    }
}

TEST(Slide, FollowsABorderThatLeansAgainstIt)
{
    // The plane ends at x = ±100 ∓ y / 5: paths along +y run into the border at 11°.
    Mesh plane = grid(40, 30, -1, 1, 0, 100, flat, Diagonals::random);
    for (int i = 0; i < plane.V.rows(); ++i) {
        plane.V(i, 0) *= 100 - plane.V(i, 1) / 5;
    }
    const auto slid = slide_on_surface(straight(Vec3(-98, 10, 0), Vec3(98, 10, 0)), plane, constant(60));
    ASSERT_TRUE(slid) << slid.error().message;
    const Vec3 border = Vec3(1, 5, 0).normalized();
    const Vec3 end = Vec3(-98, 10, 0) + 60 * border;
    EXPECT_NEAR((slid->point(slid->first_parameter()) - end).norm(), 0, 1e-7);
    for (int i = 0; i <= 100; ++i) {
        EXPECT_NEAR(slid->point(slid->parameter_at(slid->length() * i / 100)).y(), 70, 60 - 60 * border.y() + 0.01);
    }
}

TEST(Slide, MovesWithTheModel)
{
    Mesh panel = testing::crease_panel(60, 40, Diagonals::random);
    const auto crease = [](double t) { return Vec3(700 * t - 350, 0, -std::pow(700 * t - 350, 2) / 12000); };
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.1, Vec3(1, -2, 3).normalized()).toRotationMatrix();
    const Vec3 shift(700, -200, 1100);
    const auto a = slide_on_surface(fitted(100, false, crease), panel, constant(40));
    panel.V = ((panel.V * turn.transpose()).rowwise() + shift.transpose()).eval();
    const auto b = slide_on_surface(fitted(100, false, [&](double t) -> Vec3 { return turn * crease(t) + shift; }),
                                    panel, constant(40));
    ASSERT_TRUE(a && b);
    for (int i = 0; i <= 100; ++i) {
        EXPECT_LE((b->point(i / 100.0) - (turn * a->point(i / 100.0) + shift)).norm(), 1e-5);
    }
}

TEST(Slide, RefusesWhatItCannotDo)
{
    const Mesh plane = grid(20, 20, -100, 100, -100, 100, flat);
    const TargetLine line = straight(Vec3(-80, 0, 0), Vec3(80, 0, 0));
    const auto refuse = [&](const TargetLine& what, const Mesh& mesh, const SlideLaw& law, const std::string& word) {
        const auto slid = slide_on_surface(what, mesh, law);
        ASSERT_FALSE(slid) << word;
        EXPECT_NE(slid.error().message.find(word), std::string::npos) << slid.error().message;
    };
    refuse(line, plane, constant(150), "border");
    refuse(line, plane, {}, "empty");
    refuse(line, plane, {{{0, 1}, {0, 2}}}, "ascend");
    refuse(line, plane, {{{0, 1}, {2, 2}}}, "fraction");
    refuse(line, plane, constant(std::numeric_limits<double>::quiet_NaN()), "finite");
    refuse(line, Mesh(), constant(1), "triangles");
    refuse(straight(Vec3(-80, 0, 50), Vec3(80, 0, 50)), plane, constant(1), "off the model");
    refuse(straight(Vec3(0, 0, 0), Vec3(0, 0, 1)), plane, constant(1), "upright");
    refuse(testing::circle(Vec3::Zero(), 50), plane, {{{0, 1}, {1, 2}}}, "closed");
    EXPECT_FALSE(slide_on_surface(line, plane, constant(1), -1));
}

} // namespace
} // namespace tapeline
