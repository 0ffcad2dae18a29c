// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"
#include "kernel/exact_ground.h"
#include "kernel/mesh.h"

#include <utility>
#include <vector>

namespace tapeline {

/// Slide law: pairs (fraction of arc length in [0, 1], signed distance [mm]), fractions ascending; monotone-smooth
/// (PCHIP, Fritsch and Carlson 1980) in between, constant before the first and after the last. One pair = constant.
/// On a closed line the law must close too: equal distances at fractions 0 and 1 where both are given.
struct SlideLaw {
    std::vector<std::pair<double, double>> values;
};

/// Slides a line along the model's surface, at each point perpendicular to the line and tangent to the surface,
/// positive to the left of the line seen from outside (surface normal × tangent), measured along the surface (discrete
/// straightest path); the result is refitted. On a crease the path starts in the triangle on the side it goes to.
/// An end of the line that lies on the model's open border slides along the border where that runs within 30° of the
/// slide; a path that meets the border at less than 30° follows it.
///
/// The result lies within `tolerance_mm` of the surface and of the slid points. 0 = 1e-5 of its length, since what Lt
/// is off the surface comes back as a bulge; where the model's facets cannot be followed that closely with 40 control
/// points, up to 1e-4 of its length.
/// `control_points` > 0 asks for exactly so many, evenly spread, which are easier to work with than those that a law
/// with many corners takes; then `off_mm` says how far the result strays, and a tolerance that it misses is a failure.
/// Rejected: a line farther from the model than a tenth of its length, a law that is no function, a path that runs
/// into the border, a slid line that folds over itself (farther than the line's radius of curvature), no fit within the
/// tolerance.
/// `exact` (of a model made of `mesh`): the path goes over the triangles, the points are then laid on the exact surface,
/// from which the tolerance counts.
Result<TargetLine> slide_on_surface(const TargetLine& line, const Mesh& mesh, const SlideLaw& law,
                                    double tolerance_mm = 0, const ExactGround* exact = nullptr, int control_points = 0,
                                    double* off_mm = nullptr);

/// Drops the line onto the model: samples it, takes closest surface points, refits, with the tolerances and number of
/// control points of `slide_on_surface`. Rejected when a point is farther from the model than the line's own length, or
/// when neighbouring points drop to places far apart. `exact`: as there.
Result<TargetLine> lay_on_surface(const TargetLine& line, const Mesh& mesh, double tolerance_mm = 0,
                                  const ExactGround* exact = nullptr, int control_points = 0, double* off_mm = nullptr);

} // namespace tapeline
