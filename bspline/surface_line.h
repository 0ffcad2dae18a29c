// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"
#include "kernel/closest_point.h"
#include "kernel/exact_ground.h"

#include <functional>
#include <vector>

namespace tapeline::spline {

/// Surface points of the line wanted, for a list of fractions of the source line's arc length.
using PlacePoints = std::function<Result<std::vector<Vec3>>(const std::vector<double>& fractions)>;

/// A surface that lines are laid on: triangles, or the exact faces that they stand for.
class LineGround {
public:
    LineGround(const ClosestPoint& triangles, const ExactGround* exact)
        : triangles_(triangles), exact_(exact && exact->available() ? exact : nullptr)
    {
    }

    Vec3 closest(const Vec3& p) const
    {
        const auto foot = exact_ ? exact_->closest(p) : std::nullopt;
        return foot ? *foot : triangles_.closest(p).point;
    }
    /// The place for a point of a triangle: itself where there is nothing more exact, to the bit.
    Vec3 place(const Vec3& on_triangle) const { return exact_ ? closest(on_triangle) : on_triangle; }

private:
    const ClosestPoint& triangles_;
    const ExactGround* exact_;
};

/// Checks a tolerance [mm] given by a caller: finite, not negative.
Result<void> check_tolerance(double tolerance_mm);

/// What is wanted of a line on a surface; 0 as documented at `slide_on_surface`.
struct SurfaceFit {
    double tolerance_mm = 0;
    int control_points = 0;
};

/// Fits a line through surface points so that it lies within the tolerance of them and of the surface, with more
/// points and a tighter fit where the first attempt strays between them. `samples` is the first number of points.
/// `off_mm`: where a number of control points is asked for, how far the line strays; else unchanged.
Result<TargetLine> fit_on_surface(const PlacePoints& place, bool closed, int samples, const LineGround& surface,
                                  const SurfaceFit& wanted, double* off_mm);

/// A good number of samples for a line on a mesh: some per span of the line, and about two per triangle crossed.
int sample_count(const TargetLine& line, const Mesh& mesh);

} // namespace tapeline::spline
