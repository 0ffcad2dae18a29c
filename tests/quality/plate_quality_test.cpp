// SPDX-License-Identifier: GPL-3.0-or-later
// What a stylist sees at once: a crease where the region ends, a tension side pulled straight, an inflection. The
// crease-slide panel with surroundings, so that all four rims of the region are inside the model.
#include "plugin/runner/job_file.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/runner.h"
#include "tests/support/moves.h"
#include "tests/support/wide_panel.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;
namespace fs = std::filesystem;

namespace {

/// Enough that none falls between two of them.
constexpr int sections = 45;

MeasuredMove move_panel(const WidePanel& panel, const TargetCurve& target, const MoveOptions& options,
                        int stations = sections)
{
    MoveResult moved = move_line(panel, target, options);
    QualityInput input = quality_input(moved, target);
    input.stations = stations;
    auto quality = measure_quality(input);
    if (!quality) {
        throw std::runtime_error(quality.error().message);
    }
    return {std::move(moved), *quality};
}

MeasuredMove slide_panel(const WidePanel& panel, double slide, Method method, LineCrease crease = LineCrease::free)
{
    MoveOptions options;
    options.method = method;
    options.line_crease = crease;
    if (method == Method::asan_fl) {
        options.rim = RimControl::position; // what its own energy does at the rim, which the plate is compared with
    }
    return move_panel(panel, crease_slide_target(slide), options, crease == LineCrease::keep ? 9 : sections);
}

struct Slide {
    Diagonals diagonals;
    double mm;
};

class PlatePanel : public ::testing::TestWithParam<Slide> {};

const auto slides = ::testing::Values(Slide{Diagonals::alternating, 25}, Slide{Diagonals::alternating, 50},
                                      Slide{Diagonals::alternating, 75}, Slide{Diagonals::alternating, 100},
                                      Slide{Diagonals::random, 50}, Slide{Diagonals::random, 100});

std::string slide_name(const ::testing::TestParamInfo<Slide>& entry)
{
    return fmt::format("{}Slide{}", entry.param.diagonals == Diagonals::random ? "Irregular" : "Regular",
                       static_cast<int>(entry.param.mm));
}

} // namespace

TEST_P(PlatePanel, KeepsTheTangentAtTheRimAndTheCrownWithoutAnInflection)
{
    const WidePanel panel(GetParam().diagonals);
    const auto [move, plate] = slide_panel(panel, GetParam().mm, Method::plate_fl);
    const auto [other, asan] = slide_panel(panel, GetParam().mm, Method::asan_fl);
    EXPECT_TRUE(move.converged());
    EXPECT_LE(plate.rim_crease_mean_change, 0.5);
    EXPECT_LE(plate.rim_crease_max_change, 1.5);
    EXPECT_LE(plate.rim_crease_max_change, 0.2 * asan.rim_crease_max_change);
    ASSERT_TRUE(plate.crown && asan.crown);
    EXPECT_LE(std::abs(plate.crown->change), std::abs(asan.crown->change) / 3);
    EXPECT_LE(plate.crown->local, 0.4 * asan.crown->local);
    EXPECT_EQ(plate.tension_sections.inflections_after, 0);
    EXPECT_EQ(plate.compressed_sections.inflections_after, 0);
    EXPECT_LE(std::abs(plate.bulge_max_mm), 0.1);
    EXPECT_GE(plate.squash, std::min(0.6, asan.squash - 1e-4));
    EXPECT_EQ(plate.flipped, 0);
    EXPECT_EQ(plate.self_intersections, 0);
    EXPECT_LE(plate.line_error_max_mm, 1e-9);
}

TEST(PlatePanelOfFineTriangles, HasNoInflectionThatCoarseOnesWouldHide)
{
    const WidePanel panel(Diagonals::alternating, 140, 112);
    for (const double slide : {50, 100}) {
        const auto [move, plate] = slide_panel(panel, slide, Method::plate_fl);
        EXPECT_EQ(plate.tension_sections.inflections_after, 0) << slide;
        EXPECT_EQ(plate.compressed_sections.inflections_after, 0) << slide;
    }
}

TEST(PlatePanelOfCad, HasNoInflectionInAnySectionAndKeepsTheTangentAtTheRim)
{
    // Where the line's S begins, an answer to its curving that is larger than the section's own curvature turns it over.
    for (const double edge : {12, 9}) {
        auto job = read_job(fs::path(TAPELINE_SOURCE_DIR) / "resources/jobs/panel.json");
        ASSERT_TRUE(job) << job.error().message;
        job->remesh.max_edge = edge;
        const auto done = solve_job(*job, {});
        ASSERT_TRUE(done) << done.error().message;
        QualityInput input = quality_input(done->move, done->preparation.target->line);
        input.stations = sections;
        const auto quality = measure_quality(input);
        ASSERT_TRUE(quality) << quality.error().message;
        EXPECT_EQ(quality->tension_sections.inflections_after, 0) << edge;
        EXPECT_EQ(quality->compressed_sections.inflections_after, 0) << edge;
        EXPECT_LE(quality->rim_crease_mean_change, 0.5);
        EXPECT_LE(quality->rim_crease_max_change, 1.5);
    }
}

TEST_P(PlatePanel, KeepsTheCreaseAngleWhenAsked)
{
    const WidePanel panel(GetParam().diagonals);
    const auto [move, plate] = slide_panel(panel, GetParam().mm, Method::plate_fl, LineCrease::keep);
    EXPECT_TRUE(move.converged());
    EXPECT_LE(plate.crease_max_difference, 0.5);
    EXPECT_LE(plate.rim_crease_mean_change, 0.5);
    EXPECT_LE(plate.rim_crease_max_change, 1.5);
    // One inflection is the price.
    EXPECT_LE(plate.tension_sections.inflections_after, 1);
    EXPECT_EQ(plate.compressed_sections.inflections_after, 0);
    EXPECT_LE(std::abs(plate.bulge_max_mm), 0.1);
    EXPECT_EQ(plate.flipped, 0);
    EXPECT_LE(plate.line_error_max_mm, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Slides, PlatePanel, slides, slide_name);

namespace {

/// The line's target over its whole length: displaced by `offset` times a bell of 800 mm, on the panel's surface where
/// only y moves.
ParametricCurve belled(double dy, double dz)
{
    const double w = std::numbers::pi / 800, slope = std::tan(6 * std::numbers::pi / 180);
    return {[=](double x) {
                const double bell = std::cos(w * x) * std::cos(w * x);
                return Vec3(x, dy * bell, crease_panel_height(x, dy * bell) + dz * bell);
            },
            [=](double x) {
                const double bell = std::cos(w * x) * std::cos(w * x), rise = -w * std::sin(2 * w * x);
                return Vec3(1, dy * rise,
                            -x / 6000 - dy * dy * bell * rise / 3000 - slope * std::abs(dy) * rise + dz * rise);
            },
            -390, 390};
}

MeasuredMove bell_panel(double dy, double dz, LineCrease crease)
{
    MoveOptions options;
    options.method = Method::plate_fl;
    options.line_crease = crease;
    options.correspondence.mode = CorrespondenceMode::arc_length;
    return move_panel(WidePanel(Diagonals::alternating), belled(dy, dz), options);
}

} // namespace

TEST(PlatePull, OfHalfTheSidesWidthKeepsOneSignOfCurvature)
{
    // Downwards, as the panel is crowned: upwards the crown itself asks for an inflection.
    const auto [move, quality] = bell_panel(0, -150, LineCrease::free);
    EXPECT_EQ(move.placement.verdict, Placement::off_surface);
    EXPECT_TRUE(move.converged());
    EXPECT_EQ(quality.flipped, 0);
    EXPECT_GE(quality.squash, 0.3);
    EXPECT_EQ(quality.tension_sections.inflections_after, 0);
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
}

TEST(PlatePull, KeepsTheCreaseByItselfWhenAsked)
{
    const auto [move, quality] = bell_panel(0, 20, LineCrease::keep);
    EXPECT_EQ(move.placement.verdict, Placement::off_surface);
    EXPECT_LE(quality.crease_rms_difference, 1);
    EXPECT_LE(quality.rim_crease_max_change, 1.5);
    const auto [tilted, free] = bell_panel(0, 20, LineCrease::free);
    EXPECT_GT(free.crease_rms_difference, 8 * quality.crease_rms_difference);
}

TEST(PlateSlide, OfSeventyPercentOfTheWidthFoldsNothing)
{
    const WidePanel panel(Diagonals::alternating);
    double width = 0; // the region ends on the last row of triangles within 300 mm
    for (const int v : panel.region.vertices) {
        width = std::max(width, panel.model.mesh.V(v, 1));
    }
    // The side is 299.9 mm wide along the surface, the slide 209.4 mm: 0.302 is what an even compression would leave.
    for (const LineCrease crease : {LineCrease::free, LineCrease::keep}) {
        const auto [move, quality] = bell_panel(0.7 * width, 0, crease);
        EXPECT_EQ(move.placement.verdict, Placement::on_surface);
        EXPECT_TRUE(move.converged());
        EXPECT_EQ(quality.flipped, 0);
        EXPECT_EQ(quality.compressed_sections.inflections_after, 0);
        EXPECT_GE(quality.squash, 0.3);
        if (crease == LineCrease::free) {
            EXPECT_EQ(quality.tension_sections.inflections_after, 0);
        }
    }
}
