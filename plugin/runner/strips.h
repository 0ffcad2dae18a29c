// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/slide.h"
#include "kernel/move.h"
#include "plugin/runner/job.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace tapeline {

/// The width that a move carries along beside its line: none = automatic, 0 = nothing (not asked for, or the method does
/// not), else in mm.
std::optional<double> strip_width(const MoveSettings& settings);

/// How a line with bends beside it slides: `slid` is where the bare line goes. On each side that the line slides to and
/// that has a bend, the bend's outer edge slides by the same law instead, and the line stands on it as it does at rest,
/// in the frames of the edge's direction and the surface's normal: the bend can then be carried along without a kink.
/// `slid` itself where there is no such side. Fails as `slide_on_surface` does.
Result<TargetLine> slide_on_strips(const Model& model, const FeatureLine& line, const TargetLine& slid,
                                   const SlideLaw& law, const TargetSettings& settings,
                                   const std::optional<double>& width, const ExactGround* exact);

/// One sentence on what was carried along; empty when nothing was.
std::string strip_text(const MoveResult& move);

/// `class` ("none", "left", "right", "both") and the numbers of each side, null where there is no strip.
nlohmann::ordered_json strips_json(const MoveResult& move);

} // namespace tapeline
