// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/quality.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
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

/// The row of vertices in the middle of a grid of nx × ny cells.
std::vector<int> middle_row(int nx, int ny) { return crease_panel_line(nx, ny); }

QualityReport measure(const Mesh& rest, const Positions& moved, const std::vector<int>& line)
{
    const auto [left, right] = sides_of_line(rest, all_faces(rest), line, false);
    const auto report = measure_quality({rest, moved, line, false, left, right, nullptr, 5});
    EXPECT_TRUE(report) << report.error().message;
    return report.value_or(QualityReport{});
}

/// z = (a x² + b y²) / 2 on [-100, 100]².
Mesh quadric(double a, double b, Diagonals diagonals = Diagonals::alternating)
{
    return grid(20, 20, -100, 100, -100, 100, [=](double x, double y) { return (a * x * x + b * y * y) / 2; },
                diagonals, {10});
}

} // namespace

TEST(CurvatureMaps, OfASphereAreOneOverRadius)
{
    const double radius = 200;
    const Mesh cap =
        grid(20, 20, -60, 60, -60, 60, [=](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); });
    const auto line = middle_row(20, 20);
    const QualityMaps maps = quality_maps({cap, cap.V, line, false, all_faces(cap), {}, nullptr, 1});
    double gauss = 0, mean = 0;
    int count = 0;
    for (int v = 0; v < cap.V.rows(); ++v) {
        if (!std::isnan(maps.gauss_before[v])) {
            EXPECT_GT(maps.gauss_before[v], 0);
            EXPECT_GT(maps.mean_before[v], 0);
            gauss += maps.gauss_before[v];
            mean += maps.mean_before[v];
            ++count;
        }
    }
    EXPECT_EQ(count, 19 * 18);
    EXPECT_NEAR(gauss / count, 1 / (radius * radius), 0.05 / (radius * radius));
    EXPECT_NEAR(mean / count, 1 / radius, 0.05 / radius);
}

TEST(CurvatureMaps, KnowCapSaddleAndCylinderOnIrregularMeshes)
{
    const auto line = middle_row(20, 20);
    const auto signs = [&](const Mesh& mesh) {
        const QualityMaps maps = quality_maps({mesh, mesh.V, line, false, all_faces(mesh), {}, nullptr, 1});
        std::array<int, 3> counts{}; // negative, zero, positive
        for (const double k : maps.gauss_before) {
            if (!std::isnan(k)) {
                ++counts[k < 0 ? 0 : (k > 0 ? 2 : 1)];
            }
        }
        return counts;
    };
    const int total = 19 * 18;
    EXPECT_GT(signs(quadric(-1e-3, -1e-3))[2], 0.99 * total);
    EXPECT_GT(signs(quadric(-1e-3, 1e-3))[0], 0.99 * total);
    EXPECT_EQ(signs(quadric(0, 1e-3))[1], total);
    EXPECT_EQ(signs(quadric(0, 0, Diagonals::random))[1], total);
    EXPECT_LT(signs(quadric(-1e-3, -1e-3, Diagonals::random))[0], 0.02 * total);
    EXPECT_LT(signs(quadric(-1e-3, 1e-3, Diagonals::random))[2], 0.02 * total);
}

TEST(Curvature, ChangesItsSignWhereACapBecomesASaddle)
{
    const Mesh cap = quadric(-1e-3, -1e-3), saddle = quadric(-1e-3, 1e-3), bowl = quadric(1e-3, 1e-3);
    const auto line = middle_row(20, 20);
    EXPECT_GT(measure(cap, saddle.V, line).gauss_sign_change, 0.99);
    EXPECT_EQ(measure(cap, bowl.V, line).gauss_sign_change, 0);
    EXPECT_GT(measure(cap, bowl.V, line).mean_sign_change, 0.99);
    // Half of the cap turned into a saddle: half of the area.
    Positions half = cap.V;
    for (int v = 0; v < half.rows(); ++v) {
        half(v, 2) += half(v, 1) > 0 ? 1e-3 * half(v, 1) * half(v, 1) : 0;
    }
    EXPECT_NEAR(measure(cap, half, line).gauss_sign_change, 0.5, 0.05);
    EXPECT_GT(measure(cap, half, line).gauss_sign_change_compressed, 0.95) << "the half left of the line";
    for (int v = 0; v < half.rows(); ++v) {
        half(v, 2) = cap.V(v, 2) + (cap.V(v, 1) < 0 ? 1e-3 * cap.V(v, 1) * cap.V(v, 1) : 0);
    }
    EXPECT_EQ(measure(cap, half, line).gauss_sign_change_compressed, 0);
}

TEST(ProlongedLine, ShowsAKinkAcrossItAndNotTheOneAcrossTheLineItself)
{
    const Mesh flat = quadric(0, 0);
    const std::vector<int> whole = middle_row(20, 20), line(whole.begin() + 5, whole.begin() + 16);
    Positions bent = flat.V;
    for (int v = 0; v < bent.rows(); ++v) {
        const double x = std::abs(bent(v, 0));
        bent(v, 2) = x > 45 ? -std::abs(bent(v, 1)) * std::tan(3 * pi / 180) : -std::abs(bent(v, 1));
    }
    const auto [left, right] = sides_of_line(flat, all_faces(flat), whole, false);
    const auto report = measure_quality({flat, bent, line, false, left, right, nullptr, 5, whole});
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->extension_crease_mean_change.value_or(0), 6, 0.5);
    EXPECT_FALSE(measure(flat, bent, whole).extension_crease_mean_change) << "nothing was prolonged";
}

TEST(Crease, IsMeasuredBySignedAngles)
{
    const auto roof = [](double slope) {
        return grid(20, 10, -100, 100, -50, 50, [=](double, double y) { return -slope * std::abs(y); });
    };
    const auto line = middle_row(20, 10);
    const Mesh ridge = roof(0.2);
    const double angle = 2 * std::atan(0.2) * 180 / pi;
    const QualityReport sharper = measure(ridge, roof(0.3).V, line);
    EXPECT_NEAR(sharper.crease_before, angle, 1e-9);
    EXPECT_NEAR(sharper.crease_after, 2 * std::atan(0.3) * 180 / pi, 1e-9);
    EXPECT_NEAR(sharper.crease_rms_difference, sharper.crease_after - angle, 1e-9);
    const QualityReport valley = measure(ridge, roof(-0.2).V, line);
    EXPECT_NEAR(valley.crease_after, angle, 1e-9);
    EXPECT_NEAR(valley.crease_max_difference, 2 * angle, 1e-9);
}

TEST(TriangleQuality, FindsOneFlippedTriangleAndItsNeighbourhood)
{
    const Mesh rest = quadric(0, 0);
    Positions moved = rest.V;
    const int v = 15 * 21 + 7; // well inside the left side: pulled across its ring
    moved(v, 0) += 25;
    const QualityReport report = measure(rest, moved, middle_row(20, 20));
    EXPECT_GE(report.flipped, 1);
    EXPECT_LE(report.flipped, 4);
    EXPECT_GT(report.self_intersections, 0);
    EXPECT_EQ(measure(rest, rest.V, middle_row(20, 20)).flipped, 0);
}

TEST(TriangleQuality, DoesNotCallARotatedSideFlipped)
{
    // The tension side folded up by 150° about the line: turned, but not against itself.
    const Mesh rest = quadric(0, 0);
    Positions moved = rest.V;
    const double angle = 150 * pi / 180;
    for (int v = 0; v < moved.rows(); ++v) {
        if (moved(v, 1) < 0) {
            const double y = moved(v, 1);
            moved(v, 1) = y * std::cos(angle);
            moved(v, 2) = y * std::sin(angle);
        }
    }
    EXPECT_EQ(measure(rest, moved, middle_row(20, 20)).flipped, 0);
}

TEST(SelfIntersections, CountOnlyWhatTheMoveMade)
{
    // Two flaps on either side of the line, folded up and leaning through each other.
    const Mesh rest = quadric(0, 0);
    Positions crossed = rest.V;
    for (int v = 0; v < crossed.rows(); ++v) {
        const double y = crossed(v, 1);
        crossed(v, 2) = std::abs(y);
        crossed(v, 1) = y > 0 ? 40 - y : -40 - y;
        crossed(v, 1) = std::abs(y) <= 20 ? y : crossed(v, 1);
    }
    const auto line = middle_row(20, 20);
    const QualityReport report = measure(rest, crossed, line);
    EXPECT_GT(report.self_intersections, 0);
    EXPECT_LE(std::abs(report.self_intersection_at.y()), 30); // the flaps meet above the line, not out at the rim
    EXPECT_GT(report.self_intersection_at.z(), 10);
    Mesh born_crossed = rest;
    born_crossed.V = crossed;
    EXPECT_EQ(measure(born_crossed, crossed, line).self_intersections, 0);
}

TEST(Symmetry, OfAMirroredMoveIsExactAndALopsidedOneIsSeen)
{
    const Mesh rest = crease_panel(20, 10);
    const auto line = crease_panel_line(20, 10);
    Positions moved = rest.V;
    for (int v = 0; v < moved.rows(); ++v) {
        const double x = moved(v, 0) / 400, y = moved(v, 1) / 300;
        moved(v, 1) += 20 * (1 - x * x) * (1 - y * y);
    }
    const auto exact = measure(rest, moved, line).symmetry_residual_mm;
    ASSERT_TRUE(exact);
    EXPECT_LT(*exact, 1e-9);
    moved(2 * 21 + 3, 2) += 0.5;
    const auto lopsided = measure(rest, moved, line).symmetry_residual_mm;
    ASSERT_TRUE(lopsided);
    EXPECT_NEAR(*lopsided, 0.5, 1e-9);
}

TEST(Symmetry, IsNotClaimedForIrregularShapesOrLopsidedTargets)
{
    const Mesh irregular = crease_panel(20, 10, Diagonals::random);
    const auto line = crease_panel_line(20, 10);
    EXPECT_FALSE(measure(irregular, irregular.V, line).symmetry_residual_mm);
    const Mesh regular = crease_panel(20, 10);
    Positions moved = regular.V;
    moved(line[4], 1) += 7;
    EXPECT_FALSE(measure(regular, moved, line).symmetry_residual_mm);
}

TEST(Symmetry, IsFoundInATurnedModel)
{
    Mesh rest = crease_panel(20, 10);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 1, 2).normalized()).toRotationMatrix();
    rest.V = (rest.V * turn.transpose()).eval();
    const auto residual = measure(rest, rest.V, crease_panel_line(20, 10)).symmetry_residual_mm;
    ASSERT_TRUE(residual);
    EXPECT_LT(*residual, 1e-9);
}

TEST(Rim, ReportsACreaseThatTheMoveLeavesWhereTheRegionEnds)
{
    const Mesh rest = quadric(0, 0);
    std::vector<int> inside;
    for (const int t : all_faces(rest)) {
        double reach = 0;
        for (int k = 0; k < 3; ++k) {
            reach = std::max(reach, std::abs(rest.V(rest.F(t, k), 1)));
        }
        if (reach < 51) {
            inside.push_back(t);
        }
    }
    Positions moved = rest.V;
    for (int v = 0; v < moved.rows(); ++v) {
        moved(v, 2) = 0.1 * std::max(0.0, 50 - std::abs(moved(v, 1)));
    }
    const auto line = middle_row(20, 20);
    const auto [left, right] = sides_of_line(rest, inside, line, false);
    const auto report = measure_quality({rest, moved, line, false, left, right, nullptr, 3});
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_NEAR(report->rim_crease_mean_change, std::atan(0.1) * 180 / pi, 1e-9);
    EXPECT_NEAR(report->rim_crease_max_change, std::atan(0.1) * 180 / pi, 1e-9);
}
