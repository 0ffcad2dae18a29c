// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/local_global.h"

namespace tapeline {

/// As-rigid-as-possible surface modelling as first published, with spokes only (Sorkine and Alexa 2007; method.md C):
/// minimises ½ Σ_i Σ_{j ∈ N(i)} w_ij |(x_i - x_j) - R_i (p_i - p_j)|², w_ij half the sum of the cotangents opposite
/// the edge. Negative cotangents count as 0, as in CGAL: the energy could fall without limit otherwise. The price is
/// linear precision on meshes with obtuse triangles.
///
/// Faces, errors and convergence as `deform` (deformation.h); no material.
Result<DeformationResult> deform_spokes(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                        const IterationOptions& options = {},
                                        const std::optional<Positions>& start = {}, const Progress& progress = {});

} // namespace tapeline
