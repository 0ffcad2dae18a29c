// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"

#include <string>
#include <vector>

namespace tapeline {

struct RemeshOptions {
    double max_edge_mm = 0;    ///< wanted edge length [mm]; must be > 0
    double crease_angle = 10;  ///< edges at least this sharp are kept as feature edges [deg]; CAD edges that are sharp
                               ///< or bound the region are always kept
    int iterations = 5;
};

struct RemeshResult {
    Model model;            ///< vertices outside the region keep index and position; vertices of the old region that
                            ///< vanished are dropped and the rest renumbered (see `old_vertex`)
    std::vector<int> old_vertex; ///< per new vertex the old vertex at the same place, -1 for new ones
    std::vector<int> region_faces; ///< the remeshed triangles
    double min_angle_before = 0; ///< over the region [deg]
    double min_angle_after = 0;
    int projected = 0;      ///< new vertices put back on the exact surface
    std::vector<std::string> warnings;
};

/// Remeshes a part of the model with even, well-shaped triangles (CGAL isotropic remeshing; method.md 8.4). Feature
/// edges, CAD tags on them, open borders and the part's own border are split to length and kept; the neighbours outside
/// are split along so that the mesh stays conforming. New vertices are put back on the exact CAD surface where there
/// is one.
Result<RemeshResult> remesh_region(const Model& model, const std::vector<int>& faces, const RemeshOptions& options);

/// Smallest interior angle among the listed triangles [deg].
double min_angle(const Mesh& mesh, const std::vector<int>& faces);

} // namespace tapeline
