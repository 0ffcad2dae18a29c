// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/anderson.h"

#include <algorithm>

namespace tapeline {

void Anderson::restart()
{
    started_ = false;
    dF_.clear();
    dG_.clear();
}

Eigen::MatrixXd Anderson::next(const Eigen::MatrixXd& x, const Eigen::MatrixXd& G)
{
    if (window_ == 0) {
        return G;
    }
    const Eigen::MatrixXd F = G - x;
    if (!started_) {
        started_ = true;
        last_F_ = F;
        last_G_ = G;
        return G;
    }
    const Eigen::MatrixXd difference = F - last_F_;
    const double scale = 1 / std::max(difference.norm(), 1e-14);
    dF_.push_back(difference * scale);
    dG_.push_back((G - last_G_) * scale);
    if (static_cast<int>(dF_.size()) > window_) {
        dF_.pop_front();
        dG_.pop_front();
    }
    last_F_ = F;
    last_G_ = G;

    const auto m = static_cast<Eigen::Index>(dF_.size());
    Eigen::MatrixXd normal(m, m);
    Eigen::VectorXd right(m);
    for (Eigen::Index i = 0; i < m; ++i) {
        right[i] = dF_[i].cwiseProduct(F).sum();
        for (Eigen::Index j = 0; j <= i; ++j) {
            normal(i, j) = normal(j, i) = dF_[i].cwiseProduct(dF_[j]).sum();
        }
    }
    const Eigen::VectorXd theta = normal.completeOrthogonalDecomposition().solve(right);
    Eigen::MatrixXd result = G;
    for (Eigen::Index i = 0; i < m; ++i) {
        result -= theta[i] * dG_[i];
    }
    return result;
}

} // namespace tapeline
