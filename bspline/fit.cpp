// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/fit.h"

#include "bspline/least_squares.h"
#include "bspline/polyline.h"
#include "kernel/parallel.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tapeline {

namespace {

using spline::Polyline;
using spline::SplineSpace;

SplineSpace even_space(int degree, int spans, bool periodic)
{
    SplineSpace space{degree, {}, periodic};
    for (int i = 0; i <= spans; ++i) {
        space.breaks.push_back(static_cast<double>(i) / spans);
    }
    return space;
}

/// A fitted curve, and how far the polyline is from it.
struct Candidate {
    TargetLine line;
    double point_error = 0, chord_error = 0; ///< [mm]
    std::vector<double> excess;              ///< per span the largest error that a tolerance must cover [mm]

    double worst() const { return *std::ranges::max_element(excess); }
};

Result<Candidate> fit_space(const Polyline& polyline, const SplineSpace& space, double tolerance)
{
    spline::FitPoints data = spline::fit_points(polyline, space.spans(), tolerance);
    BSplineData curve = spline::least_squares(space, data);
    for (int round = 0; round < 3; ++round) {
        spline::improve_parameters(curve, data);
        curve = spline::least_squares(space, data);
    }
    auto line = TargetLine::from_data(curve);
    if (!line) {
        return tl::unexpected(line.error());
    }
    Candidate candidate{*line, 0, 0, std::vector<double>(space.spans(), 0.0)};
    const int n = static_cast<int>(polyline.points.size());
    const std::vector<spline::EdgePoint> between = spline::edge_points(polyline);
    std::vector<CurveFoot> feet(n + between.size());
    parallel_for(static_cast<int>(feet.size()),
                 [&](int i) { feet[i] = line->foot(i < n ? polyline.points[i] : between[i - n].point); });
    for (int i = 0; i < static_cast<int>(feet.size()); ++i) {
        double error = feet[i].distance;
        double& largest = i < n ? candidate.point_error : candidate.chord_error;
        largest = std::max(largest, error);
        if (i >= n) {
            // An edge lies off a smooth curve by its own chord height: a quarter of the bend, and as much again for the
            // estimate.
            const int e = between[i - n].edge;
            error -= 0.5 * std::max(polyline.bends[e], polyline.bends[(e + 1) % n]);
        }
        // A foot on a break counts for both spans, or a symmetric line would lose its symmetry there.
        for (const double t : {feet[i].parameter - 1e-9, feet[i].parameter + 1e-9}) {
            const auto after = std::ranges::upper_bound(space.breaks, t);
            const int span = std::clamp(static_cast<int>(after - space.breaks.begin()) - 1, 0, space.spans() - 1);
            candidate.excess[span] = std::max(candidate.excess[span], error);
        }
    }
    return candidate;
}

/// Halves the spans with the largest error. Spans that tie are halved together, so that a symmetric line keeps a
/// symmetric fit; with many spans all that miss the tolerance are.
SplineSpace refine(const SplineSpace& space, const Candidate& candidate, double tolerance)
{
    const double share = space.spans() < 24 ? 0.9 : space.spans() < 60 ? 0.5 : 0;
    const double limit = std::max(tolerance, share * candidate.worst());
    SplineSpace result{space.degree, {}, space.periodic};
    for (int i = 0; i < space.spans(); ++i) {
        result.breaks.push_back(space.breaks[i]);
        if (candidate.excess[i] >= limit) {
            result.breaks.push_back(0.5 * (space.breaks[i] + space.breaks[i + 1]));
        }
    }
    result.breaks.push_back(space.breaks.back());
    return result;
}

Result<Candidate> fit_count(const Polyline& polyline, const FitOptions& options, double tolerance)
{
    const int wanted = options.control_points;
    const int degree = polyline.closed ? options.degree : std::min(options.degree, wanted - 1);
    const int spans = wanted - degree, fewest = polyline.closed ? 3 : 1;
    if (degree < 1 || spans < fewest || wanted > 10000) {
        return fail(ErrorKind::usage,
                    fmt::format("{} control points asked for: a{} line takes from {} to 10000", wanted,
                                polyline.closed ? " closed" : "n open", polyline.closed ? degree + fewest : 2));
    }
    auto candidate = fit_space(polyline, even_space(degree, spans, polyline.closed), tolerance);
    if (candidate && options.tolerance_mm > 0 && candidate->point_error > options.tolerance_mm) {
        return fail(ErrorKind::rejected,
                    fmt::format("{} control points fit the line within {:.6g} mm only, not {:.6g} mm: allow more of "
                                "them or a larger tolerance",
                                wanted, candidate->point_error, options.tolerance_mm));
    }
    return candidate;
}

Result<Candidate> fit_tolerance(const Polyline& polyline, const FitOptions& options, double tolerance)
{
    const int degree = options.degree;
    int most_spans = std::min(5000, 16 + 2 * static_cast<int>(polyline.points.size()));
    if (options.max_control_points > 0) {
        most_spans = std::min(most_spans, options.max_control_points - degree);
    }
    SplineSpace space = even_space(degree, polyline.closed ? 4 : 1, polyline.closed);
    double best = std::numeric_limits<double>::infinity();
    int best_poles = 0;
    while (space.spans() <= most_spans) {
        auto candidate = fit_space(polyline, space, tolerance);
        if (!candidate || candidate->worst() <= tolerance) {
            return candidate;
        }
        if (candidate->worst() < best) {
            best = candidate->worst();
            best_poles = static_cast<int>(candidate->line.data().control_points.size());
        }
        const int few = polyline.closed ? 12 : 7; // up to here even knots make the handles easier to work with
        space = space.spans() < few ? even_space(degree, space.spans() + 1, polyline.closed)
                                    : refine(space, *candidate, tolerance);
    }
    return fail(
        ErrorKind::rejected,
        fmt::format("no smooth curve follows the line within {:.6g} mm (best: {:.6g} mm with {} control points): "
                    "raise the tolerance",
                    tolerance, best, best_poles));
}

} // namespace

Result<TargetLine> fit_polyline(const std::vector<Vec3>& points, bool closed, const FitOptions& options,
                                FitReport* report)
try {
    if (options.degree < 1 || options.degree > 9) {
        return fail(ErrorKind::usage, fmt::format("degree {} asked for: use a degree from 1 to 9", options.degree));
    }
    if (options.control_points < 0 || !(options.tolerance_mm >= 0) || !std::isfinite(options.tolerance_mm)) {
        return fail(ErrorKind::usage, "the number of control points and the tolerance must not be negative");
    }
    const auto polyline = spline::make_polyline(points, closed);
    if (!polyline) {
        return tl::unexpected(polyline.error());
    }
    const double tolerance = options.tolerance_mm > 0 ? options.tolerance_mm
                                                      : std::max(0.2 * polyline->sagitta(), 1e-4 * polyline->length());
    const auto candidate = options.control_points > 0 ? fit_count(*polyline, options, tolerance)
                                                      : fit_tolerance(*polyline, options, tolerance);
    if (!candidate) {
        return tl::unexpected(candidate.error());
    }
    if (report) {
        *report = {candidate->point_error, candidate->chord_error,
                   static_cast<int>(candidate->line.data().control_points.size()),
                   options.control_points > 0 ? options.tolerance_mm : tolerance};
    }
    return candidate->line;
} catch (const std::exception& exception) {
    return fail(ErrorKind::rejected, fmt::format("the line cannot be fitted: {}", exception.what()));
}

} // namespace tapeline
