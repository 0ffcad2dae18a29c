// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/knots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::spline {

int find_span(const std::vector<double>& knots, int degree, double u)
{
    const int last = static_cast<int>(knots.size()) - degree - 2;
    const auto begin = knots.begin() + degree, end = knots.begin() + last + 1;
    int k = static_cast<int>(std::upper_bound(begin, end, u) - knots.begin()) - 1;
    k = std::clamp(k, degree, last);
    while (k > degree && knots[k] == knots[k + 1]) {
        --k;
    }
    return k;
}

Eigen::MatrixXd basis_derivatives(const std::vector<double>& knots, int degree, int k, double u, int order)
{
    const int p = degree;
    Eigen::MatrixXd table(p + 1, p + 1); // lower triangle: knot differences, upper: basis functions
    std::vector<double> left(p + 1), right(p + 1);
    table(0, 0) = 1;
    for (int j = 1; j <= p; ++j) {
        left[j] = u - knots[k + 1 - j];
        right[j] = knots[k + j] - u;
        double saved = 0;
        for (int r = 0; r < j; ++r) {
            table(j, r) = right[r + 1] + left[j - r];
            const double quotient = table(r, j - 1) / table(j, r);
            table(r, j) = saved + right[r + 1] * quotient;
            saved = left[j - r] * quotient;
        }
        table(j, j) = saved;
    }
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(order + 1, p + 1);
    result.row(0) = table.col(p).transpose();
    for (int r = 0; r <= p; ++r) {
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2, p + 1);
        int now = 0, next = 1;
        a(0, 0) = 1;
        for (int d = 1; d <= std::min(order, p); ++d) {
            double sum = 0;
            const int rk = r - d, pk = p - d;
            if (r >= d) {
                a(next, 0) = a(now, 0) / table(pk + 1, rk);
                sum = a(next, 0) * table(rk, pk);
            }
            const int j1 = rk >= -1 ? 1 : -rk;
            const int j2 = r - 1 <= pk ? d - 1 : p - r;
            for (int j = j1; j <= j2; ++j) {
                a(next, j) = (a(now, j) - a(now, j - 1)) / table(pk + 1, rk + j);
                sum += a(next, j) * table(rk + j, pk);
            }
            if (r <= pk) {
                a(next, d) = -a(now, d - 1) / table(pk + 1, r);
                sum += a(next, d) * table(r, pk);
            }
            result(d, r) = sum;
            std::swap(now, next);
        }
    }
    double factor = p;
    for (int d = 1; d <= std::min(order, p); ++d) {
        result.row(d) *= factor;
        factor *= p - d;
    }
    return result;
}

Eigen::Vector4d blossom(const std::vector<double>& knots, std::span<const Eigen::Vector4d> poles, int degree, int k,
                        std::span<const double> arguments)
{
    std::vector<Eigen::Vector4d> d(poles.begin() + (k - degree), poles.begin() + k + 1);
    for (int r = 1; r <= degree; ++r) {
        const double a = arguments[r - 1];
        for (int i = k; i >= k - degree + r; --i) {
            const double low = knots[i], high = knots[i + degree + 1 - r];
            const int j = i - (k - degree);
            // Exact at both ends, so that poles which a refinement keeps stay bit-identical.
            const double s = (a - low) / (high - low);
            d[j] = s == 0 ? d[j - 1] : s == 1 ? d[j] : Eigen::Vector4d((1 - s) * d[j - 1] + s * d[j]);
        }
    }
    return d[degree];
}

std::vector<Eigen::Vector4d> homogeneous(const BSplineData& data)
{
    std::vector<Eigen::Vector4d> poles(data.control_points.size());
    for (size_t i = 0; i < poles.size(); ++i) {
        const double w = data.weights.empty() ? 1 : data.weights[i];
        poles[i] << w * data.control_points[i], w;
    }
    return poles;
}

namespace {

/// Clamps the start of a curve given by flat knots and homogeneous poles.
void clamp_start(std::vector<double>& knots, std::vector<Eigen::Vector4d>& poles, int degree)
{
    const double start = knots[degree];
    if (knots.front() == start) {
        return;
    }
    const int k = find_span(knots, degree, start);
    std::vector<Eigen::Vector4d> head;
    for (int j = 0; j < degree; ++j) {
        std::vector<double> arguments(degree, start);
        std::copy_n(knots.begin() + k + 1, j, arguments.begin());
        head.push_back(blossom(knots, poles, degree, k, arguments));
    }
    head.insert(head.end(), poles.begin() + k, poles.end());
    std::vector<double> tail(knots.begin() + k + 1, knots.end());
    knots.assign(degree + 1, start);
    knots.insert(knots.end(), tail.begin(), tail.end());
    poles = std::move(head);
}

void reverse(std::vector<double>& knots, std::vector<Eigen::Vector4d>& poles)
{
    std::ranges::reverse(knots);
    std::ranges::transform(knots, knots.begin(), [](double u) { return -u; });
    std::ranges::reverse(poles);
}

} // namespace

BSplineData clamp(const BSplineData& data)
{
    const size_t n = data.control_points.size();
    if (data.knots.front() == data.knots[data.degree] && data.knots.back() == data.knots[n]) {
        return data;
    }
    BSplineData result = data;
    std::vector<Eigen::Vector4d> poles = homogeneous(data);
    clamp_start(result.knots, poles, data.degree);
    reverse(result.knots, poles);
    clamp_start(result.knots, poles, data.degree);
    reverse(result.knots, poles);
    result.control_points.clear();
    result.weights.clear();
    for (const Eigen::Vector4d& pole : poles) {
        result.control_points.push_back(data.weights.empty() ? Vec3(pole.head<3>()) : Vec3(pole.head<3>() / pole[3]));
        if (!data.weights.empty()) {
            result.weights.push_back(pole[3]);
        }
    }
    return result;
}

GaussRule gauss_rule(int n)
{
    GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
    for (int i = 0; i < n; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 60; ++step) {
            double previous = 1, value = x;
            for (int j = 2; j <= n; ++j) {
                const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
                previous = value;
                value = next;
            }
            slope = n * (x * value - previous) / (x * x - 1);
            const double change = value / slope;
            x -= change;
            if (std::abs(change) < 1e-16) {
                break;
            }
        }
        rule.nodes[n - 1 - i] = 0.5 * (1 + x);
        rule.weights[n - 1 - i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

std::vector<double> knots_over(const std::vector<double>& breaks, int degree, bool periodic)
{
    std::vector<double> knots;
    const int spans = static_cast<int>(breaks.size()) - 1;
    const double range = breaks.back() - breaks.front();
    for (int i = -degree; i <= spans + degree; ++i) {
        if (!periodic) {
            knots.push_back(breaks[std::clamp(i, 0, spans)]);
            continue;
        }
        const int turns = i >= 0 ? i / spans : -((-i + spans - 1) / spans);
        const int inside = i - turns * spans;
        knots.push_back(breaks[inside] + turns * range);
    }
    return knots;
}

} // namespace tapeline::spline
