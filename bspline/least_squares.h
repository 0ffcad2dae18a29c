// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/knots.h"

#include <vector>

namespace tapeline::spline {

/// B-splines of one degree over ascending breaks with simple inner knots.
struct SplineSpace {
    int degree = 3;
    std::vector<double> breaks; ///< first to last parameter
    bool periodic = false;

    int spans() const { return static_cast<int>(breaks.size()) - 1; }
    /// Free poles: a periodic space does not repeat its first ones.
    int poles() const { return periodic ? spans() : spans() + degree; }
};

/// Points to approximate, in the order of their parameters.
struct FitPoints {
    std::vector<Vec3> points;
    std::vector<double> parameters;
    std::vector<double> weights; ///< of the squared distance
};

/// argmin Σ w_k |C(t_k) - Q_k|² + ρ ∫ |C'''|², the first and last point interpolated unless periodic. The result is
/// clamped. ρ is so light that it only shows where there are no points. `degree` < 3 uses the highest derivative.
BSplineData least_squares(const SplineSpace& space, const FitPoints& data);

/// Curve of the space with the given free poles, clamped; a periodic one is marked as closed.
BSplineData curve_of(const SplineSpace& space, const std::vector<Vec3>& poles);

/// One step of Hoschek's intrinsic parametrisation: moves every parameter towards its point's foot on the curve, never
/// past its neighbours. The ends of an open curve, and the seam's point of a closed one, keep theirs.
void improve_parameters(const BSplineData& curve, FitPoints& data);

} // namespace tapeline::spline
