// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/elimination.h"

namespace tapeline {

bool Elimination::factorize(const Eigen::SparseMatrix<double>& K, const std::vector<int>& given)
{
    const int n = static_cast<int>(K.rows());
    given_ = given;
    free_.clear();
    // Row v is unknown number place[v], or given number -1 - place[v].
    std::vector<int> place(n, 0);
    for (size_t i = 0; i < given.size(); ++i) {
        place[given[i]] = -1 - static_cast<int>(i);
    }
    for (int v = 0; v < n; ++v) {
        if (place[v] >= 0) {
            place[v] = free_count();
            free_.push_back(v);
        }
    }
    std::vector<Eigen::Triplet<double>> free_entries, coupling_entries;
    for (int column = 0; column < n; ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it) {
            const int row = place[it.row()];
            const int other = place[column];
            if (row >= 0 && other >= 0) {
                free_entries.emplace_back(row, other, it.value());
            } else if (row >= 0) {
                coupling_entries.emplace_back(row, -1 - other, it.value());
            }
        }
    }
    K_free_.resize(free_count(), free_count());
    K_free_.setFromTriplets(free_entries.begin(), free_entries.end());
    K_coupling_.resize(free_count(), static_cast<Eigen::Index>(given.size()));
    K_coupling_.setFromTriplets(coupling_entries.begin(), coupling_entries.end());
    return free_count() == 0 || solver_.factorize(K_free_);
}

Eigen::MatrixXd Elimination::assemble(const Eigen::MatrixXd& unknowns) const
{
    Eigen::MatrixXd all(free_.size() + given_.size(), values_.cols());
    for (int i = 0; i < free_count(); ++i) {
        all.row(free_[i]) = unknowns.row(i);
    }
    for (size_t i = 0; i < given_.size(); ++i) {
        all.row(given_[i]) = values_.row(static_cast<Eigen::Index>(i));
    }
    return all;
}

Eigen::MatrixXd Elimination::extract(const Eigen::MatrixXd& all) const
{
    Eigen::MatrixXd unknowns(free_count(), all.cols());
    for (int i = 0; i < free_count(); ++i) {
        unknowns.row(i) = all.row(free_[i]);
    }
    return unknowns;
}

Eigen::MatrixXd Elimination::solve(const Eigen::MatrixXd& b) const
{
    return correction(extract(b) - K_coupling_ * values_);
}

Eigen::MatrixXd Elimination::residual(const Eigen::MatrixXd& unknowns, const Eigen::MatrixXd& b) const
{
    return extract(b) - K_coupling_ * values_ - K_free_ * unknowns;
}

Eigen::MatrixXd Elimination::response(const Eigen::MatrixXd& change) const { return -correction(K_coupling_ * change); }

Eigen::MatrixXd Elimination::correction(const Eigen::MatrixXd& residual) const
{
    return free_count() == 0 ? Eigen::MatrixXd(0, residual.cols()) : solver_.solve(residual);
}

} // namespace tapeline
