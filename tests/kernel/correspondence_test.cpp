// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/correspondence.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double pi = std::numbers::pi;

/// A flat sheet on [0, 400] × [-100, 100], cells of 10 mm, and its middle row as the line.
struct Sheet {
    Model model = model_of(grid(40, 20, 0, 400, -100, 100, [](double, double) { return 0.0; }));
    FeatureLine line = *line_through(model, [] {
        std::vector<int> row(41);
        std::iota(row.begin(), row.end(), 10 * 41);
        return row;
    }());
    Vec3 at(int i) const { return model.mesh.V.row(line.vertices[i]); }
};

ParametricCurve segment(const Vec3& from, const Vec3& to)
{
    return {[=](double t) -> Vec3 { return from + t * (to - from); }, [=](double) -> Vec3 { return to - from; }, 0, 1};
}

/// A circle about the z axis; angle runs from `first` over one turn.
ParametricCurve circle(double radius, double z, double first, int sense = 1)
{
    return {
        [=](double t) { return Vec3(radius * std::cos(sense * t), radius * std::sin(sense * t), z); },
        [=](double t) { return Vec3(-sense * radius * std::sin(sense * t), sense * radius * std::cos(sense * t), 0); },
        first, first + 2 * pi, true};
}

std::string message(const Result<Correspondence>& result) { return result ? "" : result.error().message; }

bool strictly_monotone(std::vector<double> values, bool reversed)
{
    if (reversed) {
        std::ranges::reverse(values);
    }
    return std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
}

} // namespace

TEST(Correspondence, SendsEachVertexToItsOrthogonalFoot)
{
    const Sheet sheet;
    const auto target = segment({-5, 30, 0}, {405, 50, 20});
    const auto moved = correspond(sheet.model, sheet.line, target);
    ASSERT_TRUE(moved) << message(moved);
    ASSERT_EQ(moved->line.vertices, sheet.line.vertices);
    for (size_t i = 1; i + 1 < moved->targets.size(); ++i) {
        EXPECT_NEAR(moved->displacements[i].dot(moved->tangents[i]), 0, 1e-9);
        EXPECT_EQ(moved->targets[i], target.point(moved->parameters[i]));
        EXPECT_EQ(moved->displacements[i], moved->targets[i] - sheet.at(static_cast<int>(i)));
    }
    EXPECT_TRUE(strictly_monotone(moved->parameters, false));
}

TEST(Correspondence, TrimsTheLineToAShorterTarget)
{
    const Sheet sheet;
    const auto target = segment({103, 30, 0}, {304, 30, 0});
    const auto moved = correspond(sheet.model, sheet.line, target);
    ASSERT_TRUE(moved) << message(moved);
    // The vertices nearest to the ends, x = 100 and 300, go exactly to the ends.
    EXPECT_EQ(moved->line.vertices.front(), sheet.line.vertices[10]);
    EXPECT_EQ(moved->line.vertices.back(), sheet.line.vertices[30]);
    EXPECT_EQ(moved->parameters.front(), 0);
    EXPECT_EQ(moved->parameters.back(), 1);
    EXPECT_EQ(moved->targets.front(), target.point(0));
    EXPECT_EQ(moved->before.size(), 10U);
    EXPECT_EQ(moved->before.front(), sheet.line.vertices[9]);
    EXPECT_EQ(moved->after.front(), sheet.line.vertices[31]);
    EXPECT_EQ(moved->after.back(), sheet.line.vertices[40]);
    EXPECT_NEAR(moved->line.length_mm, 200, 1e-9);
    EXPECT_TRUE(moved->warnings.empty());
}

TEST(Correspondence, GoesOnWithTheRestOfALongerLine)
{
    const Sheet sheet;
    FeatureLine whole = sheet.line;
    whole.id = 0;
    const auto part = select_line(sheet.model, {whole}, "0@50..350");
    ASSERT_TRUE(part);
    const auto moved = correspond(sheet.model, *part, segment({100, 30, 0}, {300, 30, 0}));
    ASSERT_TRUE(moved) << message(moved);
    EXPECT_EQ(moved->line.id, 0);
    ASSERT_EQ(moved->before.size(), 10U);
    EXPECT_EQ(moved->before.back(), sheet.line.vertices.front());
    ASSERT_EQ(moved->after.size(), 10U);
    EXPECT_EQ(moved->after.back(), sheet.line.vertices.back());
}

TEST(Correspondence, FindsATargetThatRunsAgainstTheLine)
{
    const Sheet sheet;
    const auto forward = correspond(sheet.model, sheet.line, segment({103, 30, 0}, {304, 35, 0}));
    const auto backward = correspond(sheet.model, sheet.line, segment({304, 35, 0}, {103, 30, 0}));
    ASSERT_TRUE(forward && backward);
    EXPECT_FALSE(forward->reversed);
    EXPECT_TRUE(backward->reversed);
    EXPECT_EQ(forward->line.vertices, backward->line.vertices);
    for (size_t i = 0; i < forward->targets.size(); ++i) {
        EXPECT_NEAR((forward->targets[i] - backward->targets[i]).norm(), 0, 1e-9);
        EXPECT_NEAR((forward->tangents[i] - backward->tangents[i]).norm(), 0, 1e-12);
    }
    EXPECT_TRUE(strictly_monotone(backward->parameters, true));
}

TEST(Correspondence, WarnsOfTheUnusedEndOfALongerTarget)
{
    const Sheet sheet;
    const auto moved = correspond(sheet.model, sheet.line, segment({-60, 30, 0}, {400, 30, 0}));
    ASSERT_TRUE(moved);
    ASSERT_EQ(moved->warnings.size(), 1U);
    EXPECT_NE(moved->warnings[0].find("60 mm"), std::string::npos) << moved->warnings[0];
    EXPECT_NEAR(moved->targets.front().x(), 0, 1e-9);
}

TEST(Correspondence, OnTheCreasePanelIsOrthogonalWhileTheBendsAreGentle)
{
    for (const double s : {25.0, 50.0, -50.0}) {
        for (const int nx : {60, 61}) {
            const Model model = model_of(crease_panel(nx, 40));
            const auto line = line_through(model, crease_panel_line(nx, 40));
            const auto moved = correspond(model, *line, crease_slide_target(s));
            ASSERT_TRUE(moved) << message(moved);
            EXPECT_NEAR(moved->targets.front().x(), -200, 1e-12);
            EXPECT_NEAR(moved->targets.back().x(), 200, 1e-12);
            EXPECT_TRUE(strictly_monotone(moved->parameters, false));
            EXPECT_TRUE(moved->warnings.empty());
            for (size_t i = 1; i + 1 < moved->targets.size(); ++i) {
                EXPECT_NEAR(moved->displacements[i].normalized().dot(moved->tangents[i]), 0, 1e-6);
            }
        }
    }
}

TEST(Correspondence, BridgesTheStretchBeyondTheCentreOfCurvature)
{
    // At 100 mm the target's apex has a radius of 81 mm: vertices below it have two nearest feet.
    for (const int nx : {60, 61, 240}) {
        const Model model = model_of(crease_panel(nx, 40));
        const auto line = line_through(model, crease_panel_line(nx, 40));
        const auto target = crease_slide_target(100);
        const auto moved = correspond(model, *line, target);
        ASSERT_TRUE(moved) << message(moved);
        ASSERT_EQ(moved->warnings.size(), 1U);
        const size_t n = moved->parameters.size();
        double least = 1e9, most = 0;
        for (size_t i = 0; i + 1 < n; ++i) {
            const double step = target.arc_length(moved->parameters[i + 1]) - target.arc_length(moved->parameters[i]);
            least = std::min(least, step * nx / 800);
            most = std::max(most, step * nx / 800);
            EXPECT_NEAR(moved->parameters[i], -moved->parameters[n - 1 - i], 1e-6) << "line and target are symmetric";
        }
        EXPECT_GT(least, 0.5);
        EXPECT_LT(most, 2);
    }
}

TEST(Correspondence, GoesRoundAClosedTargetOnce)
{
    const Model model = model_of(cylinder(36, 4, 10, 40));
    const auto lines = find_feature_lines(model);
    for (const double first : {0.0, 1.234}) {
        for (const int sense : {1, -1}) {
            const auto target = circle(12, 3, first, sense);
            const auto moved = correspond(model, lines[0], target);
            ASSERT_TRUE(moved) << message(moved);
            ASSERT_EQ(moved->targets.size(), 36U);
            EXPECT_TRUE(moved->before.empty() && moved->after.empty());
            double turned = 0;
            for (size_t i = 0; i < 36; ++i) {
                const Vec3 p = model.mesh.V.row(moved->line.vertices[i]);
                EXPECT_NEAR((moved->targets[i] - Vec3(1.2 * p.x(), 1.2 * p.y(), 3)).norm(), 0, 1e-6);
                const double step = moved->parameters[(i + 1) % 36] - moved->parameters[i];
                turned += std::remainder(step, 2 * pi);
                EXPECT_EQ(std::remainder(step, 2 * pi) < 0, moved->reversed);
                const Vec3 along = Vec3(model.mesh.V.row(moved->line.vertices[(i + 1) % 36])) - p;
                EXPECT_GT(along.normalized().dot(moved->tangents[i]), 0.9);
            }
            EXPECT_NEAR(std::abs(turned), 2 * pi, 1e-9);
        }
    }
}

TEST(Correspondence, RefusesToMixOpenAndClosed)
{
    const Sheet sheet;
    EXPECT_NE(message(correspond(sheet.model, sheet.line, circle(50, 0, 0))).find("closed"), std::string::npos);
    const Model model = model_of(cylinder(36, 4, 10, 40));
    const auto lines = find_feature_lines(model);
    EXPECT_NE(message(correspond(model, lines[0], segment({0, 0, 0}, {1, 0, 0}))).find("open"), std::string::npos);
}

TEST(Correspondence, RefusesAFootThatIsNotUnique)
{
    // The line runs along the middle of a long hairpin: both legs are equally near everywhere.
    const Sheet sheet;
    const auto hairpin = ParametricCurve(
        [](double t) {
            const double bend = 30 * pi;
            return t < 600          ? Vec3(600 - t - 50, -30, 0)
                   : t < 600 + bend ? Vec3(-50 - 30 * std::sin((t - 600) / 30), -30 * std::cos((t - 600) / 30), 0)
                                    : Vec3(t - 600 - bend - 50, 30, 0);
        },
        [](double t) {
            const double bend = 30 * pi;
            return t < 600          ? Vec3(-1, 0, 0)
                   : t < 600 + bend ? Vec3(-std::cos((t - 600) / 30), std::sin((t - 600) / 30), 0)
                                    : Vec3(1, 0, 0);
        },
        0, 1200 + 30 * pi);
    const auto moved = correspond(sheet.model, sheet.line, hairpin);
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error().kind, ErrorKind::rejected);
    EXPECT_NE(message(moved).find("not unique"), std::string::npos) << message(moved);
    EXPECT_NE(message(moved).find("line vertex 410 at (0, 0, 0)"), std::string::npos) << message(moved);
    EXPECT_NE(message(moved).find("arc_length"), std::string::npos);
    EXPECT_TRUE(correspond(sheet.model, sheet.line, hairpin, {CorrespondenceMode::arc_length, 0}));
}

TEST(Correspondence, RefusesTargetsThatDoNotRunBesideTheLine)
{
    const Sheet sheet;
    EXPECT_FALSE(correspond(sheet.model, sheet.line, segment({500, 30, 0}, {900, 30, 0})));
    EXPECT_FALSE(correspond(sheet.model, sheet.line, segment({200, 30, 0}, {200, 90, 0})));
    const auto tiny = correspond(sheet.model, sheet.line, segment({200, 30, 0}, {208, 30, 0}));
    EXPECT_NE(message(tiny).find("two are needed"), std::string::npos) << message(tiny);
}

TEST(Correspondence, RefusesALineWithOneEdge)
{
    const Sheet sheet;
    const auto line = line_through(sheet.model, {410, 411});
    const auto moved = correspond(sheet.model, *line, segment({0, 30, 0}, {10, 30, 0}));
    EXPECT_NE(message(moved).find("1 edge"), std::string::npos) << message(moved);
}

TEST(Correspondence, RefusesATargetBeyondTheLimit)
{
    const Sheet sheet;
    const auto target = segment({0, 30, 0}, {400, 90, 0});
    EXPECT_TRUE(correspond(sheet.model, sheet.line, target, {CorrespondenceMode::projection, 95}));
    const auto moved = correspond(sheet.model, sheet.line, target, {CorrespondenceMode::projection, 60});
    EXPECT_NE(message(moved).find("more than the allowed 60 mm"), std::string::npos) << message(moved);
}

TEST(Correspondence, ByArcLengthTakesEqualFractionsInTheNearerSense)
{
    const Sheet sheet;
    const Vec3 from(380, 80, 0), to(-20, 20, 0);
    const auto moved = correspond(sheet.model, sheet.line, segment(from, to), {CorrespondenceMode::arc_length, 0});
    ASSERT_TRUE(moved);
    EXPECT_TRUE(moved->reversed);
    for (int i = 0; i <= 40; ++i) {
        EXPECT_NEAR((moved->targets[i] - (to + i / 40.0 * (from - to))).norm(), 0, 1e-6);
        EXPECT_GT(moved->tangents[i].x(), 0);
    }
    EXPECT_EQ(moved->parameters.front(), 1);
    EXPECT_EQ(moved->parameters.back(), 0);
}
