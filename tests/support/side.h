// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/split.h"

#include <functional>
#include <vector>

namespace tapeline::testing {

/// Row j of a `grid` with nx cells along x, in the order of growing x.
std::vector<int> grid_row(int nx, int j);

/// A line laid over a mesh from border to border (or a loop), with the region of all triangles, or of those whose
/// centre satisfies `in_region`; the region's border is fixed except for the line's vertices.
ExtendedLine line_across(const Mesh& mesh, const std::vector<int>& line, bool closed = false,
                         const std::function<bool(const Vec3&)>& in_region = {});

/// The part of the mesh to the left of the line.
SideMesh left_side(const Mesh& mesh, const std::vector<int>& line, bool closed = false,
                   const std::function<bool(const Vec3&)>& in_region = {});

/// Squash of the side: the smallest ratio after / before, over its triangles, of the altitude on the line's direction.
/// `direction` is the line's at rest; in the moved triangle it is the image of that direction, so the ratio is
/// (area ratio) / (stretch along the direction).
double squash(const SideMesh& side, const Positions& moved, const Vec3& direction);

/// Displacements of the side's line to the crease-slide target y = s cos²(πx/400) of the crease panel.
std::vector<Vec3> crease_slide(const SideMesh& side, double s);

/// Every row multiplied by `scale`, turned by `R` and shifted by `shift`.
Positions transformed(const Positions& V, double scale, const Eigen::Matrix3d& R, const Vec3& shift);

} // namespace tapeline::testing
