// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/slide_law.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline::spline {

namespace {

/// Fritsch–Butland's weighted harmonic mean of two secant slopes over steps h0, h1; 0 at an extremum.
double inner_slope(double h0, double d0, double h1, double d1)
{
    if (d0 * d1 <= 0) {
        return 0;
    }
    const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Three-point end slope, limited so that the piece stays monotone.
double end_slope(double h0, double d0, double h1, double d1)
{
    const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0) {
        return 0;
    }
    return d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0) ? 3 * d0 : slope;
}

Result<void> check(const SlideLaw& law)
{
    if (law.values.empty()) {
        return fail(ErrorKind::usage, "the slide law is empty: give at least one distance");
    }
    double previous = -1;
    for (const auto& [fraction, distance] : law.values) {
        if (!(fraction >= 0 && fraction <= 1)) {
            return fail(ErrorKind::usage,
                        fmt::format("the slide law names the fraction {} of the line: use 0 to 1", fraction));
        }
        if (!(fraction > previous)) {
            return fail(ErrorKind::usage,
                        fmt::format("the fractions of the slide law must ascend: {} follows {}", fraction, previous));
        }
        if (!std::isfinite(distance)) {
            return fail(ErrorKind::usage,
                        fmt::format("the slide law's distance at fraction {} is not finite", fraction));
        }
        previous = fraction;
    }
    return {};
}

} // namespace

Result<SlideCurve> SlideCurve::make(const SlideLaw& law, bool closed)
{
    if (const auto checked = check(law); !checked) {
        return tl::unexpected(checked.error());
    }
    SlideCurve curve;
    for (const auto& [fraction, distance] : law.values) {
        curve.x_.push_back(fraction);
        curve.y_.push_back(distance);
    }
    auto& x = curve.x_;
    auto& y = curve.y_;
    const bool around = x.size() > 1 && x.front() == 0 && x.back() == 1;
    if (closed && around && y.front() != y.back()) {
        return fail(ErrorKind::usage,
                    fmt::format("the line is closed but its slide law begins with {} mm and ends with "
                                "{} mm: make them equal",
                                y.front(), y.back()));
    }
    if (closed && x.size() > 1 && !around) {
        // The law goes on round the seam: repeat the last pair before 0 and the first after 1.
        const double first_x = x.front(), first_y = y.front();
        x.insert(x.begin(), x.back() - 1);
        y.insert(y.begin(), y.back());
        x.push_back(first_x + 1);
        y.push_back(first_y);
    }
    const int n = static_cast<int>(x.size());
    curve.slope_.assign(n, 0.0);
    const auto step = [&](int i) { return x[i + 1] - x[i]; };
    const auto secant = [&](int i) { return (y[i + 1] - y[i]) / step(i); };
    for (int i = 1; i + 1 < n; ++i) {
        curve.slope_[i] = inner_slope(step(i - 1), secant(i - 1), step(i), secant(i));
    }
    if (n == 2) {
        curve.slope_.assign(2, secant(0));
    } else if (n > 2 && closed) {
        curve.slope_.front() = curve.slope_.back() = inner_slope(step(n - 2), secant(n - 2), step(0), secant(0));
    } else if (n > 2) {
        curve.slope_.front() = end_slope(step(0), secant(0), step(1), secant(1));
        curve.slope_.back() = end_slope(step(n - 2), secant(n - 2), step(n - 3), secant(n - 3));
    }
    return curve;
}

double SlideCurve::at(double fraction) const
{
    if (fraction <= x_.front()) {
        return y_.front();
    }
    if (fraction >= x_.back()) {
        return y_.back();
    }
    const size_t i = std::upper_bound(x_.begin(), x_.end(), fraction) - x_.begin() - 1;
    const double h = x_[i + 1] - x_[i], s = (fraction - x_[i]) / h, r = 1 - s;
    return r * r * (1 + 2 * s) * y_[i] + s * s * (3 - 2 * s) * y_[i + 1] +
           h * s * r * (r * slope_[i] - s * slope_[i + 1]);
}

} // namespace tapeline::spline
