// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/knots.h"

#include <functional>
#include <vector>

namespace tapeline::spline {

/// Arc length of a curve from its speed |C'(t)|, by Gauss–Legendre on pieces that are halved until the rule agrees with
/// itself on the halves to 1e-13 of the whole length. Built once, read-only afterwards.
class ArcLengthTable {
public:
    ArcLengthTable() = default;
    /// `breaks`: ascending parameters between which the speed is smooth.
    ArcLengthTable(const std::vector<double>& breaks, const std::function<double(double)>& speed);

    double total() const { return lengths_.empty() ? 0 : lengths_.back(); }
    /// Length from the first break to t (clamped to the range).
    double length_at(double t, const std::function<double(double)>& speed) const;
    /// Inverse of `length_at`, clamped.
    double parameter_at(double length, const std::function<double(double)>& speed) const;

private:
    double integrate(double a, double b, const std::function<double(double)>& speed) const;
    void divide(double a, double b, double whole, double tolerance, int depth,
                const std::function<double(double)>& speed);

    GaussRule rule_;
    size_t max_pieces_ = 0;
    std::vector<double> parameters_; ///< piece ends, ascending
    std::vector<double> lengths_;    ///< arc length at each
};

} // namespace tapeline::spline
