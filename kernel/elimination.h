// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/linear_solver.h"

#include <Eigen/Sparse>
#include <vector>

namespace tapeline {

/// A sparse symmetric positive definite system K x = b in which some rows of x are given: they are eliminated, and
/// K_ff x_f = b_f - K_fc x_c is factorised once (method.md B5). x and b may have any number of columns. "Unknowns" are
/// the free rows of x in ascending order.
class Elimination {
public:
    /// Takes K (n×n) and the rows that are given. False when what is left is not positive definite.
    bool factorize(const Eigen::SparseMatrix<double>& K, const std::vector<int>& given);

    int free_count() const { return static_cast<int>(free_.size()); }
    const std::vector<int>& free_rows() const { return free_; }
    const std::vector<int>& given_rows() const { return given_; }

    /// The given rows' values, in the order given to `factorize`.
    void set(const Eigen::MatrixXd& values) { values_ = values; }
    const Eigen::MatrixXd& values() const { return values_; }

    /// All n rows from the unknowns and the given values.
    Eigen::MatrixXd assemble(const Eigen::MatrixXd& unknowns) const;
    /// The unknowns' rows of all n rows.
    Eigen::MatrixXd extract(const Eigen::MatrixXd& all) const;

    /// The unknowns that solve the system for the right-hand side `b` (n rows) and the given values.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
    /// b_f - K_fc x_c - K_ff x_f: what is left over at these unknowns.
    Eigen::MatrixXd residual(const Eigen::MatrixXd& unknowns, const Eigen::MatrixXd& b) const;
    /// The unknowns' change that takes such a residual away.
    Eigen::MatrixXd correction(const Eigen::MatrixXd& residual) const;
    /// The unknowns' change when the given rows change by `change` and b stays; any number of columns.
    Eigen::MatrixXd response(const Eigen::MatrixXd& change) const;

private:
    std::vector<int> given_, free_;
    Eigen::SparseMatrix<double> K_free_, K_coupling_;
    CholeskySolver solver_;
    Eigen::MatrixXd values_;
};

} // namespace tapeline
