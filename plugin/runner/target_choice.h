// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"
#include "kernel/feature_lines.h"
#include "plugin/runner/job.h"

#include <optional>
#include <string>

namespace tapeline {

/// A target line and how it came about.
struct TargetChoice {
    TargetLine line;
    std::string source;      ///< "file", "fit" or "given"
    double fit_error_mm = 0; ///< largest distance of the feature line to its fit
    std::vector<std::string> warnings;
};

/// Positions of a line's vertices in order.
std::vector<Vec3> line_points(const Mesh& mesh, const FeatureLine& line);

/// True when the settings ask for a line other than the feature line itself.
bool changes_line(const TargetSettings& settings);

/// Makes the target line that the settings ask for: read from the file or fitted to the feature line, then control
/// points moved (`edit`), slid along the surface (`slide`), faired (`fair`), dropped onto the model (`on_surface`).
/// `given` takes the place of the file. A fitted line that slides takes bends beside it along (`slide_on_strips`) by the
/// `strip_width`.
Result<TargetChoice> make_target(const Model& model, const FeatureLine& line, const TargetSettings& settings,
                                 const std::optional<TargetLine>& given = {},
                                 const std::optional<double>& strip_width = 0.0);

} // namespace tapeline
