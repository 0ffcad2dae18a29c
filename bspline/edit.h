// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/fit.h"
#include "bspline/target_line.h"
#include "kernel/closest_point.h"

#include <vector>

namespace tapeline {

/// One change of a control point: to a position, or by a vector when `relative`.
struct ControlPointEdit {
    int index = 0;
    Vec3 value = Vec3::Zero();
    bool relative = false;
};
Result<TargetLine> move_control_points(const TargetLine& line, const std::vector<ControlPointEdit>& edits);

/// Slide law: pairs (fraction of arc length in [0, 1], signed distance [mm]); monotone-smooth (PCHIP) in between.
/// One pair = constant.
struct SlideLaw {
    std::vector<std::pair<double, double>> values;
};
/// Slides a line along the model's surface, at each point perpendicular to the line and tangent to the surface,
/// positive to the left of the line seen from outside, measured along the surface; the result is refitted and
/// lies on the surface within `tolerance_mm` (0 = as in FitOptions).
Result<TargetLine> slide_on_surface(const TargetLine& line, const Mesh& mesh, const SlideLaw& law,
                                    double tolerance_mm = 0);

/// Drops the line onto the model: samples it, takes closest surface points, refits. Rejected when a point is farther
/// from the model than the line's own length.
Result<TargetLine> lay_on_surface(const TargetLine& line, const Mesh& mesh, double tolerance_mm = 0);

/// Local Farin–Sapidis fairing (method.md H3), moving no control point by more than `max_move_mm`.
Result<TargetLine> fair(const TargetLine& line, double max_move_mm);

} // namespace tapeline
