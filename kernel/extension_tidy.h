// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension_route.h"

#include <vector>

namespace tapeline {

/// Removes from a path what rounding, snapping and detours leave: repeated points, two points on one edge, points on
/// an edge next to one of its ends, loops, and detours inside one triangle.
void tidy_path(const RouteSpace& space, std::vector<PathPoint>& path);

/// Moves points that lie within 5 % of an edge's end, or whose cut would leave a thin triangle, to that end; where the
/// end is blocked, the point keeps 15 % away from it. Leaves the path tidy.
void snap_path(const RouteSpace& space, std::vector<PathPoint>& path);

} // namespace tapeline
