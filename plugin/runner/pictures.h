// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/error.h"
#include "kernel/move.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tapeline {

/// One picture as the bytes of a PNG file.
struct Picture {
    std::string name;  ///< file name, "before_zebra.png"
    std::string title; ///< for people
    std::string png;
};

/// Pictures of a move from one camera: shaded, zebra stripes and curvature sign before and after, and sections
/// across the line.
Result<std::vector<Picture>> draw_move(const MoveResult& move, const TargetCurve& target);

/// The model with its numbered feature lines, as a PNG file.
Result<void> draw_lines(const std::filesystem::path& png, const Mesh& mesh, const std::vector<FeatureLine>& lines);

} // namespace tapeline
