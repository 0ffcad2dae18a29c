// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/target_line_impl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapeline {

namespace {

using Impl = TargetLine::Impl;

/// Newton steps on (C - p) · C' from a root that is already good to about 1e-13 of its piece: takes off the rounding of
/// the Bernstein form. Never leaves the piece, never makes it worse.
double polish(const spline::BezierSpan& span, const Vec3& p, double t)
{
    const auto evaluate = [&](double u, double& slope, double& curvature) {
        const spline::CurveValue c = span.value(u);
        slope = (c.point - p).dot(c.first);
        curvature = c.first.squaredNorm() + (c.point - p).dot(c.second);
    };
    double slope = 0, curvature = 0;
    evaluate(t, slope, curvature);
    for (int step = 0; step < 4 && curvature != 0; ++step) {
        const double next = std::clamp(t - slope / curvature, span.first, span.last);
        double next_slope = 0, next_curvature = 0;
        evaluate(next, next_slope, next_curvature);
        if (!(std::abs(next_slope) < std::abs(slope))) {
            break;
        }
        t = next;
        slope = next_slope;
        curvature = next_curvature;
    }
    return t;
}

/// Parameters of the feet inside one piece.
std::vector<double> inner_feet(const spline::BezierSpan& span, const Vec3& p)
{
    std::vector<double> feet = spline::bernstein_roots(spline::foot_polynomial(span, p));
    for (double& t : feet) {
        t = polish(span, p, span.first + t * (span.last - span.first));
    }
    return feet;
}

/// (p - C) · T at a piece's first or last point, with the tangent on that side of it [mm].
double advance(const spline::BezierSpan& span, const Vec3& p, bool at_last)
{
    const auto& c = span.points;
    const Vec3 direction = at_last ? Vec3(c.back() - c[c.size() - 2]) : Vec3(c[1] - c[0]);
    return (p - (at_last ? c.back() : c.front())).dot(direction.normalized());
}

CurveFoot make_foot(const TargetLine& line, const Vec3& p, double t)
{
    const Impl& impl = line.impl();
    CurveFoot foot;
    foot.parameter = t;
    foot.point = impl.point(t);
    foot.tangent = line.tangent(t);
    foot.distance = (p - foot.point).norm();
    if (!line.closed()) {
        const double slope = (p - foot.point).dot(foot.tangent);
        foot.at_end =
            (t == line.first_parameter() && slope < -impl.tiny) || (t == line.last_parameter() && slope > impl.tiny);
    }
    return foot;
}

} // namespace

CurveFoot TargetLine::foot(const Vec3& p) const
{
    double best = std::numeric_limits<double>::infinity(), best_parameter = first_parameter();
    const auto consider = [&](double t, const Vec3& c) {
        const double distance = (c - p).squaredNorm();
        if (distance < best || (distance == best && t < best_parameter)) {
            best = distance;
            best_parameter = t;
        }
    };
    impl_->spans.visit_near(p, best, [&](int i) {
        const spline::BezierSpan& span = impl_->spans.spans()[i];
        consider(span.first, span.points.front());
        consider(span.last, span.points.back());
        for (const double t : inner_feet(span, p)) {
            consider(t, span.value(t).point);
        }
        return best;
    });
    return make_foot(*this, p, best_parameter);
}

std::vector<CurveFoot> TargetLine::all_feet(const Vec3& p) const
{
    const auto& spans = impl_->spans.spans();
    const double zero = impl_->tiny;
    std::vector<double> parameters;
    for (size_t i = 0; i < spans.size(); ++i) {
        // At a joint a foot is where the slope of the distance vanishes or changes sign.
        const bool first = i == 0;
        const double after = advance(spans[i], p, false);
        const double before =
            first ? (closed() ? advance(spans.back(), p, true) : after) : advance(spans[i - 1], p, true);
        if (std::abs(after) <= zero || std::abs(before) <= zero || (after > 0) != (before > 0)) {
            parameters.push_back(spans[i].first);
        }
        for (const double t : inner_feet(spans[i], p)) {
            parameters.push_back(t);
        }
    }
    if (!closed() && std::abs(advance(spans.back(), p, true)) <= zero) {
        parameters.push_back(last_parameter());
    }
    std::ranges::sort(parameters);
    std::vector<CurveFoot> feet;
    const auto same = [&](const CurveFoot& a, const CurveFoot& b) {
        const double apart = std::abs(a.parameter - b.parameter), range = last_parameter() - first_parameter();
        const bool neighbours = apart < 1e-3 * range || (closed() && apart > (1 - 1e-3) * range);
        return neighbours && (a.point - b.point).norm() <= 1e3 * zero;
    };
    for (const double t : parameters) {
        CurveFoot foot = make_foot(*this, p, t);
        foot.at_end = false; // each is a true foot
        const bool known = !feet.empty() && (same(feet.back(), foot) || same(feet.front(), foot));
        if (!known) {
            feet.push_back(foot);
        }
    }
    std::ranges::stable_sort(feet, {}, &CurveFoot::distance);
    return feet;
}

} // namespace tapeline
