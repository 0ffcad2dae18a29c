// SPDX-License-Identifier: GPL-3.0-or-later
// A second crease beside the line that moves: sharp enough to be a line, too blunt to stop a slide by itself.
#include "kernel/inner_lines.h"
#include "tests/support/moves.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 40, ny = 40, line_row = 16, other_row = 24;
constexpr double y_line = -60 + 20, y_other = y_line + 80; // 10 mm a cell, y from -200 to 200

/// Two creases along x: of 20° where the line lies, of 14° to the left of it.
double height(double /*x*/, double y) { return 0.35 * std::min(y - y_line, 0.0) - 0.25 * std::max(y - y_other, 0.0); }

std::vector<int> row(int j)
{
    std::vector<int> vertices;
    for (int i = 0; i <= nx; ++i) {
        vertices.push_back(j * (nx + 1) + i);
    }
    return vertices;
}

struct TwoCreases {
    Model model = model_of(grid(nx, ny, -200, 200, -200, 200, height, Diagonals::alternating, {line_row, other_row}));
    FeatureLine line = line_of(model, row(line_row));

    /// The line moved by `slide` to the left in its middle, laid on the surface.
    static ParametricCurve target(double slide)
    {
        return {[=](double x) -> Vec3 {
                    const double c = std::cos(M_PI * x / 400), y = y_line + slide * c * c;
                    return {x, y, height(x, y)};
                },
                [=](double x) -> Vec3 {
                    const double s = -slide * M_PI / 400 * std::sin(M_PI * x / 200);
                    const double y = y_line + slide * std::pow(std::cos(M_PI * x / 400), 2);
                    return Vec3(1, s, s * (y < y_line ? 0.35 : y > y_other ? -0.25 : 0)).normalized();
                },
                -200, 200};
    }

    Result<MoveResult> move(double slide, const RegionOptions& lines, Method method = Method::asan_fl) const
    {
        RegionOptions options = lines;
        options.box = Eigen::AlignedBox3d(Vec3(-201, -161, -300), Vec3(201, 161, 300));
        return make_region(model, line, {}, options).and_then([&](const Region& region) {
            MoveOptions how;
            how.method = method;
            return move_feature_line(model, line, target(slide), region, how);
        });
    }

    std::vector<InnerLine> measure(const MoveResult& move) const
    {
        NamedLine other{7, {}};
        for (const int v : row(other_row)) {
            other.points.push_back(model.mesh.V.row(v));
        }
        return measure_inner_lines(move, {other});
    }
};

RegionOptions keeping(std::vector<int> chain = row(other_row))
{
    RegionOptions options;
    options.kept_lines = {std::move(chain)};
    return options;
}

RegionOptions holding()
{
    RegionOptions options;
    options.held_lines = {row(other_row)};
    return options;
}

} // namespace

TEST(InnerLines, AreReportedByNumberAndSlideAlongThemselves)
{
    const TwoCreases creases;
    for (const Method method : {Method::asan_fl, Method::plate_fl}) {
        const auto moved = creases.move(40, {}, method);
        ASSERT_TRUE(moved) << moved.error().message;
        ASSERT_EQ(moved->placement.compressed, LineSide::left);
        const auto lines = creases.measure(*moved);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].id, 7);
        EXPECT_EQ(lines[0].role, InnerLineRole::slides);
        EXPECT_NEAR(lines[0].length_mm, 400, 1e-9);
        EXPECT_NEAR(lines[0].crease_before, std::atan(0.25) * 180 / M_PI, 1e-9);
        EXPECT_LT(lines[0].crease_change_max, 0.1);
        EXPECT_LT(lines[0].off_line_mm, 1e-6);
    }
}

TEST(InnerLines, OnTheStretchedSideFollowTheSurfaceAndTheirCreaseIsMeasured)
{
    const TwoCreases creases;
    const auto moved = creases.move(-40, {}, Method::plate_fl);
    ASSERT_TRUE(moved) << moved.error().message;
    const auto lines = creases.measure(*moved);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].role, InnerLineRole::follows);
    EXPECT_LT(std::abs(lines[0].crease_after - lines[0].crease_before), 2);
}

TEST(InnerLines, HeldOnesDoNotMoveAtAll)
{
    const TwoCreases creases;
    for (const double slide : {40.0, -40.0}) {
        const auto moved = creases.move(slide, holding());
        ASSERT_TRUE(moved) << moved.error().message;
        for (const int v : row(other_row)) {
            EXPECT_TRUE(moved->V.row(v) == creases.model.mesh.V.row(v)) << v;
        }
        const auto lines = creases.measure(*moved);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].role, InnerLineRole::held);
        EXPECT_EQ(lines[0].off_line_mm, 0);
        EXPECT_EQ(moved->retraction.flipped, 0);
    }
}

TEST(InnerLines, KeptOnesAreNotDraggedOverByATargetThatCrossesThem)
{
    const TwoCreases creases;
    const auto dragged = creases.move(100, {});
    ASSERT_TRUE(dragged) << dragged.error().message;
    EXPECT_GT(creases.measure(*dragged).front().off_line_mm, 1);
    for (const RegionOptions& lines : {keeping(), holding()}) {
        const auto refused = creases.move(100, lines);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().message.find("crosses another feature line"), std::string::npos)
            << refused.error().message;
    }
}

TEST(InnerLines, MayBeAnyChainOfEdgesWithoutACrease)
{
    const TwoCreases creases;
    const std::vector<int> flat = row(20);
    const auto free = creases.move(30, {});
    const auto kept = creases.move(30, keeping(flat));
    ASSERT_TRUE(free && kept);
    double off_free = 0, off_kept = 0;
    for (const int v : flat) {
        off_free = std::max(off_free, std::abs(free->V(v, 1) - creases.model.mesh.V(v, 1)));
        off_kept = std::max(off_kept, std::abs(kept->V(v, 1) - creases.model.mesh.V(v, 1)));
    }
    EXPECT_GT(off_free, 5);
    EXPECT_LT(off_kept, 1e-9);
}

TEST(InnerLines, OutsideTheRegionAreWarnedOf)
{
    const TwoCreases creases;
    const auto moved = creases.move(40, keeping(row(ny - 1)));
    ASSERT_TRUE(moved) << moved.error().message;
    EXPECT_TRUE(std::ranges::any_of(moved->warnings, [](const std::string& warning) {
        return warning.find("lies outside the region") != std::string::npos;
    }));
}
