// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/arc_length.h"
#include "bspline/bezier_spans.h"
#include "bspline/target_line.h"

namespace tapeline {

/// What a TargetLine holds; everything is fixed at construction.
struct TargetLine::Impl {
    BSplineData data;          ///< clamped
    spline::BezierSpans spans; ///< the same curve span by span, for bounds and root isolation
    spline::ArcLengthTable lengths;
    double tiny = 0; ///< 1e-12 of the curve's extent: what counts as zero distance [mm]

    spline::CurveValue value(double t) const { return spans.span_at(t).value(t); }
    Vec3 point(double t) const { return value(t).point; }
    Vec3 derivative(double t) const { return value(t).first; }
};

} // namespace tapeline
