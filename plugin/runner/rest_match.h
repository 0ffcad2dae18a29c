// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension.h"
#include "kernel/mesh.h"

#include <string>
#include <vector>

namespace tapeline {

/// Where the vertices of a moved mesh were before.
struct RestMatch {
    bool found = false;
    Positions V;       ///< rest positions, one per vertex of the moved mesh
    std::string how;   ///< a sentence: how they were found, or why not
    bool exact = true; ///< false when positions of appended vertices are estimates
};

/// Finds the rest positions of a moved mesh's vertices in the mesh before the move. Works when both have the same
/// triangles (in the same order, numbered alike or not), when they have the same number of vertices, and when the moved
/// mesh has vertices appended on edges of the one before. `appended` says where those lie, in order; when it is
/// empty they are found from the edges that the cut removed.
RestMatch match_rest(const Mesh& moved, const Mesh& before, const std::vector<AppendedVertex>& appended);

/// That rest shape as a model with the CAD faces of the one before, if it has any: of each triangle the face of the
/// triangle before that its centre lies on.
Model with_cad_faces(Mesh rest, const Model& before);

} // namespace tapeline
