// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/isotropic.h"
#include "kernel/remesh.h"
#include "kernel/remesh_surface.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// The model with its kept edges split to length: the first stage of remeshing.
struct Divided {
    Model model;
    int old_vertices = 0; ///< vertices and triangles of the model before
    int old_faces = 0;
    std::vector<char> in_region;         ///< per triangle
    std::vector<int> faces;              ///< region triangles, ascending
    std::vector<VertexPair> kept;        ///< ascending
    std::vector<int> tips;               ///< single vertices to be kept
    std::vector<std::vector<int>> lines; ///< options.keep_lines with the vertices put between
    std::vector<SurfaceSite> sites;      ///< of the vertices put on edges
};

/// Splits the region's kept edges into equal parts of at most max_edge, the triangles outside along with them.
Divided divide(const Model& model, const Topology& topology, const std::vector<int>& faces,
               const RemeshOptions& options);

/// The region between the kept edges, remeshed: the second stage.
struct Remeshed {
    FacePatch patch;       ///< the divided region
    std::vector<int> part; ///< per patch triangle the edge-connected part between kept edges
    IsotropicResult result;
};

Result<Remeshed> remesh_patch(const Divided& divided, const RemeshOptions& options);

/// Joins the remeshed region with the rest: the third stage. Fills the model, old_vertex, kept_lines and region_faces;
/// `sites` says where on the exact surface each new vertex belongs.
RemeshResult join(const Divided& divided, const Remeshed& remeshed, const RemeshOptions& options,
                  std::vector<SurfaceSite>& sites);

} // namespace tapeline
