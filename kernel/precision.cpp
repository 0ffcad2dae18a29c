// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/precision.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tapeline {

namespace {

/// True when the coordinates are float32 values, also after a text file with ten digits or more: those large enough to
/// show it lie within a sixteenth of float32's step of one, which other numbers do once in eight times.
bool are_single(const Positions& V, double largest)
{
    const double tolerance = std::ldexp(largest, -24) / 16;
    int telling = 0;
    for (const double* x = V.data(); x != V.data() + V.size(); ++x) {
        if (std::abs(*x - static_cast<double>(static_cast<float>(*x))) > tolerance) {
            return false;
        }
        telling += std::abs(*x) > 0.5 * largest;
    }
    return telling >= 16;
}

/// True when x is what reading back its `digits` significant digits gives.
bool has_digits(double x, int digits)
{
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, x, std::chars_format::scientific, digits - 1).ptr;
    double back = 0;
    std::from_chars(text, end, back);
    return back == x;
}

} // namespace

double coordinate_precision(const Positions& V)
{
    if (V.rows() == 0) {
        return 0;
    }
    const double largest = V.cwiseAbs().maxCoeff();
    const double exact = std::ldexp(largest, -53);
    // A grid coarser than a fiftieth of an edge is the shape itself, not rounding.
    const double coarsest = 0.02 * bounding_diagonal(V) / std::sqrt(static_cast<double>(V.rows()));
    const double* const values = V.data();
    const auto all = [&](const auto& test) { return std::all_of(values, values + V.size(), test); };
    for (int digits = 4; digits <= 9; ++digits) {
        const double unit = std::pow(10.0, std::floor(std::log10(std::max(largest, 1e-300))) - digits + 1);
        if (0.5 * unit <= coarsest && all([&](double x) { return has_digits(x, digits); })) {
            return 0.5 * unit;
        }
    }
    const double step = std::ldexp(largest, -24);
    return step <= coarsest && are_single(V, largest) ? step : exact;
}

} // namespace tapeline
