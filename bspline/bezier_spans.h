// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/knots.h"

#include <Eigen/Geometry>
#include <functional>
#include <vector>

namespace tapeline::spline {

/// Position and first two derivatives by the curve parameter.
struct CurveValue {
    Vec3 point, first, second;
};

/// One Bézier piece of a curve.
struct BezierSpan {
    double first = 0, last = 0;  ///< parameter range
    std::vector<Vec3> points;    ///< degree + 1 control points [mm]
    std::vector<double> weights; ///< empty when all are equal
    Eigen::AlignedBox3d box;     ///< of the control points, so it holds the piece

    /// By de Casteljau's scheme on differences to the first control point: exact at both ends, stable at every
    /// degree and far from the origin.
    CurveValue value(double t) const;
};

/// A curve cut into its Bézier pieces, with a tree of boxes over them. Feet are the zeros of a polynomial in
/// Bernstein form on each piece, which isolates all of them with certainty (variation diminishing property).
class BezierSpans {
public:
    BezierSpans() = default;
    /// `data` must be clamped.
    explicit BezierSpans(const BSplineData& data);

    const std::vector<BezierSpan>& spans() const { return spans_; }
    /// The piece that holds t; of two that meet there, the later one. Outside the range: the nearest.
    const BezierSpan& span_at(double t) const;

    /// Calls `visit(span index)` for the pieces that may hold a point nearer to p than sqrt(bound), the more promising
    /// first; `visit` returns the bound [mm²] for what follows.
    void visit_near(const Vec3& p, double bound, const std::function<double(int)>& visit) const;

private:
    struct Node {
        Eigen::AlignedBox3d box;
        int left = -1, right = -1; ///< child nodes; leaf: left = -1, right = span index
    };
    int build(int begin, int end);
    void descend(int node, const Vec3& p, double& bound, const std::function<double(int)>& visit) const;

    std::vector<BezierSpan> spans_;
    std::vector<Node> nodes_;
    int root_ = -1;
};

/// Slope of the squared distance |C - p|² / 2 on one piece, up to a positive factor.
struct FootPolynomial {
    std::vector<double> coefficients; ///< Bernstein, over the piece's range
    double scale = 0;                 ///< size that a coefficient can have: below 1e-14 of it is rounding
};
FootPolynomial foot_polynomial(const BezierSpan& span, const Vec3& p);

/// Zeros of a Bernstein polynomial inside (0, 1), ascending. Where it is zero to rounding on a stretch, the middle of
/// the stretch is given.
std::vector<double> bernstein_roots(const FootPolynomial& polynomial);

} // namespace tapeline::spline
