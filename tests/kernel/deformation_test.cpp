// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/deformation.h"
#include "tests/support/pull.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <tbb/global_control.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

DeformationOptions with(double ratio, Stiff stiff, const Vec3& direction, double tolerance_mm)
{
    DeformationOptions options;
    options.material = {ratio, stiff, direction};
    options.tolerance_mm = tolerance_mm;
    return options;
}

} // namespace

TEST(Deformation, OfNothingIsTheRestShapeWithoutEnergy)
{
    const Pull none(crease_panel(12, 10, Diagonals::random), crease_panel_line(12, 10),
                    [](const Vec3& p) { return p; });
    for (const Stiff stiff : {Stiff::along, Stiff::across}) {
        const auto result = deform(none.mesh, none.constrained, none.targets, with(100, stiff, Vec3::UnitY(), 1e-6));
        ASSERT_TRUE(result);
        EXPECT_TRUE(result->converged);
        EXPECT_LT(largest_difference(result->V, none.mesh.V), 1e-9);
        EXPECT_LT(result->energy, 1e-15);
    }
}

TEST(Deformation, ReproducesRigidMotionsOfItsConstraints)
{
    const Pull pull = off_surface_pull(12, 10, Diagonals::random);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1, Vec3(1, -2, 2).normalized()).toRotationMatrix();
    const Positions moved = transformed(pull.mesh.V, 1, R, {100, -50, 30});
    Positions targets = pull.targets;
    for (size_t i = 0; i < pull.constrained.size(); ++i) {
        targets.row(static_cast<Eigen::Index>(i)) = moved.row(pull.constrained[i]);
    }
    for (const double ratio : {1.0, 100.0}) {
        const auto result =
            deform(pull.mesh, pull.constrained, targets, with(ratio, Stiff::along, Vec3::UnitY(), 1e-9));
        ASSERT_TRUE(result);
        EXPECT_TRUE(result->converged);
        EXPECT_LT(largest_difference(result->V, moved), 1e-8);
    }
}

TEST(Deformation, KeepsAFlatPatchAffineWhenItsBorderIs)
{
    // The patch test: any triangles (a third of the assembled weights negative), any constant material.
    const Mesh mesh = grid(
        16, 12, -80, 80, -60, 60, [](double, double) { return 0.0; }, Diagonals::random);
    const ExtendedLine whole = line_across(mesh, grid_row(16, 6));
    Eigen::Matrix3d A;
    A << 1.25, 0.2, 0, 0.1, 0.85, 0, 0, 0, 1;
    const Positions affine = mesh.V * A.transpose();
    const std::vector<int>& rim = whole.region.fixed_rim;
    Positions targets(static_cast<Eigen::Index>(rim.size()), 3);
    for (size_t i = 0; i < rim.size(); ++i) {
        targets.row(static_cast<Eigen::Index>(i)) = affine.row(rim[i]);
    }
    for (const Stiff stiff : {Stiff::along, Stiff::across}) {
        for (const double ratio : {1.0, 30.0}) {
            const auto result = deform(mesh, rim, targets, with(ratio, stiff, Vec3(1, 2, 0).normalized(), 1e-10));
            ASSERT_TRUE(result);
            EXPECT_LT(largest_difference(result->V, affine), 1e-9);
        }
    }
}

TEST(Deformation, WithRatioOneDoesNotKnowItsDirection)
{
    const Pull pull = off_surface_pull(16, 12);
    const auto one = deform(pull.mesh, pull.constrained, pull.targets, with(1, Stiff::along, Vec3::UnitY(), 1e-3));
    const auto two = deform(pull.mesh, pull.constrained, pull.targets, with(1, Stiff::across, Vec3::UnitX(), 1e-3));
    ASSERT_TRUE(one && two);
    EXPECT_EQ(one->V, two->V);
}

TEST(Deformation, EndsWithinItsOwnErrorEstimate)
{
    const Pull pull = off_surface_pull(24, 18, Diagonals::random);
    for (const Stiff stiff : {Stiff::along, Stiff::across}) {
        const auto exact = deform(pull.mesh, pull.constrained, pull.targets, with(100, stiff, Vec3::UnitY(), 1e-8));
        const auto quick = deform(pull.mesh, pull.constrained, pull.targets, with(100, stiff, Vec3::UnitY(), 0.1));
        ASSERT_TRUE(exact && quick);
        EXPECT_TRUE(exact->converged && quick->converged);
        EXPECT_LE(quick->error_estimate_mm, 0.1);
        EXPECT_LT(largest_difference(exact->V, quick->V), 0.1);
        EXPECT_LE(exact->energy, quick->energy * (1 + 1e-12));
        for (size_t i = 0; i < pull.constrained.size(); ++i) {
            EXPECT_EQ(quick->V.row(pull.constrained[i]), pull.targets.row(static_cast<Eigen::Index>(i)));
        }
    }
}

TEST(Deformation, SaysWhenItDidNotConverge)
{
    const Pull pull = off_surface_pull(16, 12);
    DeformationOptions options = with(100, Stiff::along, Vec3::UnitY(), 1e-9);
    options.max_iterations = 5;
    const auto result = deform(pull.mesh, pull.constrained, pull.targets, options);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->converged);
    EXPECT_GT(result->error_estimate_mm, 1e-9);
}

TEST(Deformation, GivesTheSameBytesOnOneThreadAndOnTwo)
{
    const Pull pull = off_surface_pull(40, 30, Diagonals::random);
    const auto on_threads = [&](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return deform(pull.mesh, pull.constrained, pull.targets, with(100, Stiff::along, Vec3::UnitZ(), 1e-2))->V;
    };
    const Positions one = on_threads(1), two = on_threads(2), again = on_threads(2);
    const size_t bytes = sizeof(double) * one.size();
    EXPECT_EQ(std::memcmp(one.data(), two.data(), bytes), 0);
    EXPECT_EQ(std::memcmp(two.data(), again.data(), bytes), 0);
}

TEST(Deformation, StopsWhenItIsCancelled)
{
    const Pull pull = off_surface_pull(16, 12);
    double last = 0;
    const Progress progress([&](double fraction, std::string_view) {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1);
        last = fraction;
        return fraction < 0.2;
    });
    const auto result =
        deform(pull.mesh, pull.constrained, pull.targets, with(100, Stiff::along, Vec3::UnitY(), 1e-9), {}, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::cancelled);
}

TEST(Deformation, RefusesLooseVerticesAndTrianglesWithoutArea)
{
    Pull pull = off_surface_pull(8, 6);
    Mesh loose = pull.mesh;
    loose.V.conservativeResize(loose.V.rows() + 1, 3);
    loose.V.bottomRows(1) << 1, 2, 3;
    const auto hanging = deform(loose, pull.constrained, pull.targets, {});
    ASSERT_FALSE(hanging);
    EXPECT_NE(hanging.error().message.find("(1, 2, 3)"), std::string::npos);
    pull.mesh.V.row(20) = pull.mesh.V.row(21);
    const auto flat = deform(pull.mesh, pull.constrained, pull.targets, {});
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().kind, ErrorKind::rejected);
}
