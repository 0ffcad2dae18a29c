// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/slide.h"

namespace tapeline::spline {

/// A checked slide law, ready to evaluate.
class SlideCurve {
public:
    /// `closed`: slopes agree at fractions 0 and 1.
    static Result<SlideCurve> make(const SlideLaw& law, bool closed);
    /// Signed distance at a fraction of the arc length [mm].
    double at(double fraction) const;

private:
    std::vector<double> x_, y_, slope_;
};

} // namespace tapeline::spline
