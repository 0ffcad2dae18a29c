// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/fit.h"
#include "bspline/least_squares.h"
#include "bspline/polyline.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

using spline::Polyline;

/// Parameters in [0, 1], one per point and for a closed line one more for the way back.
std::vector<double> point_parameters(const Polyline& line)
{
    double ratio = 1;
    const auto chord = [&](int e) { return line.lengths[e + 1] - line.lengths[e]; };
    for (int e = 0; e + 1 < line.edges(); ++e) {
        ratio = std::max({ratio, chord(e) / chord(e + 1), chord(e + 1) / chord(e)});
    }
    std::vector<double> parameters{0};
    for (int e = 0; e < line.edges(); ++e) {
        parameters.push_back(parameters.back() + (ratio > 5 ? std::sqrt(chord(e)) : chord(e)));
    }
    for (double& t : parameters) {
        t /= parameters.back() == 0 ? 1 : parameters.back();
    }
    return parameters;
}

/// Poles of the curve that has the given points at the given parameters.
std::vector<Vec3> solve_poles(const std::vector<double>& knots, int degree, const Polyline& line,
                              const std::vector<double>& parameters)
{
    const int n = static_cast<int>(line.points.size());
    std::vector<Eigen::Triplet<double>> triplets;
    Eigen::MatrixX3d right(n, 3);
    for (int i = 0; i < n; ++i) {
        const int k = spline::find_span(knots, degree, parameters[i]);
        const auto basis = spline::basis_derivatives(knots, degree, k, parameters[i], 0);
        for (int a = 0; a <= degree; ++a) {
            triplets.emplace_back(i, (k - degree + a) % n, basis(0, a));
        }
        right.row(i) = (line.points[i] - line.points[0]).transpose();
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::MatrixX3d solution = solver.solve(right);
    std::vector<Vec3> poles(n);
    for (int i = 0; i < n; ++i) {
        poles[i] = solution.row(i).transpose() + line.points[0];
    }
    return poles;
}

BSplineData interpolate_open(const Polyline& line, const std::vector<double>& parameters)
{
    BSplineData data;
    const int n = static_cast<int>(line.points.size());
    data.degree = std::min(3, n - 1);
    data.knots.assign(data.degree + 1, 0.0);
    for (int j = 1; j < n - data.degree; ++j) {
        double sum = 0; // knots by averaging (NURBS Book 9.8) keep the system well conditioned
        for (int i = j; i < j + data.degree; ++i) {
            sum += parameters[i];
        }
        data.knots.push_back(sum / data.degree);
    }
    data.knots.insert(data.knots.end(), data.degree + 1, 1.0);
    data.control_points = solve_poles(data.knots, data.degree, line, parameters);
    data.control_points.front() = line.points.front();
    data.control_points.back() = line.points.back();
    return data;
}

BSplineData interpolate_closed(const Polyline& line, const std::vector<double>& parameters)
{
    const spline::SplineSpace space{3, parameters, true};
    const std::vector<double> knots = spline::knots_over(parameters, 3, true);
    return spline::curve_of(space, solve_poles(knots, 3, line, parameters));
}

} // namespace

Result<TargetLine> interpolate_points(const std::vector<Vec3>& points, bool closed)
try {
    const auto line = spline::make_polyline(points, closed);
    if (!line) {
        return tl::unexpected(line.error());
    }
    const std::vector<double> parameters = point_parameters(*line);
    auto curve =
        TargetLine::from_data(closed ? interpolate_closed(*line, parameters) : interpolate_open(*line, parameters));
    if (!curve) {
        return curve;
    }
    for (size_t i = 0; i < line->points.size(); ++i) {
        const double error = (curve->point(parameters[i]) - line->points[i]).norm();
        if (!(error <= 1e-9 * line->length())) {
            return fail(ErrorKind::rejected,
                        fmt::format("no smooth curve passes through the points: it misses ({:.6g}, {:.6g}, {:.6g}) by "
                                    "{:.3g} mm; even out the points' spacing",
                                    line->points[i].x(), line->points[i].y(), line->points[i].z(), error));
        }
    }
    return curve;
} catch (const std::exception& exception) {
    return fail(ErrorKind::rejected, fmt::format("no curve through the points: {}", exception.what()));
}

} // namespace tapeline
