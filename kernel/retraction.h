// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/orthotropic.h"
#include "kernel/split.h"

#include <vector>

namespace tapeline {

enum class RetractionMode {
    harmonic, ///< orthotropic harmonic displacement, slid along the surface (method.md A2; default)
    planes    ///< linear fall-off along plane sections between L0 and the rim (the paper's Section 4.3)
};

struct RetractionOptions {
    RetractionMode mode = RetractionMode::harmonic;
    Material material; ///< the same material as the solver's, for `harmonic`
};

struct RetractionResult {
    Positions V;               ///< slid positions of all local vertices, each on the side's original surface
    double min_area_ratio = 1; ///< smallest triangle area after / before
    int flipped = 0;           ///< triangles whose normal turned by more than 90°
    int crossings = 0;         ///< `planes`: pairs of neighbouring section curves C_P that cross (hypothesis (H))
};

/// Slides the compressed side's vertices along its own surface so that its material makes room for the line
/// (Sections 4.2, 4.3). `displacements` has one entry per entry of side.line: where that vertex should go, relative to
/// its rest position [mm]; entries pointing out of the side slide nothing. Fixed vertices do not move. Line vertices
/// end on the side's surface point closest to rest + displacement (method.md A3), guided vertices on their own targets.
Result<RetractionResult> retract(const SideMesh& side, const std::vector<Vec3>& displacements,
                                 const RetractionOptions& options = {});

} // namespace tapeline
