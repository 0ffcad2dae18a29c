// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/extension.h"
#include "kernel/face_patch.h"

#include <array>
#include <span>
#include <vector>

namespace tapeline {

/// The side of a line that lies to its left or right, seen from outside along the line's direction.
enum class LineSide { left = 0, right = 1 };

/// One part of the region, cut free along L̂0 (the paper's S_a or S_b), with its own vertex numbering.
/// The first `inner_faces` triangles are the side itself; the rest are the ring of outside triangles that keeps the
/// tangent plane at the rim (clamp_rings, method.md B8).
struct SideMesh {
    Mesh mesh;
    int inner_faces = 0;
    std::vector<int> to_global;    ///< local vertex -> vertex of the extended model
    std::vector<int> global_faces; ///< local triangle -> triangle of the extended model
    std::vector<int> line;         ///< local indices along L̂0, in the line's order (closed: not repeated)
    std::vector<int> fixed; ///< local indices of immobile vertices (rim, inner constraints, clamp rings), ascending,
                            ///< without the vertices of `line`
    std::vector<VertexPair> features; ///< local edges inside the side that belong to other feature lines, ascending
    std::vector<VertexPair> kept;     ///< those of them that nothing may be dragged over, however blunt, ascending
    std::vector<int> guided;          ///< local border vertices that make room for a line end sliding along the border
    std::vector<Vec3> guided_targets; ///< where each of them goes; see border_slide.h

    /// The side itself, without the ring: its triangles of the extended model, and its mesh, at rest and at `V`.
    std::span<const int> own_faces() const { return std::span(global_faces).first(inner_faces); }
    Mesh own_mesh() const { return own_mesh(mesh.V); }
    Mesh own_mesh(const Positions& V) const { return {V, mesh.F.topRows(inner_faces)}; }
};

/// Cuts the region along the extended line (Section 5.2) into its left [0] and right [1] part. Rejected when the cut
/// does not separate them (a hole or a second opening in the region: its place is named), with the vertex at which
/// both parts still meet.
Result<std::array<SideMesh, 2>> split_along(const ExtendedLine& extended, int clamp_rings = 1);

/// The whole region uncut, for methods that do not split (off-surface moves, baselines); `line` holds L̂0.
SideMesh whole_region(const ExtendedLine& extended, int clamp_rings = 1);

/// Writes the side's vertex positions into the positions of the whole model (Section 5.5). Only the side's own free
/// vertices and its line are written, so everything outside stays bit-identical.
void sew(const SideMesh& side, const Positions& side_positions, Positions& model_positions);

} // namespace tapeline
