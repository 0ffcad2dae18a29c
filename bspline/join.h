// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"

#include <vector>

namespace tapeline {

/// Joins curves of one degree end to end into one line, whatever their order and sense; the first curve's sense is kept.
/// Ends closer than `tolerance_mm` are joined (both go to their middle); a chain whose ends meet becomes closed. Joints
/// keep the tangents as they are. The parameter is the arc length at each joint.
/// Rejected: no curve, curves that form several separate lines (how many), curves that branch (where), different
/// degrees.
Result<TargetLine> join_lines(const std::vector<BSplineData>& curves, double tolerance_mm);

} // namespace tapeline
