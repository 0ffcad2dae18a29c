// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/plate.h"
#include "tests/support/moves.h"
#include "tests/support/plates.h"
#include "tests/support/side.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

double largest_difference(const Positions& A, const Positions& B) { return (A - B).rowwise().norm().maxCoeff(); }

PlateOptions with(double ratio, const Vec3& direction, double tolerance_mm = 1e-9)
{
    PlateOptions options;
    options.material = {ratio, Stiff::along, direction};
    options.tolerance_mm = tolerance_mm;
    return options;
}

double cantilever(double t) { return t * t * (3 - t) / 2; }
double hermite(double t) { return t * t * (3 - 2 * t); }

/// Errors against the closed form on strips of 8, 16, 32 and 64 cells [mm].
std::vector<double> beam_errors(bool clamped, Diagonals diagonals, double ratio)
{
    const Vec3 u(0, 0, 20);
    std::vector<double> errors;
    for (const int n : {8, 16, 32, 64}) {
        const PlateStrip strip(n, clamped, u, diagonals);
        const auto bent = bend_plate(strip.mesh, strip.support, with(ratio, Vec3::UnitY()));
        EXPECT_TRUE(bent && bent->converged);
        errors.push_back(strip.error(bent->V, clamped ? hermite : cantilever, u));
    }
    return errors;
}

/// The creased panel, one ring of its border held, its line pulled up and to the left in the middle.
PlateSupport pulled_line(const Mesh& mesh, int nx, int ny, double height)
{
    PlateSupport support = holding(
        mesh,
        [&](const Vec3& p) {
            return std::abs(p.x()) > 400 - 1000.0 / nx || std::abs(p.y()) > 300 - 800.0 / ny || std::abs(p.y()) < 1e-9;
        },
        [&](const Vec3& p) -> Vec3 {
            const double bell = std::abs(p.x()) < 300 ? std::pow(std::cos(p.x() * M_PI / 600), 2) : 0;
            return std::abs(p.y()) < 1e-9 ? Vec3(p + bell * Vec3(0, 0.3, 1) * height) : p;
        });
    support.line = crease_panel_line(nx, ny);
    support.free_slope = support.line;
    return support;
}

} // namespace

TEST(Plate, ReproducesAffineDisplacementsOfAFlatPatch)
{
    const Mesh mesh = grid(
        16, 12, -80, 80, -60, 60, [](double, double) { return 0.0; }, Diagonals::random);
    Eigen::Matrix3d A;
    A << 1.25, 0.2, 0, 0.1, 0.85, 0, 0.3, -0.2, 1;
    // The border and one ring of vertices inside it are given: the outer ring of triangles is clamped.
    const PlateSupport support = holding(
        mesh, [](const Vec3& p) { return std::abs(p.x()) > 66 || std::abs(p.y()) > 46; },
        [&](const Vec3& p) -> Vec3 { return A * p + Vec3(3, -2, 5); });
    ASSERT_LT(support.constrained.size(), 140u);
    const Positions affine = (mesh.V * A.transpose()).rowwise() + Eigen::RowVector3d(3, -2, 5);
    for (const double ratio : {1.0, 10.0, 100.0}) {
        const auto bent = bend_plate(mesh, support, with(ratio, Vec3(1, 2, 0).normalized()));
        ASSERT_TRUE(bent) << bent.error().message;
        EXPECT_TRUE(bent->converged);
        EXPECT_LT(largest_difference(bent->V, affine), 1e-9) << ratio;
    }
}

TEST(Plate, ReproducesRigidMotionsOfItsSupport)
{
    const RigidMotion motion = some_rigid_motion();
    const Mesh mesh = crease_panel(30, 20, Diagonals::random);
    PlateSupport support = holding(
        mesh, [](const Vec3& p) { return std::abs(p.x()) > 365 || std::abs(p.y()) > 275 || std::abs(p.y()) < 1e-9; },
        motion);
    for (const bool tilting : {false, true}) {
        support.line = support.free_slope = tilting ? crease_panel_line(30, 20) : std::vector<int>{};
        for (const double ratio : {1.0, 10.0, 100.0}) {
            const auto bent = bend_plate(mesh, support, with(ratio, Vec3::UnitY()));
            ASSERT_TRUE(bent) << bent.error().message;
            EXPECT_TRUE(bent->converged);
            EXPECT_LT(largest_difference(bent->V, transformed(mesh.V, 1, motion.R, motion.shift)), 1e-9 * 1000);
        }
    }
}

TEST(Plate, IsTheRestShapeToTheBitWhereNothingMoves)
{
    const Mesh mesh = crease_panel(30, 20, Diagonals::random);
    const auto bent = bend_plate(mesh, pulled_line(mesh, 30, 20, 0), with(1.5, Vec3::UnitY()));
    ASSERT_TRUE(bent) << bent.error().message;
    EXPECT_EQ(bent->V, mesh.V);
}

TEST(Plate, TendsToTheClampedBeamWithFreeOrClampedEnd)
{
    for (const bool clamped : {false, true}) {
        for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
            for (const double ratio : {1.0, 1.5, 100.0}) {
                const std::vector<double> errors = beam_errors(clamped, diagonals, ratio);
                EXPECT_LT(errors[3], 0.02) << ratio;
                EXPECT_LT(errors[3], 0.12 * errors[0]) << ratio;
                EXPECT_LT(errors[1], 0.55 * errors[0]) << ratio;
            }
        }
    }
}

TEST(Plate, AnswersTwiceTheLoadWithTwiceTheDisplacementWhileItIsSmall)
{
    const Mesh mesh = crease_panel(30, 20, Diagonals::random);
    const PlateOptions options = with(1.5, Vec3::UnitY(), 1e-6);
    const auto one = bend_plate(mesh, pulled_line(mesh, 30, 20, 0.01), options);
    const auto two = bend_plate(mesh, pulled_line(mesh, 30, 20, 0.02), options);
    ASSERT_TRUE(one && two);
    EXPECT_LE(one->iterations, 3);
    EXPECT_LT(largest_difference(two->V, 2 * one->V - mesh.V), 1e-3 * 0.02);
}

TEST(Plate, EndsWithinItsOwnErrorEstimate)
{
    const Mesh mesh = crease_panel(30, 20, Diagonals::random);
    for (const double height : {20.0, 150.0}) {
        const PlateSupport support = pulled_line(mesh, 30, 20, height);
        const auto exact = bend_plate(mesh, support, with(1.5, Vec3::UnitY(), 1e-9));
        const auto quick = bend_plate(mesh, support, with(1.5, Vec3::UnitY(), 0.1));
        ASSERT_TRUE(exact && quick);
        EXPECT_TRUE(exact->converged && quick->converged);
        EXPECT_LE(quick->error_estimate_mm, 0.1);
        EXPECT_LT(largest_difference(exact->V, quick->V), 0.1) << height;
        EXPECT_LT(quick->iterations, exact->iterations);
    }
}

TEST(Plate, SettlesOnASideThatIsTightlyCurvedForItsWidth)
{
    // Three quarters of a tube of radius 60 mm; its end, the line, is drawn out along the tangent by up to 100 mm.
    constexpr double radius = 60, width = 1.5 * M_PI * radius;
    constexpr int nx = 40, ny = 24;
    Mesh tube = grid(nx, ny, -200, 200, 0, width, [](double, double) { return 0.0; });
    for (auto row : tube.V.rowwise()) {
        const double angle = row.y() / radius;
        row = Eigen::RowVector3d(row.x(), radius * std::sin(angle), radius * (std::cos(angle) - 1));
    }
    PlateSupport support;
    std::vector<Vec3> targets;
    for (int v = 0; v < tube.V.rows(); ++v) {
        const int i = v % (nx + 1), j = v / (nx + 1);
        if (j == 0 || j >= ny - 1 || std::min(i, nx - i) <= 1) {
            support.constrained.push_back(v);
            const double bell =
                j > 0 || std::min(i, nx - i) <= 1 ? 0 : std::pow(std::cos(tube.V(v, 0) * M_PI / 400), 2);
            targets.push_back(Vec3(tube.V.row(v)) - 100 * bell * Vec3::UnitY());
        }
        if (j == 0) {
            support.line.push_back(v);
        }
    }
    support.free_slope = support.line;
    support.targets.resize(static_cast<Eigen::Index>(targets.size()), 3);
    for (size_t k = 0; k < targets.size(); ++k) {
        support.targets.row(static_cast<Eigen::Index>(k)) = targets[k];
    }
    const auto bent = bend_plate(tube, support, with(3, Vec3::UnitY(), 0.01));
    ASSERT_TRUE(bent) << bent.error().message;
    EXPECT_TRUE(bent->converged);
    EXPECT_LT(bent->iterations, 40);
}

TEST(Plate, HasOneAnswerWhereverItStarts)
{
    const Mesh mesh = crease_panel(30, 20, Diagonals::random);
    const PlateSupport support = pulled_line(mesh, 30, 20, 150);
    const auto stretched = bend_plate(mesh, support, with(1.5, Vec3::UnitY(), 1e-8));
    const auto rest = bend_plate(mesh, support, with(1.5, Vec3::UnitY(), 1e-8), mesh.V);
    ASSERT_TRUE(stretched && rest);
    EXPECT_TRUE(stretched->converged && rest->converged);
    EXPECT_LT(largest_difference(stretched->V, rest->V), 1e-6);
}

TEST(Plate, IsSymmetricWhereItsSupportIs)
{
    const Mesh mesh = crease_panel(40, 30);
    const auto bent = bend_plate(mesh, pulled_line(mesh, 40, 30, 80), with(1.5, Vec3::UnitY()));
    ASSERT_TRUE(bent);
    double largest = 0;
    for (int j = 0; j <= 30; ++j) {
        for (int i = 0; i <= 40; ++i) {
            const Vec3 p = bent->V.row(j * 41 + i), q = bent->V.row(j * 41 + 40 - i);
            largest = std::max(largest, (p - Vec3(-q.x(), q.y(), q.z())).norm());
        }
    }
    EXPECT_LT(largest, 1e-8);
}

TEST(Plate, GivesTheSameBytesOnOneThreadAndOnTwo)
{
    const Mesh mesh = crease_panel(40, 30, Diagonals::random);
    const PlateSupport support = pulled_line(mesh, 40, 30, 60);
    const auto on_threads = [&](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return bend_plate(mesh, support, with(1.5, Vec3::UnitY(), 1e-4))->V;
    };
    const Positions one = on_threads(1), two = on_threads(2);
    EXPECT_EQ(std::memcmp(one.data(), two.data(), sizeof(double) * one.size()), 0);
}

TEST(Plate, StopsWhenItIsCancelledAndSaysWhenItDidNotConverge)
{
    const Mesh mesh = crease_panel(30, 20);
    const PlateSupport support = pulled_line(mesh, 30, 20, 150);
    const Progress stop([](double, std::string_view) { return false; });
    const auto cancelled = bend_plate(mesh, support, with(1.5, Vec3::UnitY()), {}, stop);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::cancelled);
    PlateOptions short_run = with(1.5, Vec3::UnitY());
    short_run.max_passes = 3;
    const auto unfinished = bend_plate(mesh, support, short_run);
    ASSERT_TRUE(unfinished);
    EXPECT_FALSE(unfinished->converged);
    EXPECT_GT(unfinished->error_estimate_mm, 1e-9);
}

TEST(Plate, RefusesLooseVerticesAndTrianglesWithoutArea)
{
    Mesh mesh = crease_panel(8, 6);
    const PlateSupport support = pulled_line(mesh, 8, 6, 10);
    Mesh loose = mesh;
    loose.V.conservativeResize(loose.V.rows() + 1, 3);
    loose.V.bottomRows(1) << 1, 2, 3;
    const auto hanging = bend_plate(loose, support);
    ASSERT_FALSE(hanging);
    EXPECT_NE(hanging.error().message.find("(1, 2, 3)"), std::string::npos);
    mesh.V.row(20) = mesh.V.row(21);
    const auto flat = bend_plate(mesh, support);
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().kind, ErrorKind::rejected);
    PlateSupport short_list = support;
    short_list.targets.conservativeResize(3, 3);
    EXPECT_EQ(bend_plate(mesh, short_list).error().kind, ErrorKind::usage);
}
