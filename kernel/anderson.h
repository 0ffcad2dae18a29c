// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>

namespace tapeline {

/// Anderson acceleration of a fixed-point iteration x ← G(x) (Peng et al. 2018; method.md I3): combines the last
/// differences of G and of F = G - x so that the combined F is smallest.
class Anderson {
public:
    explicit Anderson(int window) : window_(window) {}

    /// The next iterate from the current x and G(x), both n×k. The plain G on the first call or with window 0.
    Eigen::MatrixXd next(const Eigen::MatrixXd& x, const Eigen::MatrixXd& G);
    void restart();

private:
    int window_;
    bool started_ = false;
    Eigen::MatrixXd last_F_, last_G_;
    std::deque<Eigen::MatrixXd> dF_, dG_;
};

} // namespace tapeline
