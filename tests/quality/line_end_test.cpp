// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that close on themselves, end on the model's border, or end with a slide of their own.
#include "plugin/runner/measures.h"
#include "tests/support/moves.h"
#include "tests/support/wide_panel.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int around = 96, rings = 32;

/// A plate with a raised cone: z falls at 30° beyond r = 100, flat inside; rings of radius 20 to 300 mm, open at both
/// ends. Vertex (ring, k) has index ring * around + k; ring 8 is the crease.
Mesh collar()
{
    Mesh mesh;
    mesh.V.resize((rings + 1) * around, 3);
    for (int ring = 0; ring <= rings; ++ring) {
        const double r = ring <= 8 ? 20 + 10 * ring : 100 + 200.0 * (ring - 8) / (rings - 8);
        for (int k = 0; k < around; ++k) {
            const double a = 2 * std::numbers::pi * k / around;
            mesh.V.row(ring * around + k) << r * std::cos(a), r * std::sin(a),
                -std::max(0.0, r - 100) * std::tan(std::numbers::pi / 6);
        }
    }
    mesh.F.resize(2 * rings * around, 3);
    for (int ring = 0, t = 0; ring < rings; ++ring) {
        for (int k = 0; k < around; ++k) {
            const int a = ring * around + k, b = ring * around + (k + 1) % around;
            mesh.F.row(t++) << a, a + around, b + around;
            mesh.F.row(t++) << a, b + around, b;
        }
    }
    return mesh;
}

ParametricCurve circle(double r, double z)
{
    return {[=](double a) { return Vec3(r * std::cos(a), r * std::sin(a), z); },
            [=](double a) { return Vec3(-r * std::sin(a), r * std::cos(a), 0); }, 0, 2 * std::numbers::pi, true};
}

/// A line along all of y = 0 slid by a constant: both ends slide along the panel's borders x = ±400.
ParametricCurve straight_slide(double s)
{
    return {[=](double x) { return Vec3(x, s, crease_panel_height(x, s)); },
            [](double x) { return Vec3(1, 0, -x / 6000); }, -400, 400};
}

} // namespace

TEST(ClosedLine, SlidesOutwardsWithoutAnExtensionAndStaysOnTheCone)
{
    std::vector<int> ring(around + 1);
    for (int k = 0; k <= around; ++k) {
        ring[k] = 8 * around + k % around;
    }
    const Model model = model_of(collar());
    const double r = 130, z = -30 * std::tan(std::numbers::pi / 6);
    const auto [move, quality] = move_and_measure(model, ring, circle(r, z));
    EXPECT_TRUE(move.correspondence.line.closed);
    EXPECT_TRUE(move.appended.empty());
    EXPECT_TRUE(move.converged());
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
    // The chords of 96 triangles around leave the cone by r (1 - cos(pi/96)) sin 30°.
    EXPECT_LE(std::abs(quality.bulge_max_mm), 0.1);
    EXPECT_EQ(quality.flipped, 0);
    EXPECT_GE(quality.squash, 0.5);
}

TEST(LineThatEndsOnTheBorder, SlidesItsEndsAlongTheBorder)
{
    const Model model = model_of(crease_panel(60, 40));
    const auto [move, quality] = move_and_measure(model, crease_panel_line(60, 40), straight_slide(60));
    EXPECT_TRUE(move.converged());
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
    EXPECT_LE(std::abs(quality.bulge_max_mm), 0.1);
    EXPECT_EQ(quality.flipped, 0);
    EXPECT_GE(quality.squash, 0.6);
    for (int j = 0; j <= 40; ++j) {
        for (const int v : {j * 61, j * 61 + 60}) {
            // The border stays the curve that it was.
            EXPECT_NEAR(std::abs(move.V(v, 0)), 400, 1e-6);
            EXPECT_NEAR(move.V(v, 2), crease_panel_height(400, move.V(v, 1)), 0.05);
        }
    }
}

namespace {

/// y = s for |x| ≤ 200 on the surface z = -x²/12000 - y²/6000 - slope |y|.
ParametricCurve even_slide(double s, double slope)
{
    return {[=](double x) { return Vec3(x, s, -x * x / 12000 - s * s / 6000 - slope * s); },
            [](double x) { return Vec3(1, 0, -x / 6000); }, -200, 200};
}

MeasuredMove slide_evenly(const WidePanel& panel, double slope, LineCrease crease)
{
    const ParametricCurve target = even_slide(40, slope);
    MoveOptions options;
    options.line_crease = crease;
    MoveResult moved = move_line(panel, target, options);
    const QualityReport quality = measure_quality(quality_input(moved, target)).value();
    return {std::move(moved), quality};
}

} // namespace

TEST(LineThatEndsWithASlide, LetsTheSurfaceGoOnAcrossItsProlongation)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const WidePanel panel(diagonals);
        for (const LineCrease crease : {LineCrease::free, LineCrease::keep}) {
            const bool kept = crease == LineCrease::keep;
            const auto [move, quality] = slide_evenly(panel, std::tan(std::numbers::pi / 30), crease);
            EXPECT_TRUE(move.converged());
            // The crease changes along the line; around its ends the change runs out, so that half of it is left there.
            EXPECT_LE(quality.extension_crease_mean_change.value_or(99), 0.2);
            EXPECT_LE(quality.extension_crease_max_change.value_or(99),
                      kept ? 0.5 : 0.5 * quality.crease_max_difference + 0.2);
            EXPECT_EQ(quality.compressed_sections.inflections_after, 0);
            EXPECT_LE(quality.tension_sections.inflections_after, kept ? 2 : 0);
            EXPECT_LE(std::abs(quality.bulge_max_mm), 0.1);
            EXPECT_EQ(quality.flipped, 0);
            EXPECT_LE(quality.line_error_max_mm, 1e-9);
        }
    }
}

TEST(LineThatEndsWithASlide, LeavesNoKinkBeyondItWhereTheSurfaceIsSmooth)
{
    WidePanel dome(Diagonals::alternating);
    for (int v = 0; v < dome.model.mesh.V.rows(); ++v) {
        const double x = dome.model.mesh.V(v, 0), y = dome.model.mesh.V(v, 1);
        dome.model.mesh.V(v, 2) = -x * x / 12000 - y * y / 6000;
    }
    const auto [move, quality] = slide_evenly(dome, 0, LineCrease::free);
    EXPECT_TRUE(move.converged());
    EXPECT_LE(quality.extension_crease_max_change.value_or(99), 0.5);
    EXPECT_EQ(quality.flipped, 0);
    EXPECT_LE(std::abs(quality.bulge_max_mm), 0.1);
}
