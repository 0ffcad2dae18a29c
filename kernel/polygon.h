// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace tapeline {

/// Splits one polygon into triangles over its own corners, without new points, turning the same way.
///
/// points: n×3 in any unit; polygon: indices into points. Corners named twice in a row count once. A quadrilateral is
/// cut along its shorter diagonal (the one from its first corner when they are equal to 1e-6) or along the one that a
/// reflex corner leaves; more corners go through a constrained Delaunay triangulation in the polygon's best plane
/// (Newell's normal), so corners in a row on a straight side, concave outlines and holes joined to the outline by a
/// double edge are fine. Every side of the polygon is a side of exactly one triangle: neighbours stay joined.
///
/// Empty result: fewer than three corners. A polygon without area gives a fan (triangles without area), which keeps
/// its neighbours joined. No result: it crosses or touches itself in its plane, so that no triangulation exists or
/// more than one is meant.
std::optional<std::vector<std::array<int, 3>>> triangulate_polygon(std::span<const Vec3> points,
                                                                   std::span<const int> polygon);

} // namespace tapeline
