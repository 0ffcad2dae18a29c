// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/local_global.h"

namespace tapeline {

/// How much a triangle counts that lies in many cells (method.md D).
enum class RingWeights {
    even,   ///< every triangle counts once in all: its energy is the mean over its cells
    by_cell ///< every cell counts its triangles by a third, so triangles near the region's border count for less
};

struct RingOptions : IterationOptions {
    int rings =
        20; ///< n: the cell of a vertex is the triangles with a corner at most n - 1 edges away; 0 = all of them
    RingWeights weights = RingWeights::even;
};

/// As-rigid-as-possible deformation with n-ring cells, ARAP-n (Chen, Gao, Lai and Xia 2017; method.md D): spokes and
/// rims in which one rotation per vertex has to fit all triangles of its n-ring,
///   E_n = Σ_v Σ_{t ∈ T_n(v)} ω_t A_t |J_t - R_v E_t|².
/// n = 1 is spokes-and-rims (`deform` at μ = 1). The more rings, the stiffer against bending, about 0.2 n² h² a unit of
/// squared curvature on edges of length h; n = 2 and 3 can be softer than 1. With one cell for all (`rings` = 0) the
/// region turns as one body and follows its constraints harmonically.
///
/// Faces, errors and convergence as `deform` (deformation.h); no material.
Result<DeformationResult> deform_rings(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                       const RingOptions& options = {}, const std::optional<Positions>& start = {},
                                       const Progress& progress = {});

} // namespace tapeline
