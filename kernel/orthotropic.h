// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <Eigen/Sparse>
#include <vector>

namespace tapeline {

/// Which direction of the material is the stiffer one (method.md A1, B2).
enum class Stiff { along, across };

/// An orthotropic material on a surface: stiffness ratio μ ≥ 1 and the direction d_o, a unit vector in space whose
/// projection on each triangle (not normalised) orients the material there. μ = 1 is isotropic.
struct Material {
    double stiffness_ratio = 100;
    Stiff stiff = Stiff::along;
    Vec3 stiff_direction = Vec3::UnitX();
};

/// Linear finite element of one triangle in its rest plane (method.md B0).
struct TriangleElement {
    double area = 0;                      ///< [mm²]
    Eigen::Matrix<double, 3, 2> basis;    ///< E_t: orthonormal basis of the rest plane
    Eigen::Matrix<double, 2, 3> gradient; ///< columns g_i, g_j, g_k: gradients of the corners' hat functions [1/mm]
    Eigen::Matrix2d material;             ///< D_t in that basis
};

/// One element per triangle of `rest`. Triangles must have positive area.
std::vector<TriangleElement> triangle_elements(const Mesh& rest, const Material& material);

/// K_ab = Σ_t A_t g_aᵀ D_t g_b (method.md B5), n×n, symmetric positive semi-definite; the cotangent Laplacian at μ = 1.
Eigen::SparseMatrix<double> stiffness_matrix(const Mesh& rest, const std::vector<TriangleElement>& elements);

/// Minimises tr(Xᵀ K X) with the listed rows of X given: the (orthotropic) harmonic extension of boundary values.
/// `values` has one row per entry of `constrained`. Rows that K does not connect to a constraint come out as zero.
Eigen::MatrixXd harmonic_extension(const Eigen::SparseMatrix<double>& K, const std::vector<int>& constrained,
                                   const Eigen::MatrixXd& values);

} // namespace tapeline
