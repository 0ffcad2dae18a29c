// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/local_global.h"

namespace tapeline {

struct SmoothRotationOptions : IterationOptions {
    double smoothness = 0.02; ///< α: 0 is `deform_spokes`, a large one turns the region as a whole
};

/// As-rigid-as-possible deformation with smooth rotations (Levi and Gotsman 2015; method.md C), as CGAL's
/// Surface_mesh_deformation does it under the name SRE_ARAP: the spokes energy with a bending stiffness that does not
/// depend on the mesh, α A |R_i - R_j|² between neighbours, A the area of `rest`.
///
/// Computes the fixed point of CGAL's two steps: R_i = polar(Σ_j w_ij (x_i - x_j)(p_i - p_j)ᵀ + (α A / |N(i)|) Σ_j R_j)
/// and the spokes' global step. With the division by the number of neighbours |N(i)| the two do not lower one common
/// energy unless all vertices have as many; `energy` is ½ Σ_ij (w_ij |…|² + (α A / |N(i)|) |R_i - R_j|²). CGAL's
/// rotations of one iteration are one sweep over the vertices; here the coupled rotations are solved for.
///
/// Faces, errors and convergence as `deform` (deformation.h); no material.
Result<DeformationResult> deform_smooth_rotations(const Mesh& rest, const std::vector<int>& constrained,
                                                  const Positions& targets, const SmoothRotationOptions& options = {},
                                                  const std::optional<Positions>& start = {},
                                                  const Progress& progress = {});

} // namespace tapeline
