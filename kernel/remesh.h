// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"

#include <string>
#include <vector>

namespace tapeline {

struct RemeshOptions {
    double max_edge_mm = 0;   ///< wanted edge length [mm]; must be > 0
    double crease_angle = 10; ///< edges at least this sharp are kept as feature edges [deg]; CAD edges that are sharp
                              ///< or bound the region are always kept
    int iterations = 5;
    std::vector<std::vector<int>> keep_lines; ///< vertex chains whose edges are kept however blunt they are, e.g. L0; a
                                              ///< chain that ends with its first vertex is closed
};

struct RemeshResult {
    Model model; ///< vertices that stay (outside the region, on kept edges) keep index and position, and new
                 ///< ones take the places of those that vanished, then the end. Only when the region got
                 ///< fewer vertices than before are the gaps closed by moving numbers down, in order (see
                 ///< `old_vertex`). Triangles alike.
    std::vector<int> old_vertex;              ///< per new vertex the old vertex at the same place, -1 for new ones
    std::vector<std::vector<int>> kept_lines; ///< options.keep_lines in the new numbers, with the vertices put between
    std::vector<int> region_faces;            ///< the remeshed triangles
    double min_angle_before = 0;              ///< over the region [deg]
    double min_angle_after = 0;
    int projected = 0; ///< new vertices put back on the exact surface
    std::vector<std::string> warnings;
};

/// Remeshes a part of the model with even, well-shaped triangles (CGAL isotropic remeshing; method.md 8.4). Feature
/// edges, CAD tags on them, open borders and the part's own border are split to length and kept; the neighbours outside
/// are split along so that the mesh stays conforming. New vertices are put back on the exact CAD surface where there
/// is one; triangles that would flip by that are left. Beside kept edges that are much shorter than max_edge_mm the
/// mesh is graded down to their length (kernel/mesh_grading.h).
/// Smooth seams between CAD faces are not kept: the triangles flow across them, get the CAD face of the old triangle
/// nearest to their centre, and the seam's edge tags end at the region's border.
/// Rejected when no or unknown triangles are listed, max_edge_mm is not positive or would give more than five million
/// triangles, an edge inside is shared by more than two triangles or a triangle has no area (the place is named).
Result<RemeshResult> remesh_region(const Model& model, const std::vector<int>& faces, const RemeshOptions& options);

/// Smallest interior angle among the listed triangles [deg].
double min_angle(const Mesh& mesh, const std::vector<int>& faces);

} // namespace tapeline
