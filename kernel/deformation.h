// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/local_global.h"
#include "kernel/orthotropic.h"

#include <optional>
#include <vector>

namespace tapeline {

struct DeformationOptions : IterationOptions {
    Material material;
};

/// Minimises the ASAN energy: spokes-and-rims ARAP with an orthotropic material (the paper's Section 5.3; Chao et al.
/// 2010; method.md B2, B5), Σ A |J - R E|²_D / 3 over cells, by local/global iterations with Anderson acceleration (Peng et al. 2018; method.md I3).
/// μ = 1 is ARAP spokes-and-rims. `constrained` lists vertices, `targets` one row each [mm]. `start` (n×3) replaces
/// the harmonic start. Not reaching the tolerance is no error here: see `converged`. Cancelled through `progress`.
/// Rejected when a vertex is not connected to any constraint or a triangle has no area.
Result<DeformationResult> deform(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                 const DeformationOptions& options, const std::optional<Positions>& start = {},
                                 const Progress& progress = {});

/// Rotation R that maximises tr(Rᵀ S), det R = +1 (quaternion quartic, SVD fall-back; method.md I6).
Eigen::Matrix3d polar_rotation(const Eigen::Matrix3d& S);

} // namespace tapeline
