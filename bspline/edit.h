// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/fit.h"
#include "bspline/slide.h"
#include "bspline/target_line.h"

#include <vector>

namespace tapeline {

/// One change of a control point: to a position, or by a vector when `relative` [mm].
struct ControlPointEdit {
    int index = 0;
    Vec3 value = Vec3::Zero();
    bool relative = false;
};
/// Applies edits one after the other; knots and weights stay. A closed line stays closed: its first and last control
/// point are one, and where it was tangent-continuous at the seam it stays so: the points beside the seam go along
/// with the seam point, and moving one of them turns the other about it.
/// Rejected: an index out of range, a value that is not finite.
Result<TargetLine> move_control_points(const TargetLine& line, const std::vector<ControlPointEdit>& edits);

/// Local Farin–Sapidis fairing (method.md H3): evens out the jumps of the third derivative at the knots, one control
/// point at a time where the jump is largest, as long as their sum falls, moving no control point by more than
/// `max_move_mm`. The two control points at each end stay, so ends, end tangents and a closed line's seam are kept.
/// A line that is no plain cubic (degree, weights, repeated knots) is refitted as one first, within a tenth of
/// `max_move_mm`, which then counts into the limit.
Result<TargetLine> fair(const TargetLine& line, double max_move_mm);

} // namespace tapeline
