// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/correspondence.h"
#include "kernel/split.h"

namespace tapeline {

/// Whether the line stays on the surface (Section 3.4): decides between split-and-retract and one plain deformation.
enum class Placement { on_surface, off_surface };

struct PlacementResult {
    Placement verdict = Placement::on_surface;
    double off_fraction = 0; ///< normal share of the displacement, Σ|u_N| / Σ|u| over the used line, in [0, 1]
    LineSide compressed = LineSide::left; ///< by the signed rule (method.md A5)
    double c_left = 0;  ///< Σ len · (u · m) with m the conormal into the left side [mm²]; positive = compressed
    double c_right = 0;
    double s_alpha = 0; ///< the paper's Σ|u_T| of the left side [mm]
    double s_beta = 0;  ///< the same of the right side
    double u_max_mm = 0; ///< largest displacement
};

/// Decides on/off-surface and which side of the line is compressed (Sections 3.4 and 5; method.md A5, K).
PlacementResult decide_placement(const Mesh& mesh, const Topology& topology, const Correspondence& correspondence);

} // namespace tapeline
