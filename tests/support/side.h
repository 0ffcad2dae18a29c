// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/split.h"

#include <functional>
#include <vector>

namespace tapeline::testing
{

/// Row j of a `grid` with nx cells along x, in the order of growing x.
std::vector<int> grid_row(int nx, int j);

/// A line laid over a mesh from border to border (or a loop), with the region of all triangles, or of those whose
/// centre satisfies `in_region`; the region's border is fixed except for the line's vertices.
ExtendedLine line_across(const Mesh& mesh, const std::vector<int>& line, bool closed = false,
                         const std::function<bool(const Vec3&)>& in_region = {});

/// The part of the mesh to the left of the line.
SideMesh left_side(const Mesh& mesh, const std::vector<int>& line, bool closed = false,
                   const std::function<bool(const Vec3&)>& in_region = {});

/// Squash of the first `faces` triangles: the smallest ratio after / before of the altitude that belongs to the
/// triangle's extent along `direction` (twice the area by that extent).
double squash(const Mesh& rest, int faces, const Positions& moved, const Vec3& direction);

/// The same by the altitude on the moved line's own direction where the triangle has an edge on the line.
double squash_at_line(const SideMesh& side, const Positions& moved);

/// Displacements of the side's line to the crease-slide target y = s cos²(πx/400) of the crease panel.
std::vector<Vec3> crease_slide(const SideMesh& side, double s);

/// Every row multiplied by `scale`, turned by `R` and shifted by `shift`.
Positions transformed(const Positions& V, double scale, const Eigen::Matrix3d& R, const Vec3& shift);

} // namespace tapeline::testing
