// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/feature_lines.h"
#include "plugin/runner/job.h"

#include <optional>

namespace tapeline {

/// A model with more vertices on one of its lines; old vertices keep their numbers.
struct RefinedLine {
    Model model;
    FeatureLine line; ///< the same whole line on that model
};

/// Halves the line's edges until none is longer than `longest` [mm], so that a part of it can be chosen and moved:
/// tessellations have a single edge on a straight CAD edge. New vertices lie on the exact CAD edge where there is one.
Result<RefinedLine> refine_line(const Model& model, const FeatureLine& line, double longest);

/// True when these settings remesh the surroundings of the model's line: where asked, and on CAD models.
bool remeshes(const Model& model, const RemeshSettings& settings);

/// Where the model is remeshed anyway, a line of few long edges is split up before a part of it is chosen, into edges
/// of `settings.max_edge` (0 = a sixtieth of the line); none where the line is fine as it is.
Result<std::optional<RefinedLine>> refine_before_choice(const Model& model, const FeatureLine& whole,
                                                        const RemeshSettings& settings);

/// Length of the line's longest edge [mm].
double longest_edge(const Mesh& mesh, const FeatureLine& line);

} // namespace tapeline
