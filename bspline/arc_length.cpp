// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/arc_length.h"

#include <algorithm>
#include <cmath>

namespace tapeline::spline {

using Speed = std::function<double(double)>;

double ArcLengthTable::integrate(double a, double b, const Speed& speed) const
{
    double sum = 0;
    for (size_t i = 0; i < rule_.nodes.size(); ++i) {
        sum += rule_.weights[i] * speed(a + (b - a) * rule_.nodes[i]);
    }
    return sum * (b - a);
}

void ArcLengthTable::divide(double a, double b, double whole, double tolerance, int depth, const Speed& speed)
{
    const double middle = 0.5 * (a + b);
    const double left = integrate(a, middle, speed), right = integrate(middle, b, speed);
    // The cap on pieces is a guard against a speed that is noise.
    if (depth == 0 || parameters_.size() > max_pieces_ || !(std::abs(left + right - whole) > tolerance)) {
        parameters_.push_back(b);
        lengths_.push_back(lengths_.back() + left + right);
        return;
    }
    divide(a, middle, left, tolerance, depth - 1, speed);
    divide(middle, b, right, tolerance, depth - 1, speed);
}

ArcLengthTable::ArcLengthTable(const std::vector<double>& breaks, const Speed& speed) : rule_(gauss_rule(16))
{
    std::vector<double> first(breaks.size() - 1);
    double rough = 0;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        first[i] = integrate(breaks[i], breaks[i + 1], speed);
        rough += first[i];
    }
    parameters_.push_back(breaks.front());
    lengths_.push_back(0);
    max_pieces_ = 64 * breaks.size() + 4096;
    constexpr int max_depth = 30; // a cusp needs about one halving per digit
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        divide(breaks[i], breaks[i + 1], first[i], 1e-13 * rough, max_depth, speed);
    }
}

double ArcLengthTable::length_at(double t, const Speed& speed) const
{
    if (!(t > parameters_.front())) {
        return 0;
    }
    if (t >= parameters_.back()) {
        return lengths_.back();
    }
    const size_t piece = std::upper_bound(parameters_.begin(), parameters_.end(), t) - parameters_.begin() - 1;
    const double a = parameters_[piece], b = parameters_[piece + 1];
    // From the nearer end of the piece, so that both ends are met exactly.
    const double length =
        t - a <= b - t ? lengths_[piece] + integrate(a, t, speed) : lengths_[piece + 1] - integrate(t, b, speed);
    return std::clamp(length, lengths_[piece], lengths_[piece + 1]);
}

double ArcLengthTable::parameter_at(double length, const Speed& speed) const
{
    if (!(length > 0)) {
        return parameters_.front();
    }
    if (length >= lengths_.back()) {
        return parameters_.back();
    }
    const size_t piece = std::upper_bound(lengths_.begin(), lengths_.end(), length) - lengths_.begin() - 1;
    double low = parameters_[piece], high = parameters_[piece + 1];
    const double share = (length - lengths_[piece]) / (lengths_[piece + 1] - lengths_[piece]);
    double t = low + share * (high - low);
    for (int step = 0; step < 80; ++step) {
        const double error = length_at(t, speed) - length;
        if (error == 0) {
            break;
        }
        (error > 0 ? high : low) = t;
        double next = t - error / speed(t);
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        const bool settled = std::abs(next - t) <= 1e-15 * (std::abs(low) + std::abs(high));
        t = next;
        if (settled) {
            break;
        }
    }
    return t;
}

} // namespace tapeline::spline
