// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/correspondence.h"
#include "kernel/split.h"
#include "kernel/topology.h"

namespace tapeline {

/// Whether the line stays on the surface (Section 3.4): decides between split-and-retract and one plain deformation.
enum class Placement { on_surface, off_surface };

struct PlacementResult {
    Placement verdict = Placement::on_surface;
    double off_fraction = 0; ///< Σ len·lift / Σ len·|u|, lift = distance of the target from the surface; in [0, 1]
    double normal_fraction = 0; ///< the paper's figure: Σ|u_N| / Σ|u|, u_N along the normal of the compressed side
    LineSide compressed = LineSide::left; ///< by the signed rule (method.md A5)
    double c_left = 0; ///< Σ len · (u · m) with m the conormal into the left side [mm²]; positive = compressed
    double c_right = 0;
    double s_alpha = 0;  ///< the paper's Σ|u_T| of the left side [mm]
    double s_beta = 0;   ///< the same of the right side
    double u_max_mm = 0; ///< largest displacement
    /// Share that the region's deformation in one piece has in the result: 0 as long as the line travels across itself
    /// along the surface, 1 where it rises straight, in between where it rises at 72° to 82°.
    double whole_share = 0;
};

/// 0 below `from`, 1 above `to`, the cubic with slope 0 at both ends in between.
double smooth_step(double value, double from, double to);

/// Decides on/off-surface and which side of the line is compressed (Sections 3.4 and 5; method.md A5, K).
/// On-surface unless the targets rise above the region's surface by more than they travel along it, in the mean
/// (off_fraction > 1/√2): the paper's verdict, which is reported. What is done goes from one to the other gradually: with
/// the lift ℓ and the way w across the line along the surface, means over the line, whole_share is a smooth step of
/// ℓ / √(ℓ² + w²) from 0.95 to 0.99, times one of off_fraction from 0.3 to 0.7. The distance to the surface decides instead of the normals at the line, because a long slide
/// on a curved surface leaves the tangent plane without leaving the surface; `normal_fraction` reports the latter.
/// Sides count triangles of the whole model beside the line; `region` limits what the distance is measured to.
PlacementResult decide_placement(const Mesh& mesh, const Region& region, const Correspondence& correspondence);
/// The same with the mesh's topology and the region's surface at hand.
PlacementResult decide_placement(const Mesh& mesh, const Topology& topology, const ClosestPoint& surface,
                                 const Correspondence& correspondence);

/// Signed turn of the surface across the directed edge a→b: the angle from the right triangle's normal to the left
/// one's about the edge's direction [deg], 0 = flat, in (-180, 180]. One entry per edge of the line.
std::vector<double> signed_crease_angles(const Mesh& mesh, const Positions& V, const FeatureLine& line);

} // namespace tapeline
