// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Sparse>
#include <memory>

namespace tapeline {

/// Cholesky factorisation of a sparse symmetric positive definite matrix, kept for many right-hand sides.
/// Eigen's SimplicialLDLT up to 20 000 unknowns, CHOLMOD (supernodal, AMD ordering) above. Deterministic: the
/// factorisation runs its BLAS on one thread.
class CholeskySolver {
public:
    CholeskySolver();
    ~CholeskySolver();
    CholeskySolver(CholeskySolver&&) noexcept;
    CholeskySolver& operator=(CholeskySolver&&) noexcept;

    /// False when the matrix is not positive definite.
    bool factorize(const Eigen::SparseMatrix<double>& A);

    /// Solves A X = B for every column of B (size n×k). Only after a successful `factorize`.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tapeline
