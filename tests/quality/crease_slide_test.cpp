// SPDX-License-Identifier: GPL-3.0-or-later
// The reference case of the method: a 400 mm line on a creased panel slides by up to 100 mm on the surface. Plain ARAP
// (spokes and rims) bulges by 81 mm there and turns by 190°.
#include "tests/support/moves.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

struct Panel {
    int nx, ny;
    Diagonals diagonals;
    double slide;
    Method method = Method::plate_fl;
};

class CreaseSlide : public ::testing::TestWithParam<Panel> {};

MeasuredMove slide_panel(const Panel& panel)
{
    MoveOptions options;
    options.method = panel.method;
    const Model model = model_of(crease_panel(panel.nx, panel.ny, panel.diagonals));
    return move_and_measure(model, crease_panel_line(panel.nx, panel.ny), crease_slide_target(panel.slide), options);
}

} // namespace

TEST_P(CreaseSlide, LeavesNoBulgeInflectionOrFold)
{
    const auto [move, quality] = slide_panel(GetParam());
    EXPECT_TRUE(move.converged());
    EXPECT_EQ(move.placement.verdict, Placement::on_surface);
    EXPECT_EQ(move.placement.compressed, LineSide::left);
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
    EXPECT_LE(std::abs(quality.bulge_max_mm), 0.1);
    EXPECT_LE(quality.compressed_sections.inflections_after, quality.compressed_sections.inflections_before);
    EXPECT_EQ(quality.compressed_sections.inflections_after, 0);
    EXPECT_LE(quality.compressed_sections.turning_increase, 1);
    EXPECT_GE(quality.squash, 0.6);
    EXPECT_EQ(quality.flipped, 0);
    EXPECT_EQ(quality.self_intersections, 0);
    RecordProperty("bulge_mm", fmt::format("{}", quality.bulge_max_mm));
    RecordProperty("squash", fmt::format("{}", quality.squash));
}

namespace {

/// The panels under one method: every slide on the regular one, the largest ones on the others.
std::vector<Panel> panels(Method method)
{
    return {{60, 40, Diagonals::alternating, 25, method},    {60, 40, Diagonals::alternating, 50, method},
            {60, 40, Diagonals::alternating, 75, method},    {60, 40, Diagonals::alternating, 100, method},
            {60, 40, Diagonals::random, 50, method},         {60, 40, Diagonals::random, 100, method},
            {240, 160, Diagonals::alternating, 100, method}, {240, 160, Diagonals::random, 100, method}};
}

std::string name_of(const ::testing::TestParamInfo<Panel>& entry)
{
    return fmt::format("{}x{}{}Slide{}", entry.param.nx, entry.param.ny,
                       entry.param.diagonals == Diagonals::random ? "Irregular" : "Regular",
                       static_cast<int>(entry.param.slide));
}

} // namespace

INSTANTIATE_TEST_SUITE_P(PlateFl, CreaseSlide, ::testing::ValuesIn(panels(Method::plate_fl)), name_of);
INSTANTIATE_TEST_SUITE_P(AsanFl, CreaseSlide, ::testing::ValuesIn(panels(Method::asan_fl)), name_of);

TEST(CreaseSlideWithSpokesAndRims, BulgesSoThatTheMeasureSeesIt)
{
    const auto [move, quality] = slide_panel({60, 40, Diagonals::alternating, 100, Method::arap_sr});
    EXPECT_GT(quality.bulge_max_mm, 60);
    EXPECT_GT(quality.compressed_sections.turning_after, 100);
}

TEST(CreaseSlideAsPublished, RemovesMostOfTheBulge)
{
    const auto [move, quality] = slide_panel({60, 40, Diagonals::alternating, 100, Method::asan_fl_paper});
    EXPECT_TRUE(move.converged());
    EXPECT_LT(std::abs(quality.bulge_max_mm), 8);
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
}
