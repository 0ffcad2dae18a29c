// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/orthotropic.h"
#include "tests/support/shapes.h"

#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// The cotangent matrix straight from the corner angles.
Eigen::MatrixXd cotangent_matrix(const Mesh& mesh)
{
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(mesh.V.rows(), mesh.V.rows());
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.F(t, (k + 1) % 3), b = mesh.F(t, (k + 2) % 3), c = mesh.F(t, k);
            const Vec3 ca = mesh.V.row(a) - mesh.V.row(c), cb = mesh.V.row(b) - mesh.V.row(c);
            const double angle = std::acos(ca.dot(cb) / (ca.norm() * cb.norm()));
            const double w = 0.5 / std::tan(angle);
            K(a, b) -= w;
            K(b, a) -= w;
            K(a, a) += w;
            K(b, b) += w;
        }
    }
    return K;
}

Eigen::MatrixXd stiffness(const Mesh& mesh, const Material& material)
{
    return stiffness_matrix(mesh, triangle_elements(mesh, material));
}

/// The mesh scaled by `s` along unit vector d.
Mesh stretched(const Mesh& mesh, double s, const Vec3& d)
{
    const Eigen::Matrix3d S = Eigen::Matrix3d::Identity() + (s - 1) * d * d.transpose();
    return {mesh.V * S, mesh.F};
}

double relative_difference(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B)
{
    return (A - B).cwiseAbs().maxCoeff() / B.cwiseAbs().maxCoeff();
}

} // namespace

TEST(Orthotropic, WithRatioOneIsTheCotangentMatrix)
{
    const Mesh mesh = crease_panel(12, 10, Diagonals::random);
    for (const Stiff stiff : {Stiff::along, Stiff::across}) {
        const Material material{1, stiff, Vec3(1, 2, 3).normalized()};
        EXPECT_LT(relative_difference(stiffness(mesh, material), cotangent_matrix(mesh)), 1e-12);
    }
}

TEST(Orthotropic, StiffAcrossOnAPlaneIsTheCotangentMatrixOfTheStretchedMesh)
{
    const Mesh mesh = grid(
        9, 7, 0, 90, 0, 70, [](double, double) { return 0.0; }, Diagonals::random);
    const Vec3 d = Vec3(1, 0.7, 0).normalized();
    for (const double ratio : {4.0, 100.0}) {
        const double s = std::sqrt(ratio);
        const Eigen::MatrixXd expected = cotangent_matrix(stretched(mesh, s, d)) / s;
        EXPECT_LT(relative_difference(stiffness(mesh, {ratio, Stiff::across, d}), expected), 1e-10);
        // Stiff along d is stiff across what is orthogonal to it.
        const Vec3 normal(d.y(), -d.x(), 0);
        const Eigen::MatrixXd along = cotangent_matrix(stretched(mesh, s, normal)) / s * ratio;
        EXPECT_LT(relative_difference(stiffness(mesh, {ratio, Stiff::along, d}), along), 1e-10);
    }
}

TEST(Orthotropic, StiffAcrossOnACurvedSurfaceIsTheSameUpToAFactorPerTriangle)
{
    const Mesh mesh = crease_panel(10, 8, Diagonals::random);
    const Vec3 d = Vec3(0.3, 1, 0.4).normalized();
    const double ratio = 50;
    std::vector<TriangleElement> elements = triangle_elements(mesh, {ratio, Stiff::across, d});
    for (TriangleElement& element : elements) {
        element.material *= std::sqrt(1 + (ratio - 1) * (element.basis.transpose() * d).squaredNorm());
    }
    const Eigen::MatrixXd K = stiffness_matrix(mesh, elements);
    EXPECT_LT(relative_difference(K, cotangent_matrix(stretched(mesh, std::sqrt(ratio), d))), 1e-10);
}

TEST(Orthotropic, IsIsotropicWhereTheDirectionIsNormalToTheSurface)
{
    const Mesh mesh = grid(
        6, 6, 0, 6, 0, 6, [](double, double) { return 0.0; }, Diagonals::random);
    for (const Stiff stiff : {Stiff::along, Stiff::across}) {
        EXPECT_LT(relative_difference(stiffness(mesh, {100, stiff, Vec3::UnitZ()}), cotangent_matrix(mesh)), 1e-12);
    }
}

TEST(HarmonicExtension, ReproducesLinearFieldsOnAPlaneInAnyMaterial)
{
    const Mesh mesh = grid(
        14, 9, 0, 140, 0, 90, [](double, double) { return 0.0; }, Diagonals::random);
    const Material material{100, Stiff::along, Vec3(1, 0.3, 0).normalized()};
    Eigen::MatrixXd linear(mesh.V.rows(), 2);
    linear.col(0) = 0.3 * mesh.V.col(0) - 2 * mesh.V.col(1);
    linear.col(1) = mesh.V.col(1).array() + 5;
    std::vector<int> border;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (mesh.V(v, 0) == 0 || mesh.V(v, 0) == 140 || mesh.V(v, 1) == 0 || mesh.V(v, 1) == 90) {
            border.push_back(v);
        }
    }
    Eigen::MatrixXd values(static_cast<Eigen::Index>(border.size()), 2);
    for (size_t i = 0; i < border.size(); ++i) {
        values.row(static_cast<Eigen::Index>(i)) = linear.row(border[i]);
    }
    const Eigen::MatrixXd K = stiffness(mesh, material);
    const Eigen::MatrixXd X = harmonic_extension(K.sparseView(), border, values);
    EXPECT_LT((X - linear).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(HarmonicExtension, LeavesWhatHangsOnNoConstraintAtZero)
{
    const Mesh one = grid(3, 3, 0, 3, 0, 3, [](double, double) { return 0.0; });
    Mesh two{Positions(32, 3), Triangles(36, 3)};
    two.V << one.V, one.V;
    two.F << one.F, (one.F.array() + 16).matrix();
    const Eigen::MatrixXd K = stiffness(two, {1, Stiff::along, Vec3::UnitX()});
    const Eigen::MatrixXd X = harmonic_extension(K.sparseView(), {0}, Eigen::MatrixXd::Constant(1, 1, 7));
    EXPECT_LT((X.topRows(16).array() - 7).abs().maxCoeff(), 1e-9);
    EXPECT_EQ(X.bottomRows(16).cwiseAbs().maxCoeff(), 0);
}
