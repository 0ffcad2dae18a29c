// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/precision.h"
#include "kernel/quality.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <numeric>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double pi = std::numbers::pi;

std::vector<int> all_faces(const Mesh& mesh)
{
    std::vector<int> faces(mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

/// The panel measured against a deformed copy; the compressed side is the left one (y > 0).
struct PanelCase {
    Mesh rest;
    Positions moved;
    std::vector<int> line, left, right;

    explicit PanelCase(int nx = 60, int ny = 40, Diagonals diagonals = Diagonals::alternating)
        : rest(crease_panel(nx, ny, diagonals)), moved(rest.V), line(crease_panel_line(nx, ny))
    {
        std::tie(left, right) = sides_of_line(rest, all_faces(rest), line, false);
    }
    QualityInput input(const TargetCurve* target = nullptr) const
    {
        return {rest, moved, line, false, left, right, target, 9};
    }
    QualityReport measure() const
    {
        const auto report = measure_quality(input());
        EXPECT_TRUE(report) << report.error().message;
        return report.value_or(QualityReport{});
    }
};

double smooth_bump(double r2) { return r2 < 1 ? std::exp(1 - 1 / (1 - r2)) : 0; }

} // namespace

TEST(Quality, OfAnUnmovedMeshIsPerfect)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const QualityReport report = PanelCase(60, 40, diagonals).measure();
        EXPECT_EQ(report.bulge_max_mm, 0);
        EXPECT_EQ(report.slide_max_mm, 0);
        EXPECT_EQ(report.gauss_sign_change, 0);
        EXPECT_EQ(report.mean_sign_change, 0);
        EXPECT_EQ(report.crease_max_difference, 0);
        EXPECT_NEAR(report.crease_before, 12, 0.3);
        EXPECT_NEAR(report.squash, 1, 1e-12);
        EXPECT_EQ(report.min_area_ratio, 1);
        EXPECT_EQ(report.flipped, 0);
        EXPECT_EQ(report.self_intersections, 0);
        EXPECT_EQ(report.rim_crease_max_change, 0);
        EXPECT_EQ(report.compressed_sections.inflections_after, 0);
        EXPECT_EQ(report.tension_sections.inflections_after, 0);
        EXPECT_NEAR(report.compressed_sections.turning_increase, 0, 1e-12);
    }
}

TEST(Quality, OfAnEvenPanelFindsItsSectionsTurning)
{
    // Half a section: slope from tan 6° to tan 6° + 300/3000.
    const double slope = std::tan(6 * pi / 180);
    const double turning = (std::atan(slope + 0.1) - std::atan(slope)) * 180 / pi;
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        for (const int n : {1, 4}) {
            const QualityReport report = PanelCase(60 * n, 40 * n, diagonals).measure();
            EXPECT_NEAR(report.compressed_sections.turning_before, turning, 0.3) << n;
            EXPECT_EQ(report.compressed_sections.inflections_before, 0) << n;
            EXPECT_EQ(report.tension_sections.inflections_before, 0) << n;
        }
    }
}

TEST(Quality, OfAKnownBumpGivesItsHeightAndPlace)
{
    for (const double height : {2.0, -2.0}) {
        const Mesh rest = grid(40, 40, -200, 200, -200, 200, [](double, double) { return 0.0; });
        Positions moved = rest.V;
        for (int v = 0; v < moved.rows(); ++v) {
            const double x = moved(v, 0), y = moved(v, 1) - 100;
            moved(v, 2) += height * smooth_bump((x * x + y * y) / 6400);
        }
        std::vector<int> line(41);
        std::iota(line.begin(), line.end(), 20 * 41);
        const auto [left, right] = sides_of_line(rest, all_faces(rest), line, false);
        const auto report = measure_quality({rest, moved, line, false, left, right, nullptr, 9});
        ASSERT_TRUE(report) << report.error().message;
        EXPECT_NEAR(report->bulge_max_mm, height, 1e-12);
        EXPECT_LT((report->bulge_at - Vec3(0, 100, height)).norm(), 1e-9);
        EXPECT_GT(report->bulge_rms_mm, 0);
        EXPECT_LT(report->bulge_rms_mm, 2);
        EXPECT_GE(report->compressed_sections.inflections_after, 2);
        EXPECT_EQ(report->tension_sections.inflections_after, 0);
    }
}

TEST(Quality, OfAMotionAlongTheSurfaceHasNoBulge)
{
    // A roof's left side compressed within its plane: nothing leaves the surface, altitudes shrink by the known factor.
    const Mesh rest = flat_roof(40, 20);
    Positions moved = rest.V;
    for (int v = 0; v < moved.rows(); ++v) {
        const double y = moved(v, 1);
        moved(v, 1) = y >= 0 ? 350 + y * 0.65 : 350 + y * 1.35;
        moved(v, 2) = y >= 0 ? -0.3 * moved(v, 1) : -0.3 * 350 - 0.3 * (moved(v, 1) - 350) * -1;
    }
    const std::vector<int> line = crease_panel_line(40, 20);
    const auto [left, right] = sides_of_line(rest, all_faces(rest), line, false);
    const auto report = measure_quality({rest, moved, line, false, left, right, nullptr, 5});
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_LT(std::abs(report->bulge_max_mm), 1e-9);
    EXPECT_NEAR(report->squash, 0.65, 1e-9);
    EXPECT_NEAR(report->min_area_ratio, 0.65, 1e-9);
    EXPECT_NEAR(report->slide_max_mm, 350 * std::sqrt(1.09), 1e-9);
    EXPECT_EQ(report->compressed_sections.inflections_after, 0);
    EXPECT_NEAR(report->compressed_sections.turning_after, 0, 1e-6);
}

TEST(Quality, OfALineOnItsTargetHasNoErrorButTheChords)
{
    PanelCase panel;
    const ParametricCurve target = crease_slide_target(50);
    std::vector<int> used;
    for (const int v : panel.line) {
        const double x = panel.moved(v, 0);
        if (std::abs(x) <= 200) {
            panel.moved.row(v) = target.point(x).transpose();
            used.push_back(v);
        }
    }
    panel.line = used;
    auto report = measure_quality(panel.input(&target));
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_LT(report->line_error_max_mm, 1e-9);
    // Sagitta of a chord of 13.3 mm where y'' is largest: 50 (π/200)² / 2.
    EXPECT_NEAR(report->chord_error_max_mm, 50 * std::pow(pi / 200, 2) / 2 * std::pow(800.0 / 60, 2) / 8, 0.05);
    panel.moved(panel.line[7], 2) += 0.25;
    report = measure_quality(panel.input(&target));
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_NEAR(report->line_error_max_mm, 0.25, 0.01);
}

TEST(Quality, FindsTheInflectionOfAFaintSBendInAnIrregularMesh)
{
    // 0.2 mm on each 300 mm wide side, on a panel that is curved along the line only.
    const auto height = [](double x, double) { return -x * x / 12000; };
    const Mesh rest = grid(60, 40, -400, 400, -300, 300, height, Diagonals::random, {20});
    Positions moved = rest.V;
    for (int v = 0; v < moved.rows(); ++v) {
        moved(v, 2) += 0.2 * std::sin(2 * pi * moved(v, 1) / 300);
    }
    const std::vector<int> line = crease_panel_line(60, 40);
    const auto [left, right] = sides_of_line(rest, all_faces(rest), line, false);
    const auto report = measure_quality({rest, moved, line, false, left, right, nullptr, 9});
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->compressed_sections.inflections_before, 0);
    EXPECT_EQ(report->tension_sections.inflections_before, 0);
    EXPECT_EQ(report->compressed_sections.inflections_after, 1);
    EXPECT_EQ(report->tension_sections.inflections_after, 1);
}

TEST(Quality, SeesNoInflectionInStraightSectionsOfAnIrregularMesh)
{
    // Curved along the line only: what bends in a section is the tessellation, by up to 0.03 mm.
    for (const int n : {1, 2}) {
        const Mesh rest = grid(30 * n, 24 * n, -400, 400, -300, 300, [](double x, double) { return -x * x / 3000; },
                               Diagonals::random, {12 * n});
        const std::vector<int> line = crease_panel_line(30 * n, 24 * n);
        const auto [left, right] = sides_of_line(rest, all_faces(rest), line, false);
        const auto report = measure_quality({rest, rest.V, line, false, left, right, nullptr, 31});
        ASSERT_TRUE(report) << report.error().message;
        EXPECT_EQ(report->compressed_sections.inflections_before, 0);
        EXPECT_EQ(report->tension_sections.inflections_before, 0);
    }
}

TEST(Quality, DoesNotChangeUnderRigidMotionAndScalesWithTheModel)
{
    PanelCase panel(30, 20, Diagonals::random);
    for (int v = 0; v < panel.moved.rows(); ++v) {
        const double x = panel.moved(v, 0) / 400, y = panel.moved(v, 1) / 300;
        const double fade = std::pow((1 - x * x) * (1 - y * y), 2);
        panel.moved.row(v) += fade * Eigen::RowVector3d(0, 30, 4 * std::sin(9 * y));
    }
    const QualityReport report = panel.measure();
    PanelCase other = panel;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const auto place = [&](const Positions& V) -> Positions {
        return (V * (0.01 * turn.transpose())).rowwise() + Eigen::RowVector3d(20, -7, 3);
    };
    other.rest.V = place(panel.rest.V);
    other.moved = place(panel.moved);
    const QualityReport again = other.measure();
    EXPECT_NEAR(again.bulge_max_mm, 0.01 * report.bulge_max_mm, 1e-9);
    EXPECT_NEAR(again.bulge_rms_mm, 0.01 * report.bulge_rms_mm, 1e-9);
    EXPECT_NEAR(again.bulge_fraction, report.bulge_fraction, 1e-7);
    EXPECT_NEAR(again.squash, report.squash, 1e-7);
    EXPECT_NEAR(again.crease_rms_difference, report.crease_rms_difference, 1e-6);
    EXPECT_NEAR(again.gauss_sign_change, report.gauss_sign_change, 1e-6);
    EXPECT_NEAR(again.compressed_sections.turning_after, report.compressed_sections.turning_after, 1e-4);
    EXPECT_EQ(again.compressed_sections.inflections_after, report.compressed_sections.inflections_after);
    EXPECT_GT(report.bulge_max_mm, 0.5);
}

TEST(Quality, RefusesAMeshThatIsNotTheModels)
{
    PanelCase panel(6, 4);
    const Positions good = panel.moved;
    panel.moved.conservativeResize(good.rows() - 1, 3);
    EXPECT_FALSE(measure_quality(panel.input()));
    panel.moved = good;
    panel.moved(3, 1) = std::numeric_limits<double>::quiet_NaN();
    const auto report = measure_quality(panel.input());
    ASSERT_FALSE(report);
    EXPECT_NE(report.error().message.find("vertex 3"), std::string::npos);
    EXPECT_TRUE(cross_sections(panel.input()).empty());
    panel.moved = good;
    panel.line.push_back(100000);
    EXPECT_FALSE(measure_quality(panel.input()));
}

TEST(Sides, OfTheCreaseAreTheTwoHalvesOfThePanel)
{
    const PanelCase panel;
    EXPECT_EQ(panel.left.size(), panel.right.size());
    for (const int t : panel.left) {
        EXPECT_GT(panel.rest.V(panel.rest.F(t, 0), 1) + panel.rest.V(panel.rest.F(t, 1), 1) +
                      panel.rest.V(panel.rest.F(t, 2), 1),
                  0);
    }
}

TEST(CoordinatePrecision, IsReadOffTheDigits)
{
    Mesh mesh = crease_panel(60, 40, Diagonals::random);
    EXPECT_LT(coordinate_precision(mesh.V), 1e-12);
    Positions single = mesh.V.cast<float>().cast<double>();
    EXPECT_NEAR(coordinate_precision(single), 400 * std::ldexp(1.0, -24), 1e-12);
    for (double* x = single.data(); x != single.data() + single.size(); ++x) {
        *x = std::stod(fmt::format("{:.10f}", *x));
    }
    EXPECT_NEAR(coordinate_precision(single), 400 * std::ldexp(1.0, -24), 1e-12);
    Positions text = (mesh.V.array() * 1000).round() / 1000; // six digits: 399.999
    EXPECT_NEAR(coordinate_precision(text), 0.0005, 1e-9);
}
