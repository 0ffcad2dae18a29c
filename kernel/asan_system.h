// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/deformation.h"
#include "kernel/linear_solver.h"

#include <Eigen/Sparse>
#include <utility>
#include <vector>

namespace tapeline {

/// The discretised ASAN energy with its constraints, factorised once (method.md B2, B5). State: the rotations of the
/// last local step. Unknowns are the free vertices' positions, one row each, in ascending vertex order.
class AsanSystem {
public:
    /// Rejected when a triangle has no area, a vertex hangs on no constraint, or the matrix cannot be factorised.
    static Result<AsanSystem> create(const Mesh& rest, const std::vector<int>& constrained, const Material& material);

    int free_count() const { return static_cast<int>(free_.size()); }
    const std::vector<int>& free_vertices() const { return free_; }

    /// Sets where the constrained vertices are (rows in the order given to `create`).
    void constrain(const Positions& targets);

    /// Positions of all vertices from the unknowns and the constraints.
    Positions assemble(const Eigen::MatrixXd& unknowns) const;
    /// The unknowns' rows of full positions.
    Eigen::MatrixXd extract(const Positions& V) const;

    /// The harmonic start: rest shape plus the K-harmonic extension of the constraints' displacements from `from`.
    Eigen::MatrixXd harmonic_start(const Positions& from) const;

    /// Local step: fits the rotations to the unknowns; returns the energy [mm²].
    double fit_rotations(const Eigen::MatrixXd& unknowns);
    /// Global step: the unknowns that minimise the energy for the fitted rotations.
    Eigen::MatrixXd solve_positions() const;
    /// Force residual relative to that of a unit strain, at these unknowns and the fitted rotations (method.md I7).
    double residual(const Eigen::MatrixXd& unknowns) const;
    /// Σ A tr D: what the energy's rounding noise is relative to [mm²].
    double energy_scale() const { return energy_scale_; }
    /// The energy without the cancellation of the local step's formula.
    double exact_energy(const Eigen::MatrixXd& unknowns) const;

private:
    AsanSystem() = default;
    void build_incidence();
    Eigen::MatrixXd right_hand_side() const;
    Eigen::Matrix<double, 3, 2> gradient(const Positions& V, int t) const;

    Mesh rest_;
    std::vector<TriangleElement> elements_;
    std::vector<int> constrained_, free_, unknown_of_;
    std::vector<int> corner_start_;
    std::vector<std::pair<int, int>> corners_; ///< (triangle, corner) around each vertex
    Eigen::SparseMatrix<double> K_free_, K_coupling_;
    CholeskySolver solver_;
    Positions targets_;
    std::vector<Eigen::Matrix3d> rotations_;
    double energy_scale_ = 0;
    double force_scale_ = 0;
};

} // namespace tapeline
