// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/end_slide.h"
#include "tests/support/hand_made.h"
#include "tests/support/moves.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double pi = std::numbers::pi;

/// Flat [-200, 200] × [-100, 100] in edges of 5 mm; the line is y = 0, |x| ≤ 120.
struct Plane {
    Model model = model_of(grid(80, 40, -200, 200, -100, 100, [](double, double) { return 0.0; }));
    FeatureLine line;
    Region region = whole_mesh_region(model.mesh);
    Plane()
    {
        std::vector<int> vertices;
        for (int i = 16; i <= 64; ++i) {
            vertices.push_back(20 * 81 + i);
        }
        line = line_of(model, vertices);
    }
};

ParametricCurve level(double y)
{
    return {[=](double x) { return Vec3(x, y, 0); }, [](double) { return Vec3(1, 0, 0); }, -120, 120};
}

struct Slid {
    EndSlide slide;
    Correspondence before, after;
    ExtendedLine extended;
};

Slid slid(const TargetCurve& target, double length)
{
    const Plane plane;
    const Correspondence c = correspond(plane.model, plane.line, target).value();
    ExtendedLine extended = extend_line(plane.model, plane.region, c).value();
    Correspondence after = c;
    const EndSlide slide = slide_ends(extended, plane.model, plane.region.faces, target, {}, length, after).value();
    return {slide, c, after, std::move(extended)};
}

} // namespace

TEST(EndSlide, OfALineMovedSidewaysTakesAllTheRoomThatItMay)
{
    // A longer way back to the old line is always less bent: 3 s² / L³ for the cubic that ends on the border.
    const ParametricCurve target = level(20);
    const Slid end = slid(target, 15);
    EXPECT_NEAR(end.slide[0], 15, 1e-9);
    EXPECT_NEAR(end.slide[1], 15, 1e-9);
    EXPECT_NEAR(end.after.targets.front().x(), -105, 1e-9);
    EXPECT_NEAR(end.after.targets.back().x(), 105, 1e-9);
    for (size_t i = 0; i < end.after.targets.size(); ++i) {
        EXPECT_NEAR(target.foot(end.after.targets[i]).distance, 0, 1e-9);
        EXPECT_EQ(end.extended.targets[end.extended.first + i], end.after.targets[i]);
        const double from_end = 120 - std::abs(end.before.targets[i].x());
        if (from_end > 6 * 15) {
            EXPECT_EQ(end.after.targets[i], end.before.targets[i]);
        }
        if (i > 0) {
            EXPECT_GE(end.after.parameters[i] - end.after.parameters[i - 1], 5 * 0.7);
        }
    }
}

TEST(EndSlide, IsASixthOfTheLineAtMost)
{
    const Slid end = slid(level(20), 1000);
    EXPECT_NEAR(end.slide[0], 240.0 / 6, 1e-9);
    EXPECT_GT(end.slide[1], 15);
    EXPECT_LE(end.slide[1], 240.0 / 6 + 1e-9);
}

TEST(EndSlide, LeavesEndsThatDoNotMoveWhereTheyAre)
{
    const ParametricCurve bell{[](double x) { return Vec3(x, 10 * std::pow(std::cos(pi * x / 240), 2), 0); },
                               [](double x) { return Vec3(1, -10 * pi / 240 * std::sin(2 * pi * x / 240), 0); }, -120,
                               120};
    const Slid end = slid(bell, 5);
    EXPECT_EQ(end.slide, (EndSlide{0, 0}));
    for (size_t i = 0; i < end.after.targets.size(); ++i) {
        EXPECT_EQ(end.after.targets[i], end.before.targets[i]);
    }
}

TEST(EndSlide, IsNotAskedForByDefault)
{
    EXPECT_EQ(MoveOptions().end_slide_mm, 0);
    const Slid end = slid(level(20), 0);
    EXPECT_EQ(end.slide, (EndSlide{0, 0}));
    EXPECT_EQ(end.after.targets, end.before.targets);
}

TEST(EndSlide, IsReportedByTheMoveWhichStaysOnItsTarget)
{
    const Plane plane;
    const ParametricCurve target = level(20);
    MoveOptions options;
    options.end_slide_mm = 15;
    const auto [move, quality] = move_and_measure(plane.model, plane.line.vertices, target, options);
    EXPECT_NEAR(move.end_slide[0], 15, 1e-9);
    EXPECT_NEAR(move.end_slide[1], 15, 1e-9);
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
    EXPECT_EQ(quality.flipped, 0);
}
