// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"
#include "kernel/quality.h"

#include <span>
#include <vector>

namespace tapeline {

/// How a plane section of a triangle mesh bends. A section of a triangulation is a polyline with a zigzag of its own
/// (the plane meets edges and diagonals at uneven distances from the true surface), so nothing is read off its corners.
/// Instead the direction θ(s) of chords of about eight segments is followed along the section; near the ends and in
/// tight places the chords shrink to two segments. Each θ is known to ± ε = (δ + δ0) / r, with r half the chord's length,
/// δ the largest near the chord of the edges' sagittas and of the polyline's own roughness (half its deviation from
/// straight over one and two segments), and δ0 = 1e-5 of the section's length, for coordinates and solver. This is the
/// dead band: an inflection is a reversal of θ that no curve within θ ± ε can avoid.
struct SectionShape {
    int inflections = 0; ///< reversals of θ beyond the dead band
    double turning = 0;  ///< Σ |Δθ| between the ends and the inflections [deg]
    std::vector<Vec3> inflection_points;
    std::vector<Vec3> points;      ///< samples along the section, evenly spaced [mm]
    std::vector<double> angle;     ///< θ at the samples, relative to the first [deg]
    std::vector<double> dead_band; ///< ε at the samples [deg]
    std::vector<Vec3> curvature;   ///< curvature vector at the samples, towards the centre [1/mm]
};

/// Shape of one section polyline in the plane with unit normal `normal`. Fewer than three distinct points are a straight
/// line. `sagitta` has one entry per point (`Section::sagitta`) or none. The answer does not depend on position and
/// scale; reversed input gives the same numbers.
SectionShape section_shape(std::span<const Vec3> polyline, const Vec3& normal, std::span<const double> sagitta = {});

/// The shapes of a section's four polylines.
struct SectionShapes {
    SectionShape compressed_before, compressed_after, tension_before, tension_after;
};
SectionShapes section_shapes(const Section& section);

} // namespace tapeline
