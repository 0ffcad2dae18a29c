// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/feature_lines.h"

namespace tapeline {

/// A model with more vertices on one of its lines; old vertices keep their numbers.
struct RefinedLine {
    Model model;
    FeatureLine line; ///< the same whole line on that model
};

/// Halves the line's edges until none is longer than `longest` [mm], so that a part of it can be chosen and moved:
/// tessellations have a single edge on a straight CAD edge. New vertices lie on the exact CAD edge where there is one.
Result<RefinedLine> refine_line(const Model& model, const FeatureLine& line, double longest);

/// Length of the line's longest edge [mm].
double longest_edge(const Mesh& mesh, const FeatureLine& line);

} // namespace tapeline
