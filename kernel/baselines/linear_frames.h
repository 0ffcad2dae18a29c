// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/local_global.h"

namespace tapeline {

/// Deformation by linear rotation-invariant coordinates, LRI (Lipman, Sorkine, Levin and Cohen-Or 2005; method.md E),
/// with positions and frames given at the constrained vertices: `turns` has one rotation per constrained vertex, the
/// one that takes its frame at rest to its frame in the answer.
///
/// Two sparse linear systems. Frames: min Σ_ij w_ij |X_j - F_j F_iᵀ X_i|² over 3×3 matrices X whose rows are the frame
/// vectors, F the frames at rest. With Y_i = X_iᵀ F_i, the turn of frame i, that is Σ_ij w_ij |Y_j - Y_i|², whatever the
/// frames: each entry of Y is harmonic. The Y are then made rotations (polar), as the published second step needs
/// frames that keep their size. Positions: min Σ_ij w_ij |x_j - x_i - ½ (Y_i + Y_j)(p_j - p_i)|². Weights are those of
/// `deform_spokes` (non-negative, so both systems are positive definite).
///
/// Exact where one rotation and shift fits all constraints. A shift of the line that leaves its frames turns nothing:
/// the surface follows by shear (the published method's known blindness to translations).
///
/// One solve, so the answer is unique; `iterations` = 1, `error_estimate_mm` is the size of a step of iterative
/// refinement, `converged` says whether that is below 1e-9 of the mesh's size, `energy` is that of the second system.
/// Usage error: counts differ. Rejected and not converged as `deform` (deformation.h). Cancelled through `progress`.
Result<DeformationResult> deform_linear_frames(const Mesh& rest, const std::vector<int>& constrained,
                                               const Positions& targets, const std::vector<Eigen::Matrix3d>& turns,
                                               const Progress& progress = {});

/// The turns of a line's Darboux frames (tangent, surface normal, their cross product) from its rest places to
/// `targets`, one per vertex of `line` (method.md E): tangents by central differences along line and targets; the
/// normal at rest is the mesh's vertex normal, at the target the interpolated vertex normal of the mesh's closest point
/// where `on_surface`, otherwise the rest normal carried by the smallest rotation that takes the one tangent to the
/// other, which also stands in where a normal runs along its tangent. Vertices that stay where they are on a line that
/// stays do not turn.
std::vector<Eigen::Matrix3d> darboux_turns(const Mesh& rest, const std::vector<int>& line, bool closed,
                                           const std::vector<Vec3>& targets, bool on_surface);

} // namespace tapeline
