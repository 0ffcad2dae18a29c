// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/strip_fit.h"

#include "kernel/median.h"
#include "kernel/parallel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tapeline {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Of the way that a bend takes to nine tenths of its angle, the first tenth of the angle may take this share; an even
/// bend takes a ninth.
constexpr double early = 0.1, late = 0.9, latest_start = 0.3;
/// Largest part of the straight fit's squares that the fit with a bend may leave.
constexpr double unexplained = 0.2;

BendFit fit_bend(const std::vector<double>& d, const std::vector<double>& tau, double w, double window)
{
    size_t n = 0;
    while (n < d.size() && d[n] <= window * w) {
        ++n;
    }
    Eigen::MatrixXd A(static_cast<Eigen::Index>(n), 3);
    Eigen::VectorXd b(static_cast<Eigen::Index>(n));
    for (size_t k = 0; k < n; ++k) {
        const double weight = std::sqrt(d[std::min(k + 1, n - 1)] - d[k > 0 ? k - 1 : 0]);
        A.row(static_cast<Eigen::Index>(k)) << weight, weight * d[k], weight * std::max(0.0, d[k] - w);
        b[static_cast<Eigen::Index>(k)] = weight * tau[k];
    }
    const Eigen::VectorXd straight = A.leftCols(2).colPivHouseholderQr().solve(b),
                          bent = A.colPivHouseholderQr().solve(b);
    const double one = (A.leftCols(2) * straight - b).squaredNorm(), two = (A * bent - b).squaredNorm();
    return {one > 0 ? two / one : 1, w, bent[1], bent[1] + bent[2]};
}

/// The best fit with a width in that range, by thirds.
BendFit refined(const std::vector<double>& d, const std::vector<double>& tau, BendFit best,
                std::pair<double, double> range, double window)
{
    for (int step = 0; step < 30 && range.second > range.first; ++step) {
        const double third = (range.second - range.first) / 3;
        const BendFit a = fit_bend(d, tau, range.first + third, window);
        const BendFit b = fit_bend(d, tau, range.second - third, window);
        (a.left <= b.left ? range.second : range.first) = a.left <= b.left ? b.width : a.width;
        for (const BendFit& fit : {a, b}) {
            best = fit.left < best.left ? fit : best;
        }
    }
    return best;
}

/// Where the profile first reaches this share of the bend's angle [mm].
double reached(const std::vector<double>& d, const std::vector<double>& tau, const BendFit& fit, double share)
{
    const double wanted = share * fit.inner * fit.width;
    const auto there = std::ranges::find_if(tau, [&](double angle) { return angle / wanted >= 1; });
    return there == tau.end() ? std::numeric_limits<double>::infinity() : d[there - tau.begin()];
}

bool turns_from_the_line_on(const std::vector<double>& d, const std::vector<double>& tau, const BendFit& fit)
{
    const double start = reached(d, tau, fit, early), end = reached(d, tau, fit, late);
    return std::isfinite(end) && start <= latest_start * end;
}

/// Straight from the neighbours where nothing is known; the entries are not all unknown.
void fill(std::vector<double>& values, bool closed)
{
    const auto n = static_cast<int>(values.size());
    const std::vector<double> known = values;
    for (int i = 0; i < n; ++i) {
        for (int step = 1; std::isnan(values[i]); ++step) {
            for (const int j : {i - step, i + step}) {
                if (std::isnan(values[i]) && (closed || (j >= 0 && j < n))) {
                    values[i] = known[((j % n) + n) % n];
                }
            }
        }
    }
}

/// Entry i and its neighbours within `reach`, fewer at the ends of an open row.
template <class T>
std::vector<T> neighbourhood(const std::vector<T>& row, int i, int reach, bool closed)
{
    const auto n = static_cast<int>(row.size());
    std::vector<T> result;
    for (int j = i - reach; j <= i + reach; ++j) {
        if (closed || (j >= 0 && j < n)) {
            result.push_back(row[((j % n) + n) % n]);
        }
    }
    return result;
}

/// Lone outliers dropped, then evened out.
std::vector<double> smoothed(std::vector<double> values, bool closed)
{
    constexpr int passes = 3;
    const std::vector<double> raw = values;
    for (int i = 0; i < static_cast<int>(values.size()); ++i) {
        values[i] = median(neighbourhood(raw, i, 1, closed));
    }
    for (int pass = 0; pass < passes; ++pass) {
        const std::vector<double> before = values;
        for (int i = 0; i < static_cast<int>(values.size()); ++i) {
            const std::vector<double> around = neighbourhood(before, i, 1, closed);
            if (around.size() == 3) {
                values[i] = 0.25 * (around[0] + 2 * around[1] + around[2]);
            }
        }
    }
    return values;
}

} // namespace

std::vector<double> median_profile(const std::vector<std::vector<double>>& profiles)
{
    std::vector<double> tau;
    for (size_t k = 0; k < profiles.front().size(); ++k) {
        std::vector<double> values;
        for (const auto& profile : profiles) {
            values.push_back(profile[k]);
        }
        tau.push_back(median(std::move(values)));
    }
    return tau;
}

BendFit best_bend(const std::vector<double>& distances, const std::vector<double>& tau, std::pair<double, double> range,
                  const StripOptions& options)
{
    BendFit best;
    std::pair<double, double> between;
    const double reach = distances.back();
    for (size_t k = 4; k + 1 < distances.size() && options.narrowness * distances[k] <= reach; ++k) {
        if (distances[k] < range.first || distances[k] > range.second) {
            continue;
        }
        const BendFit fit = fit_bend(distances, tau, distances[k], options.narrowness);
        const bool bends = std::abs(fit.inner) * fit.width >= options.least_turning * degree &&
                           std::abs(fit.inner) >= options.contrast * std::abs(fit.outer);
        if (bends && fit.left < best.left && turns_from_the_line_on(distances, tau, fit)) {
            best = fit;
            between = {distances[k - 1], distances[k + 1]};
        }
    }
    best = refined(distances, tau, best, between, options.narrowness);
    return best.left > unexplained ? BendFit{} : best;
}

std::vector<double> widths_along(const std::vector<double>& distances, const std::vector<std::vector<double>>& profiles,
                                 bool closed, const BendFit& whole, const StripOptions& options)
{
    constexpr int window = 1;         // stations on either side whose median profile is fitted
    constexpr double farthest = 4;    // times wider or narrower than the whole line's
    constexpr double same_turn = 0.5; // of the whole bend's angle is the least of a bend that goes on
    constexpr double noise = 1.25;    // between the widest and the narrowest place of an even bend
    const auto n = static_cast<int>(profiles.size());
    std::vector<double> widths(n, std::numeric_limits<double>::quiet_NaN());
    parallel_for(
        n,
        [&](int i) {
            const std::vector<double> tau = median_profile(neighbourhood(profiles, i, window, closed));
            const BendFit fit = best_bend(distances, tau, {whole.width / farthest, whole.width * farthest}, options);
            if (fit.found() && fit.inner * fit.width / (whole.inner * whole.width) >= same_turn) {
                widths[i] = fit.width;
            }
        },
        1);
    if (2 * std::ranges::count_if(widths, [](double w) { return std::isnan(w); }) > n) {
        return {};
    }
    fill(widths, closed);
    widths = smoothed(std::move(widths), closed);
    const auto [least, most] = std::ranges::minmax(widths);
    return most > noise * least ? widths : std::vector<double>{};
}

} // namespace tapeline
