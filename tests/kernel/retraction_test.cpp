// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/closest_point.h"
#include "kernel/retraction.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr RetractionMode modes[] = {RetractionMode::harmonic, RetractionMode::planes};

RetractionResult retracted(const SideMesh& side, const std::vector<Vec3>& displacements, RetractionMode mode)
{
    RetractionOptions options;
    options.mode = mode;
    Vec3 sum = Vec3::Zero();
    for (const Vec3& u : displacements) {
        sum += u;
    }
    options.material.stiff_direction = sum.norm() > 0 ? Vec3(sum.normalized()) : Vec3::UnitX();
    const auto result = retract(side, displacements, options);
    EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
    return result.value_or(RetractionResult{side.mesh.V, 0, -1, -1});
}

double largest_distance_to_side(const SideMesh& side, const Positions& V)
{
    const ClosestPoint surface({side.mesh.V, side.mesh.F.topRows(side.inner_faces)});
    double largest = 0;
    for (const Vec3 p : V.rowwise()) {
        largest = std::max(largest, surface.closest(p).distance);
    }
    return largest;
}

/// The flat side y > 0 of a roof and a bell-shaped slide into it, zero at both ends of the line.
struct FlatSide {
    SideMesh side;
    std::vector<Vec3> u;
    Vec3 into = Vec3(0, 1, -0.3).normalized();

    FlatSide(Diagonals diagonals, double slide)
    {
        side = left_side(flat_roof(40, 24, diagonals), grid_row(40, 12));
        for (const int v : side.line) {
            const double x = side.mesh.V(v, 0) / 2000;
            u.push_back(std::pow(1 - x * x, 2) * slide * (into + 0.2 * x * Vec3::UnitX()));
        }
    }
};

} // namespace

TEST(Retraction, KeepsEveryPointOnThePlaneWhenTheSideIsFlat)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const FlatSide flat(diagonals, 350);
        for (const RetractionMode mode : modes) {
            const RetractionResult result = retracted(flat.side, flat.u, mode);
            const Eigen::VectorXd off = result.V * Vec3(0, 0.3, 1).normalized();
            EXPECT_LT(off.cwiseAbs().maxCoeff(), 1e-9);
            EXPECT_EQ(result.flipped, 0);
            EXPECT_GT(result.min_area_ratio, 0.5);
        }
    }
}

TEST(Retraction, TakesTheLineToItsTargetAndLeavesFixedVerticesAlone)
{
    const FlatSide flat(Diagonals::random, 350);
    for (const RetractionMode mode : modes) {
        const RetractionResult result = retracted(flat.side, flat.u, mode);
        for (size_t i = 0; i < flat.u.size(); ++i) {
            const int v = flat.side.line[i];
            EXPECT_LT((result.V.row(v) - flat.side.mesh.V.row(v) - flat.u[i].transpose()).norm(), 1e-9);
        }
        for (const int v : flat.side.fixed) {
            EXPECT_EQ(result.V.row(v), flat.side.mesh.V.row(v));
        }
    }
}

TEST(Retraction, OfNothingIsNothingToTheBit)
{
    const SideMesh side = left_side(crease_panel(20, 16, Diagonals::random), grid_row(20, 8));
    for (const RetractionMode mode : modes) {
        const std::vector<Vec3> none(side.line.size(), Vec3::Zero());
        EXPECT_EQ(retracted(side, none, mode).V, side.mesh.V);
        // Straight out of the side: the other side's business.
        const std::vector<Vec3> out(side.line.size(), Vec3(0, -50, 0));
        EXPECT_EQ(retracted(side, out, mode).V, side.mesh.V);
    }
}

TEST(Retraction, SquashesTheCreasePanelNoMoreThanItMust)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const SideMesh side = left_side(crease_panel(60, 40, diagonals), crease_panel_line(60, 40));
        for (const double s : {25.0, 50.0, 75.0, 100.0}) {
            const RetractionResult harmonic = retracted(side, crease_slide(side, s), RetractionMode::harmonic);
            // A fibre 300 mm long that loses s keeps 1 - s / 300 of every piece at best.
            EXPECT_GT(squash(side, harmonic.V, Vec3::UnitX()), 0.97 * (1 - s / 300));
            const RetractionResult planes = retracted(side, crease_slide(side, s), RetractionMode::planes);
            EXPECT_GT(squash(side, planes.V, Vec3::UnitX()), 0.87 * (1 - s / 300));
            for (const RetractionResult& result : {harmonic, planes}) {
                EXPECT_EQ(result.flipped, 0);
                EXPECT_LT(largest_distance_to_side(side, result.V), 1e-9);
            }
        }
    }
}

TEST(Retraction, DoesAsWellOnAFineMesh)
{
    const SideMesh side = left_side(crease_panel(240, 160, Diagonals::random), crease_panel_line(240, 160));
    const RetractionResult result = retracted(side, crease_slide(side, 100), RetractionMode::harmonic);
    EXPECT_GT(squash(side, result.V, Vec3::UnitX()), 0.6);
    EXPECT_EQ(result.flipped, 0);
}

TEST(Retraction, OfASymmetricSideIsSymmetric)
{
    const int nx = 60;
    const SideMesh side = left_side(crease_panel(nx, 40), crease_panel_line(nx, 40));
    for (const RetractionMode mode : modes) {
        const Positions V = retracted(side, crease_slide(side, 100), mode).V;
        double residual = 0;
        for (int v = 0; v < V.rows(); ++v) {
            // Rows of nx + 1 vertices, from the crease upwards.
            const int mirror = v / (nx + 1) * (nx + 1) + nx - v % (nx + 1);
            const Vec3 p = V.row(v), q = V.row(mirror);
            residual = std::max(residual, (p - Vec3(-q.x(), q.y(), q.z())).norm());
        }
        EXPECT_LT(residual, 1e-6);
    }
}

TEST(Retraction, OfAZigzagSlidesOnlyWhereTheLineComesIn)
{
    const SideMesh side = left_side(crease_panel(60, 40, Diagonals::random), crease_panel_line(60, 40));
    std::vector<Vec3> u;
    double largest = 0;
    for (const int v : side.line) {
        const Vec3 p = side.mesh.V.row(v);
        const double y = 60 * std::sin(p.x() * std::numbers::pi / 200) * std::pow(std::cos(p.x() / 400 * 1.57), 2);
        u.push_back(Vec3(p.x(), y, crease_panel_height(p.x(), y)) - p);
        largest = std::max(largest, u.back().norm());
    }
    for (const RetractionMode mode : modes) {
        RetractionOptions options;
        options.mode = mode;
        options.material.stiff_direction = Vec3::UnitY();
        const auto result = retract(side, u, options);
        ASSERT_TRUE(result);
        EXPECT_EQ(result->flipped, 0);
        EXPECT_GT(result->min_area_ratio, 0.5);
        for (size_t i = 0; i < u.size(); ++i) {
            const Vec3 moved = result->V.row(side.line[i]) - side.mesh.V.row(side.line[i]);
            // The corner between coming in and going out is rounded, so that a growing zigzag takes no vertex along all
            // at once: by a quarter of its half width.
            const double rounded = std::abs(u[i].y()) < 0.06 * largest ? 0.06 * largest / 4 : 0;
            EXPECT_LT((moved - (u[i].y() > 0 ? u[i] : Vec3(Vec3::Zero()))).norm(), 0.1 + rounded) << u[i].transpose();
        }
        EXPECT_LT((result->V.row(side.line.front()) - side.mesh.V.row(side.line.front())).norm(), 1e-9);
        EXPECT_LT((result->V.row(side.line.back()) - side.mesh.V.row(side.line.back())).norm(), 1e-9);
    }
}

TEST(Retraction, FadesWithoutAStepWhereTheLineTurnsOutOfTheSide)
{
    // A slide along the line that swings from into the side to out of it: neighbours must not part.
    const int nx = 200;
    const SideMesh side = left_side(flat_roof(nx, 4), grid_row(nx, 2));
    std::vector<Vec3> u;
    for (const int v : side.line) {
        const double x = side.mesh.V(v, 0);
        u.push_back(std::abs(x) < 1990 ? Vec3(30, -x / 20, 0.3 * x / 20) : Vec3::Zero());
    }
    const Positions V = retracted(side, u, RetractionMode::harmonic).V;
    for (int i = 2; i + 2 < nx; ++i) {
        const Vec3 a = V.row(side.line[i]) - side.mesh.V.row(side.line[i]);
        const Vec3 b = V.row(side.line[i + 1]) - side.mesh.V.row(side.line[i + 1]);
        EXPECT_LT((a - b).norm(), 7);
    }
}

TEST(Retraction, MovesAndScalesWithTheModel)
{
    const SideMesh side = left_side(crease_panel(30, 20, Diagonals::random), crease_panel_line(30, 20));
    const std::vector<Vec3> u = crease_slide(side, 80);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.8, Vec3(1, 2, -0.7).normalized()).toRotationMatrix();
    const Vec3 shift(-500, 2000, 70);
    for (const double scale : {1.0, 1e-3, 1e3}) {
        SideMesh other = side;
        other.mesh.V = transformed(side.mesh.V, scale, R, scale * shift);
        std::vector<Vec3> turned;
        for (const Vec3& d : u) {
            turned.push_back(scale * (R * d));
        }
        for (const RetractionMode mode : modes) {
            const Positions expected = transformed(retracted(side, u, mode).V, scale, R, scale * shift);
            EXPECT_LT((retracted(other, turned, mode).V - expected).cwiseAbs().maxCoeff(), 1e-7 * scale);
        }
    }
}

TEST(Retraction, RefusesWhatItCannotSlide)
{
    SideMesh side = left_side(crease_panel(10, 8), grid_row(10, 4));
    std::vector<Vec3> u(side.line.size(), Vec3::Zero());
    u.pop_back();
    EXPECT_EQ(retract(side, u).error().kind, ErrorKind::usage);
    u.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
    EXPECT_EQ(retract(side, u).error().kind, ErrorKind::rejected);
    u.back().setZero();
    EXPECT_TRUE(retract(side, u));
    side.mesh.V.row(side.mesh.F(0, 0)) = side.mesh.V.row(side.mesh.F(0, 1));
    const auto flat = retract(side, u);
    ASSERT_FALSE(flat);
    EXPECT_NE(flat.error().message.find("no area"), std::string::npos);
}

TEST(Retraction, SaysWhenTheSlideIsLongerThanTheSide)
{
    const FlatSide flat(Diagonals::alternating, 1300);
    EXPECT_GT(retracted(flat.side, flat.u, RetractionMode::planes).flipped, 0);
}
