// SPDX-License-Identifier: GPL-3.0-or-later
// ARAP with spokes only, and with smooth rotations, against closed forms and against CGAL's deformer.
#include "kernel/baselines/smooth_rotations.h"
#include "kernel/baselines/spokes.h"
#include "kernel/baselines/spokes_system.h"
#include "tests/support/cgal_peer.h"
#include "tests/support/moves.h"
#include "tests/support/pull.h"
#include "tests/support/side.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

IterationOptions within(double tolerance_mm)
{
    IterationOptions options;
    options.tolerance_mm = tolerance_mm;
    return options;
}

SmoothRotationOptions smooth(double smoothness, double tolerance_mm) { return {within(tolerance_mm), smoothness}; }

/// A flat patch of even triangles with its border given an image under A: no angle is obtuse.
struct FlatPatch {
    Mesh mesh = grid(12, 10, -60, 60, -50, 50, [](double, double) { return 0.0; });
    std::vector<int> rim = line_across(mesh, grid_row(12, 5)).region.fixed_rim;
    double area = 120 * 100;
    Positions image(const Eigen::Matrix3d& A) const { return mesh.V * A.transpose(); }
    Positions targets(const Positions& V) const { return V(rim, Eigen::all); }
};

} // namespace

TEST(Spokes, ReproduceRigidMotionsOfTheirConstraints)
{
    const Pull pull = off_surface_pull(12, 10, Diagonals::random);
    const RigidMotion motion = some_rigid_motion();
    const Positions moved = transformed(pull.mesh.V, 1, motion.R, motion.shift);
    const auto plain = deform_spokes(pull.mesh, pull.constrained, pull.sent_to(moved), within(1e-10));
    const auto even = deform_smooth_rotations(pull.mesh, pull.constrained, pull.sent_to(moved), smooth(0.02, 1e-10));
    ASSERT_TRUE(plain && even);
    EXPECT_TRUE(plain->converged && even->converged);
    EXPECT_LT(largest_difference(plain->V, moved), 1e-9);
    EXPECT_LT(largest_difference(even->V, moved), 1e-9);
    EXPECT_LT(plain->energy, 1e-12);
    EXPECT_LT(even->energy, 1e-12);
}

TEST(Spokes, AreExactInOneStepOnIsometricData)
{
    // Every star of an isometric image is congruent to its star at rest, so the local step finds each rotation exactly
    // and the global step puts every vertex where it belongs, however far the constraints have turned.
    const Pull pull = off_surface_pull(12, 10, Diagonals::random);
    const RigidMotion motion = some_rigid_motion();
    const Positions moved = transformed(pull.mesh.V, 1, motion.R, motion.shift);
    auto system = SpokesSystem::create(pull.mesh, pull.constrained);
    ASSERT_TRUE(system);
    system->constrain(pull.sent_to(moved));
    EXPECT_NEAR(system->fit_rotations(system->extract(moved)), 0, 1e-13 * system->energy_scale());
    for (const Eigen::Matrix3d& R : system->rotations()) {
        EXPECT_LT((R - motion.R).cwiseAbs().maxCoeff(), 1e-12);
    }
    EXPECT_LT(largest_difference(system->assemble(system->solve_positions()), moved), 1e-9);
}

TEST(Spokes, StretchAFlatPatchEvenlyWithTheEnergyOfItsStrain)
{
    // Σ w e eᵀ over the edges of a flat mesh without obtuse angles is its area times the identity, so the energy of a
    // stretch diag(s, t) is ((s - 1)² + (t - 1)²) times the area.
    const FlatPatch patch;
    for (const auto& [s, t] : {std::pair(1.3, 1.0), std::pair(1.2, 0.9)}) {
        const Positions image = patch.image(Vec3(s, t, 1).asDiagonal());
        const auto result = deform_spokes(patch.mesh, patch.rim, patch.targets(image), within(1e-10));
        ASSERT_TRUE(result && result->converged);
        EXPECT_LT(largest_difference(result->V, image), 1e-9);
        EXPECT_NEAR(result->energy / (((s - 1) * (s - 1) + (t - 1) * (t - 1)) * patch.area), 1, 1e-9);
    }
}

TEST(Spokes, KeepObtuseTrianglesFromLoweringTheEnergyWithoutLimit)
{
    // Long cells: many opposite angles add up to more than 180°.
    const Mesh mesh = grid(
        20, 6, -400, 400, -30, 30, [](double x, double) { return x * x / 2000; }, Diagonals::random);
    int negative = 0;
    for (const WeightedEdge& edge : clamped_cotangents(mesh)) {
        EXPECT_GE(edge.weight, 0);
        negative += edge.weight == 0 ? 1 : 0;
    }
    EXPECT_GT(negative, 0);
    const std::vector<int> rim = line_across(mesh, grid_row(20, 3)).region.fixed_rim;
    auto system = SpokesSystem::create(mesh, rim);
    ASSERT_TRUE(system);
    Positions targets = mesh.V(rim, Eigen::all);
    targets.col(2) *= 1.5;
    system->constrain(targets);
    Eigen::MatrixXd x = system->harmonic_start(mesh.V);
    double energy = system->fit_rotations(x);
    for (int i = 0; i < 100; ++i) {
        x = system->solve_positions();
        const double next = system->fit_rotations(x);
        EXPECT_LE(next, energy + 1e-13 * system->energy_scale());
        EXPECT_GE(next, 0);
        energy = next;
    }
    EXPECT_NEAR(energy, system->exact_energy(x), 1e-12 * system->energy_scale());
}

TEST(Spokes, EndWithinTheirOwnErrorEstimate)
{
    const Pull pull = off_surface_pull(24, 18, Diagonals::random);
    const auto exact = deform_spokes(pull.mesh, pull.constrained, pull.targets, within(1e-7));
    const auto quick = deform_spokes(pull.mesh, pull.constrained, pull.targets, within(0.1));
    ASSERT_TRUE(exact && quick && exact->converged && quick->converged);
    EXPECT_LE(quick->error_estimate_mm, 0.1);
    EXPECT_LT(largest_difference(exact->V, quick->V), 0.1);
    const auto exact_smooth = deform_smooth_rotations(pull.mesh, pull.constrained, pull.targets, smooth(0.02, 1e-7));
    const auto quick_smooth = deform_smooth_rotations(pull.mesh, pull.constrained, pull.targets, smooth(0.02, 0.1));
    ASSERT_TRUE(exact_smooth && quick_smooth && exact_smooth->converged && quick_smooth->converged);
    EXPECT_LT(largest_difference(exact_smooth->V, quick_smooth->V), 0.1);
}

TEST(Spokes, AgreeWithCgalWhereTheMinimumIsUnique)
{
    const Pull pull = off_surface_pull(16, 12, Diagonals::random);
    const auto ours = deform_spokes(pull.mesh, pull.constrained, pull.targets, within(1e-5));
    ASSERT_TRUE(ours && ours->converged);
    const Positions half = cgal_smooth_rotations(pull.mesh, pull.constrained, pull.targets, 1000, 0);
    const Positions peer = cgal_smooth_rotations(pull.mesh, pull.constrained, pull.targets, 2000, 0);
    ASSERT_LT(largest_difference(half, peer), 1e-4) << "the peer has not converged";
    EXPECT_LT(largest_difference(ours->V, peer), 1e-3);
}

TEST(SmoothRotations, AgreeWithCgalOnEvenAndUnevenTriangles)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const Pull pull = off_surface_pull(16, 12, diagonals);
        const auto ours = deform_smooth_rotations(pull.mesh, pull.constrained, pull.targets, smooth(0.02, 1e-6));
        ASSERT_TRUE(ours && ours->converged);
        const Positions half = cgal_smooth_rotations(pull.mesh, pull.constrained, pull.targets, 1000, 0.02);
        const Positions peer = cgal_smooth_rotations(pull.mesh, pull.constrained, pull.targets, 2000, 0.02);
        ASSERT_LT(largest_difference(half, peer), 1e-4) << "the peer has not converged";
        EXPECT_LT(largest_difference(ours->V, peer), 1e-3);
        const auto spokes = deform_spokes(pull.mesh, pull.constrained, pull.targets, within(1e-3));
        ASSERT_TRUE(spokes);
        EXPECT_GT(largest_difference(ours->V, spokes->V), 1); // the smoothness matters here
    }
}

TEST(SmoothRotations, WithoutSmoothnessAreTheSpokes)
{
    const Pull pull = off_surface_pull(16, 12, Diagonals::random);
    const auto spokes = deform_spokes(pull.mesh, pull.constrained, pull.targets, within(1e-6));
    const auto none = deform_smooth_rotations(pull.mesh, pull.constrained, pull.targets, smooth(0, 1e-6));
    ASSERT_TRUE(spokes && none && spokes->converged && none->converged);
    EXPECT_LT(largest_difference(spokes->V, none->V), 1e-5);
    EXPECT_NEAR(none->energy, spokes->energy, 1e-9 * spokes->energy);
}

TEST(SmoothRotations, HoldBackTheBulgeOfACompressedSide)
{
    const Pull pull = crease_slide_pull(24, 18, 60);
    const auto spokes = deform_spokes(pull.mesh, pull.constrained, pull.targets, within(0.1));
    const auto even = deform_smooth_rotations(pull.mesh, pull.constrained, pull.targets, smooth(0.02, 0.1));
    ASSERT_TRUE(spokes && even && even->converged);
    const auto height = [&](const Positions& V) { return (V - pull.mesh.V).col(2).cwiseAbs().maxCoeff(); };
    EXPECT_GT(height(spokes->V), 2 * height(even->V));
}

TEST(SmoothRotations, RefuseANegativeSmoothness)
{
    const Pull pull = off_surface_pull(8, 6);
    const auto refused = deform_smooth_rotations(pull.mesh, pull.constrained, pull.targets, smooth(-1, 1e-3));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
}
