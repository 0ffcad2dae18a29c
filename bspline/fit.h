// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"

#include <vector>

namespace tapeline {

struct FitOptions {
    int control_points = 0; ///< exact number wanted; 0 = as few as the tolerance needs
    double tolerance_mm =
        0;          ///< largest distance of a point to the curve; 0 = max(0.2 sagitta, 1e-4 length) (method.md H2)
    int degree = 3; ///< from 1 to 9
    int max_control_points = 0; ///< with a tolerance: give up rather than use more; 0 = no such limit
};
struct FitReport {
    double max_error_mm = 0;   ///< largest distance of a polyline point to the curve; this is what the tolerance bounds
    double chord_error_mm = 0; ///< the same of points on the polyline's edges, which cut bends by their chord height
    int control_points = 0;    ///< of the result (closed: the repeated last one included)
    double tolerance_mm = 0;   ///< the tolerance used; 0 when only `control_points` was asked for
};

/// Least-squares B-spline through a polyline (the feature line L0), ends interpolated (closed: periodic, so C² at the
/// seam for a cubic; stored clamped, the first point repeated as the last). The order of the points gives the sense of
/// the curve, and of a closed one the first point its seam. Parameter range [0, 1], roughly by chord length.
/// Each point counts by the length of polyline that it stands for, so crowded points do not pull; a light weight on
/// |C'''|² decides where points are few. Knots are even at first, then put where the error is. With both
/// `control_points` and `tolerance_mm` given, an error above the tolerance is a failure.
/// Rejected: points that are not finite, fewer than two different ones (closed: three), a tolerance out of reach.
Result<TargetLine> fit_polyline(const std::vector<Vec3>& points, bool closed, const FitOptions& options = {},
                                FitReport* report = nullptr);

/// Cubic B-spline through all points in order (fewer than four points: of lower degree), within 1e-9 of its length of
/// each; closed: periodic, the first point not repeated in `points`. Equal neighbours count once. Parameters by chord
/// length, centripetal where neighbouring chords differ by more than a factor of five.
Result<TargetLine> interpolate_points(const std::vector<Vec3>& points, bool closed);

} // namespace tapeline
