// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"

#include <Eigen/Core>
#include <span>
#include <vector>

/// Algebra on flat knot vectors (each knot as often as its multiplicity), after Piegl & Tiller, The NURBS Book.
/// `knots` has (number of poles + degree + 1) entries; the curve lives on [knots[degree], knots[pole count]].
namespace tapeline::spline {

/// Index k with knots[k] <= u < knots[k + 1] inside the curve's range (the last non-empty span at its end).
int find_span(const std::vector<double>& knots, int degree, double u);

/// Derivatives of the basis functions that do not vanish on span k (NURBS Book A2.3): row d = derivative d in
/// [0, order], column j = basis function k - degree + j.
Eigen::MatrixXd basis_derivatives(const std::vector<double>& knots, int degree, int k, double u, int order);

/// Polar form of the polynomial that the spline is on span k, at `arguments` (degree values). `poles` holds homogeneous
/// points (w x, w y, w z, w).
Eigen::Vector4d blossom(const std::vector<double>& knots, std::span<const Eigen::Vector4d> poles, int degree, int k,
                        std::span<const double> arguments);

/// Homogeneous poles of a curve, and back (weights stay empty when the curve has none).
std::vector<Eigen::Vector4d> homogeneous(const BSplineData& data);

/// The same curve with degree + 1 equal knots at both ends; the parametrisation is kept.
BSplineData clamp(const BSplineData& data);

/// Gauss–Legendre nodes and weights on [0, 1] with `n` points.
struct GaussRule {
    std::vector<double> nodes, weights;
};
GaussRule gauss_rule(int n);

/// Flat knots of a spline space over ascending breaks with simple inner knots: clamped when open; extended by `degree`
/// wrapped knots on each side when periodic (then pole i + breaks.size() - 1 repeats pole i).
std::vector<double> knots_over(const std::vector<double>& breaks, int degree, bool periodic);

} // namespace tapeline::spline
