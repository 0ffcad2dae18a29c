// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/deformation.h"
#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/orthotropic.h"
#include "kernel/plate_system.h"
#include "kernel/progress.h"

#include <optional>

namespace tapeline {

struct PlateOptions {
    Material material{.stiffness_ratio = 3};
    double tolerance_mm = 0; ///< wanted largest vertex error [mm]; 0 = 1e-5 of the mesh's size
    int max_passes = 200;
};

/// The orthotropic thin plate through given positions (method.md A9): the displacement u of least bending,
///
///     Σ_a M_a |(K u)_a / M_a|²,    K_ab = Σ_t A_t g_aᵀ D_t g_b,
///
/// tangent-continuous where a ring of outside triangles is clamped, free of moment at `free_slope`. Affine displacements
/// of flat parts and rigid motions of the support are reproduced. Beyond A9, so that large moves stay shape-true:
/// - the plate is described over the rest mesh stretched harmonically to where the support goes, and the rest shape's
///   curvature is carried there and kept under stretching: a stretched crown stays as round as it was;
/// - it is turned with each vertex's neighbourhood and the system solved again on the same factorisation until nothing
///   changes (Anderson-accelerated passes; for small moves the first is the answer already);
/// - the free end along `line` has a small Poisson ratio (kernel/plate_system.cpp), without which oblique sections of a
///   curved line get an inflection.
/// Every pass has one answer. The bending does not depend on mesh size (method.md B3 does not apply).
///
/// The surface meets borders whose vertices are free as it did at rest, ∂u/∂n = 0; the free plate's third-order
/// condition is not modelled.
///
/// Result: `iterations` are passes, `energy` is without unit. Not reaching the tolerance is no error here: see
/// `converged`; passes end early when the smallest step has not halved within fifty of them. `start` (n×3, meeting the support) replaces the stretched rest shape as the first guess. Cancelled
/// through `progress`. Rejected when a vertex is not connected to any constraint or a triangle has no area; usage error
/// when the counts of the support differ.
Result<DeformationResult> bend_plate(const Mesh& rest, const PlateSupport& support, const PlateOptions& options = {},
                                     const std::optional<Positions>& start = {}, const Progress& progress = {});

} // namespace tapeline
