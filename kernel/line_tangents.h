// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <utility>
#include <vector>

namespace tapeline {

/// Entries before and after entry i of a line of n vertices; i itself beyond the ends of an open one.
std::pair<size_t, size_t> line_neighbours(size_t i, size_t n, bool closed);

/// Unit tangents of a polyline by central differences; one-sided at open ends.
std::vector<Vec3> line_tangents(const std::vector<Vec3>& points, bool closed);

/// Length of the polyline through the listed vertices, closing edge included [mm].
double line_length(const Positions& V, const std::vector<int>& line, bool closed);

} // namespace tapeline
