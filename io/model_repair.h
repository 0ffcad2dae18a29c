// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <vector>

namespace tapeline {

/// What `repair_model` found and did.
struct RepairCounts {
    int degenerate_faces = 0;      ///< a corner twice: removed
    int duplicate_faces = 0;       ///< the same three corners again: removed
    int isolated_vertices = 0;     ///< in no triangle: removed
    int flipped_faces = 0;         ///< turned round to agree with their neighbours
    int one_sided_edges = 0;       ///< edges of a one-sided (Möbius) part where no orientation fits: cut open
    int non_manifold_edges = 0;    ///< more than two triangles: all of them cut apart there
    int non_manifold_vertices = 0; ///< triangles at the vertex do not hang together: one vertex for each fan
    int border_edges = 0;          ///< edges with one triangle afterwards
};

/// Makes a mesh edge-manifold, vertex-manifold and consistently oriented where it can be, changing no vertex position
/// and keeping the order of vertices and triangles; copies of split vertices come last. Of a connected part the smaller
/// share of triangles is turned. `cad_face` and `cad_edges` follow.
RepairCounts repair_model(Model& model);

/// Turns closed parts whose enclosed volume is negative, so that normals point outward; `group` holds per triangle
/// a number ≥ 0 of what is judged as a whole (a solid with its cavities), -1 = each connected part by itself. Parts with
/// a border are left alone. Returns the number of turned triangles.
int turn_outward(Model& model, const std::vector<int>& group);

} // namespace tapeline
