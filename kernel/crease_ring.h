// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/split.h"

#include <vector>

namespace tapeline {

/// Places for the first ring of vertices beside a moved line.
struct CreaseRing {
    std::vector<int> vertices;
    std::vector<Vec3> targets; ///< [mm]
};

/// Where the first ring of a side's vertices beside its line must lie so that its triangles get the wanted normals (the
/// Hermite end of method.md A9; Section 5.6 of the paper turns the same triangles).
/// `line` has the new place of each entry of side.line; per line edge i (from entry i to the next; the closing one last)
/// `normals` has the unit normal that this side's triangle beside it is to have, normal to the edge's new direction; zero
/// leaves the edge free, and vertices that only touch free edges out. Each vertex keeps its place relative to the line:
/// the arms turn with a frame of line direction and wanted normal. Corners opposite a line edge are then moved into that
/// edge's plane (of several: least squares). Fixed and guided vertices are left out. `carried` are the side's positions
/// with the line moved, by which a vertex's place in its plane is told; what they lie off the plane is undone.
CreaseRing crease_ring(const SideMesh& side, const Positions& carried, bool closed, const std::vector<Vec3>& line,
                       const std::vector<Vec3>& normals, bool left);

} // namespace tapeline
