// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/least_squares.h"

#include "bspline/bezier_spans.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tapeline::spline {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds factor · Bᵀ B of one row of basis functions to the normal equations.
void add_row(Triplets& triplets, const Eigen::RowVectorXd& row, int first, int poles, double factor)
{
    for (int a = 0; a < row.size(); ++a) {
        for (int b = 0; b < row.size(); ++b) {
            triplets.emplace_back((first + a) % poles, (first + b) % poles, factor * row[a] * row[b]);
        }
    }
}

void add_smoothness(Triplets& triplets, const SplineSpace& space, const std::vector<double>& knots)
{
    const int order = std::min(space.degree, 3);
    // Derivatives of basis functions grow with the number of spans; the weight must not.
    const double range = space.breaks.back() - space.breaks.front();
    const double rho = 1e-9 / range * std::pow(range / space.spans(), 2 * order);
    const GaussRule rule = gauss_rule(std::max(1, space.degree - order + 1));
    for (int i = 0; i < space.spans(); ++i) {
        const double a = space.breaks[i], b = space.breaks[i + 1];
        for (size_t g = 0; g < rule.nodes.size(); ++g) {
            const double u = a + (b - a) * rule.nodes[g];
            const int k = i + space.degree;
            const auto basis = basis_derivatives(knots, space.degree, k, u, order);
            add_row(triplets, basis.row(order), k - space.degree, space.poles(), rho * rule.weights[g] * (b - a));
        }
    }
}

} // namespace

BSplineData curve_of(const SplineSpace& space, const std::vector<Vec3>& poles)
{
    BSplineData data;
    data.degree = space.degree;
    data.knots = knots_over(space.breaks, space.degree, space.periodic);
    data.control_points = poles;
    if (space.periodic) {
        for (int i = 0; i < space.degree; ++i) {
            data.control_points.push_back(poles[i % poles.size()]);
        }
        data = clamp(data);
        data.control_points.back() = data.control_points.front();
        data.closed = true;
    }
    return data;
}

BSplineData least_squares(const SplineSpace& space, const FitPoints& data)
{
    const int n = space.poles();
    const std::vector<double> knots = knots_over(space.breaks, space.degree, space.periodic);
    const double total = std::accumulate(data.weights.begin(), data.weights.end(), 0.0);
    const Vec3 origin = data.points.front(); // so that the rounding error does not grow with the distance from 0
    Triplets triplets;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3);
    for (size_t i = 0; i < data.points.size(); ++i) {
        const int k = find_span(knots, space.degree, data.parameters[i]);
        const Eigen::RowVectorXd row = basis_derivatives(knots, space.degree, k, data.parameters[i], 0).row(0);
        const double w = data.weights[i] / total;
        add_row(triplets, row, k - space.degree, n, w);
        for (int a = 0; a < row.size(); ++a) {
            right.row((k - space.degree + a) % n) += w * row[a] * (data.points[i] - origin).transpose();
        }
    }
    add_smoothness(triplets, space, knots);
    Eigen::SparseMatrix<double> normal(n, n);
    normal.setFromTriplets(triplets.begin(), triplets.end());

    std::vector<Vec3> poles(n, Vec3::Zero());
    const int fixed = space.periodic ? 0 : 1, free = n - 2 * fixed;
    if (!space.periodic) {
        poles.back() = data.points.back() - origin;
        right -= normal.col(n - 1) * poles.back().transpose();
    }
    if (free > 0) {
        const Eigen::SparseMatrix<double> inner = normal.block(fixed, fixed, free, free);
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(inner);
        const Eigen::MatrixX3d solution = solver.solve(right.middleRows(fixed, free));
        if (solver.info() != Eigen::Success || !solution.allFinite()) {
            throw std::runtime_error("the normal equations of the fit are singular");
        }
        for (int i = 0; i < free; ++i) {
            poles[fixed + i] = solution.row(i).transpose();
        }
    }
    for (Vec3& pole : poles) {
        pole += origin;
    }
    if (!space.periodic) {
        poles.front() = data.points.front();
        poles.back() = data.points.back();
    }
    return curve_of(space, poles);
}

void improve_parameters(const BSplineData& curve, FitPoints& data)
{
    const BezierSpans spans(curve);
    const std::vector<double> old = data.parameters;
    for (size_t i = 1; i + 1 < old.size(); ++i) {
        const double t = old[i];
        const CurveValue c = spans.span_at(t).value(t);
        const Vec3 m = data.points[i] - c.point;
        const double slope = m.dot(c.first);
        const double curvature = c.first.squaredNorm() - m.dot(c.second);
        // Where the point is beyond the centre of curvature, Newton's step has the wrong sign.
        const double step = curvature > 0 ? slope / curvature : slope / c.first.squaredNorm();
        if (std::isfinite(step)) {
            data.parameters[i] = t + std::clamp(step, -0.45 * (t - old[i - 1]), 0.45 * (old[i + 1] - t));
        }
    }
}

} // namespace tapeline::spline
