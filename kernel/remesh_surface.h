// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <vector>

namespace tapeline {

/// Where on the exact geometry a vertex belongs: on a CAD edge, else on a CAD face, else (both -1) nowhere.
struct SurfaceSite {
    int vertex = -1;
    int cad_edge = -1;
    int cad_face = -1;
    double reach = 0; ///< larger moves are taken for mistakes [mm]
};

struct SurfacePlacement {
    int placed = 0; ///< vertices now on the exact geometry
    int left = 0;   ///< vertices that stay off it: no foot found, too far, or triangles would flip
};

/// Puts vertices back that went from `before` to V (`moved`, one flag a vertex) where a triangle turned by more than 60°
/// or kept less than a twentieth of its area, until there is no such triangle; their flags are cleared.
void take_back_folds(const Triangles& F, const Positions& before, Positions& V, std::vector<char>& moved);

/// Moves each listed vertex to the closest point of its CAD edge or face. Where that turns a triangle by more than 60°
/// or leaves less than a twentieth of its area, its vertices stay where they were.
SurfacePlacement place_on_surface(Model& model, const std::vector<SurfaceSite>& sites);

} // namespace tapeline
