// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/edit.h"
#include "bspline/target_line.h"
#include "kernel/error.h"

#include <filesystem>
#include <vector>

namespace tapeline {

/// Reads a target line by content: JSON (`BSplineData` fields), STEP/IGES/BREP with curves (joined end to end into
/// one line), or a CSV polyline with the header x,y,z (interpolated by a cubic B-spline within 1e-6 of its length).
Result<TargetLine> read_target(const std::filesystem::path& path);

/// Writes by the name's ending: .json (default), .step/.stp, .iges/.igs, .brep, .csv (sampled).
Result<void> write_target(const std::filesystem::path& path, const TargetLine& line);

/// Reads control-point edits: {"edits": [{"index": 2, "to": [x,y,z]} | {"index": 2, "by": [dx,dy,dz]}]}.
Result<std::vector<ControlPointEdit>> read_edits(const std::filesystem::path& path);

} // namespace tapeline
