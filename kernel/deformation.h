// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/orthotropic.h"
#include "kernel/progress.h"

#include <optional>
#include <vector>

namespace tapeline {

struct DeformationOptions {
    Material material;
    double tolerance_mm = 0; ///< wanted largest vertex error [mm]; 0 = 1e-5 of the mesh's size
    int max_iterations = 2000;
    int anderson_window = 5; ///< differences kept for Anderson acceleration; 0 = plain local/global
    int load_steps = 1;      ///< the displacement is applied in this many equal steps from the rest shape
};

struct DeformationResult {
    Positions V; ///< deformed positions, n×3
    int iterations = 0;
    double error_estimate_mm = 0; ///< estimate of the largest vertex distance to the minimiser (method.md I7)
    double residual = 0;          ///< relative force residual (method.md I7)
    double energy = 0;            ///< Σ A |J - R E|²_D / 3 over cells [mm²]
    bool converged = false;
    double seconds = 0;
};

/// Minimises the ASAN energy: spokes-and-rims ARAP with an orthotropic material (the paper's Section 5.3; Chao et al.
/// 2010; method.md B2, B5), by local/global iterations with Anderson acceleration (Peng et al. 2018; method.md I3).
/// μ = 1 is ARAP spokes-and-rims. `constrained` lists vertices, `targets` one row each [mm]. `start` (n×3) replaces
/// the harmonic start. Not reaching the tolerance is no error here: see `converged`. Cancelled through `progress`.
/// Rejected when a vertex is not connected to any constraint or a triangle has no area.
Result<DeformationResult> deform(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                 const DeformationOptions& options, const std::optional<Positions>& start = {},
                                 const Progress& progress = {});

/// Rotation R that maximises tr(Rᵀ S), det R = +1 (quaternion quartic, SVD fall-back; method.md I6).
Eigen::Matrix3d polar_rotation(const Eigen::Matrix3d& S);

} // namespace tapeline
