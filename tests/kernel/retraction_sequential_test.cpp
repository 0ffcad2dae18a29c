// SPDX-License-Identifier: GPL-3.0-or-later
// Sliding one vertex of the line after the other: it does its job, and its places depend on the order.
#include "kernel/closest_point.h"
#include "kernel/retraction.h"
#include "kernel/sliding.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

RetractionOptions options_for(RetractionMode mode, double radius = 0, double stiffness_ratio = 100)
{
    RetractionOptions options;
    options.mode = mode;
    options.material.stiffness_ratio = stiffness_ratio;
    options.material.stiff_direction = Vec3::UnitY();
    options.active_radius_mm = radius;
    return options;
}

Positions retracted(const SideMesh& side, const std::vector<Vec3>& u, RetractionMode mode, double radius = 0,
                    double stiffness_ratio = 100)
{
    auto result = retract(side, u, options_for(mode, radius, stiffness_ratio));
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? result->V : side.mesh.V;
}

/// Largest distance between a vertex and the mirror image (x -> -x) of its partner on a grid of nx cells along x.
double mirror_residual(const SideMesh& side, const Positions& V)
{
    double largest = 0;
    for (int v = 0; v < V.rows(); ++v) {
        const Vec3 mirrored = Vec3(side.mesh.V.row(v)).cwiseProduct(Vec3(-1, 1, 1));
        Eigen::Index partner = 0;
        (side.mesh.V.rowwise() - mirrored.transpose()).rowwise().norm().minCoeff(&partner);
        largest = std::max(largest, (Vec3(V.row(v)).cwiseProduct(Vec3(-1, 1, 1)) - Vec3(V.row(partner))).norm());
    }
    return largest;
}

/// A frustum about the z axis with n segments round it: radius 100 at the top to 200 at the bottom, 150 high.
Mesh frustum(int n, int rows)
{
    Mesh mesh;
    mesh.V.resize(n * (rows + 1), 3);
    mesh.F.resize(2 * n * rows, 3);
    for (int j = 0; j <= rows; ++j) {
        const double share = static_cast<double>(j) / rows, r = 100 + 100 * share;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            mesh.V.row(j * n + i) << r * std::cos(angle), r * std::sin(angle), 150 * (1 - share);
        }
    }
    for (int j = 0, t = 0; j < rows; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * n + i, b = j * n + (i + 1) % n, c = a + n, d = b + n;
            mesh.F.row(t++) << a, c, b;
            mesh.F.row(t++) << b, c, d;
        }
    }
    return mesh;
}

/// How unevenly the vertices of each ring have moved: largest spread of radius and height within a ring [mm].
double axial_residual(const SideMesh& side, const Positions& V, int n)
{
    double largest = 0;
    for (int ring = 0; ring + n <= V.rows(); ring += n) {
        // Rings hang together in the local numbering, which keeps the order of the whole mesh.
        const Eigen::VectorXd radius = V.middleRows(ring, n).leftCols(2).rowwise().norm();
        const Eigen::VectorXd height = V.middleRows(ring, n).col(2);
        largest = std::max({largest, radius.maxCoeff() - radius.minCoeff(), height.maxCoeff() - height.minCoeff()});
    }
    EXPECT_EQ(V.rows() % n, 0);
    EXPECT_EQ(V.rows(), side.mesh.V.rows());
    return largest;
}

} // namespace

TEST(SequentialRetraction, PutsTheLineOnItsTargetAndEverythingOnTheSurface)
{
    const SideMesh side = left_side(crease_panel(40, 30, Diagonals::random), crease_panel_line(40, 30));
    const std::vector<Vec3> u = crease_slide(side, 60);
    const auto result = retract(side, u, options_for(RetractionMode::sequential));
    ASSERT_TRUE(result);
    const ClosestPoint surface({side.mesh.V, side.mesh.F.topRows(side.inner_faces)});
    for (size_t i = 0; i < u.size(); ++i) {
        const Vec3 goal = surface.closest(Vec3(side.mesh.V.row(side.line[i])) + u[i]).point;
        EXPECT_LT((Vec3(result->V.row(side.line[i])) - goal).norm(), 1e-12);
    }
    for (int v = 0; v < side.mesh.V.rows(); ++v) {
        if (side.mesh.V(v, 1) <= 300) {
            EXPECT_LT(surface.closest(result->V.row(v)).distance, 1e-9);
        }
    }
    for (const int v : side.fixed) {
        EXPECT_EQ(result->V.row(v), side.mesh.V.row(v));
    }
    EXPECT_EQ(result->flipped, 0);
    EXPECT_GT(result->min_area_ratio, 0.1);
}

TEST(SequentialRetraction, DragsAVertexByTheDampedWay)
{
    // The last vertex of a flat side's line moves, when all others have had their turn: what may move follows it by
    // (1 - (r/R)²)².
    const Mesh mesh = grid(20, 20, -100, 100, -100, 100, [](double, double) { return 0.0; });
    const SideMesh side = left_side(mesh, grid_row(20, 10));
    std::vector<Vec3> u(side.line.size(), Vec3::Zero());
    u.back() = Vec3(0, 8, 0);
    const double R = 50;
    const Positions V = retracted(side, u, RetractionMode::sequential, R);
    const Vec3 centre = side.mesh.V.row(side.line.back());
    int dragged = 0;
    for (int v = 0; v < V.rows(); ++v) {
        const bool held =
            std::ranges::binary_search(side.fixed, v) || std::ranges::find(side.line, v) != side.line.end();
        const double r = (Vec3(side.mesh.V.row(v)) - centre).norm() / R;
        const double way = v == side.line.back() ? 8 : (r < 1 && !held ? std::pow(1 - r * r, 2) * 8 : 0);
        EXPECT_LT((V.row(v) - side.mesh.V.row(v) - Eigen::RowVector3d(0, way, 0)).norm(), 1e-9) << v;
        dragged += way > 0 ? 1 : 0;
    }
    EXPECT_GT(dragged, 10);
}

TEST(SequentialRetraction, DependsOnTheOrderWhereTheHarmonicOneDoesNot)
{
    // Panel, line and slide are mirror symmetric about x = 0; the order, from one end to the other, is not.
    const SideMesh side = left_side(crease_panel(40, 30), crease_panel_line(40, 30));
    const std::vector<Vec3> u = crease_slide(side, 60);
    EXPECT_LT(mirror_residual(side, retracted(side, u, RetractionMode::harmonic)), 1e-6);
    EXPECT_GT(mirror_residual(side, retracted(side, u, RetractionMode::sequential)), 1);
    // The other way round gives another answer.
    SideMesh reversed = side;
    std::ranges::reverse(reversed.line);
    std::vector<Vec3> back = u;
    std::ranges::reverse(back);
    const auto apart = [&](RetractionMode mode) {
        return (retracted(side, u, mode) - retracted(reversed, back, mode)).rowwise().norm().maxCoeff();
    };
    EXPECT_LT(apart(RetractionMode::harmonic), 1e-6);
    EXPECT_GT(apart(RetractionMode::sequential), 1);
}

TEST(SequentialRetraction, LosesTheSymmetryOfABodyOfRevolution)
{
    const int n = 48;
    const Mesh mesh = frustum(n, 12);
    std::vector<int> ring(n);
    for (int i = 0; i < n; ++i) {
        ring[i] = 4 * n + i;
    }
    const auto sides = split_along(line_across(mesh, ring, true));
    ASSERT_TRUE(sides);
    for (const SideMesh& side : *sides) {
        // Towards the side's own rim, along the frustum.
        const double down = side.mesh.V.col(2).minCoeff() < 1 ? 1 : -1;
        std::vector<Vec3> u;
        for (const int v : side.line) {
            const Vec3 p = side.mesh.V.row(v);
            u.push_back(20 * down * (Vec3(p.x(), p.y(), 0).normalized() * 100 + Vec3(0, 0, -150)).normalized());
        }
        const double harmonic = axial_residual(side, retracted(side, u, RetractionMode::harmonic, 0, 1), n);
        const double sequential = axial_residual(side, retracted(side, u, RetractionMode::sequential), n);
        EXPECT_LT(harmonic, 0.1);
        EXPECT_GT(sequential, 10 * harmonic);
        EXPECT_GT(sequential, 1);
    }
}

TEST(Slide, GoesOnFromAPointInsideATriangle)
{
    // Two steps are one on a plane, and round a pipe the way is a helix that keeps its angle and length.
    const Mesh flat = grid(
        20, 20, -100, 100, -100, 100, [](double, double) { return 0.0; }, Diagonals::random);
    const Topology topology(flat.F, static_cast<int>(flat.V.rows()));
    const int v = 10 * 21 + 10;
    const Vec3 start = flat.V.row(v);
    for (int i = 0; i < 36; ++i) {
        const Vec3 u(std::cos(i * 0.1745), std::sin(i * 0.1745), 0);
        const MeshPoint first = slide(flat, topology, v, 17.3 * u);
        const MeshPoint second = slide(flat, topology, first, Vec3::UnitZ(), 31.9 * u);
        EXPECT_LT((position_of(flat, second) - start - (17.3 + 31.9) * u).norm(), 1e-9) << i;
        const MeshPoint back = slide(flat, topology, second, Vec3::UnitZ(), -(17.3 + 31.9) * u);
        EXPECT_LT((position_of(flat, back) - start).norm(), 1e-9) << i;
    }
    // At the border it stops, a zero or non-finite way stays.
    const MeshPoint out = slide(flat, topology, slide(flat, topology, v, {3, 1, 0}), Vec3::UnitZ(), {500, 0, 0});
    EXPECT_NEAR(position_of(flat, out).x(), 100, 1e-9);
    const MeshPoint here = slide(flat, topology, v, {3, 1, 0});
    EXPECT_EQ(position_of(flat, slide(flat, topology, here, Vec3::UnitZ(), Vec3::Zero())), position_of(flat, here));
    EXPECT_EQ(position_of(flat, slide(flat, topology, here, Vec3::UnitZ(), {0, NAN, 0})), position_of(flat, here));
}
