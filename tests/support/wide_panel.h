// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/move.h"
#include "tests/support/shapes.h"

#include <vector>

namespace tapeline::testing {

/// The crease-slide panel with surroundings: 1000 × 800 mm, its region the panel's 800 × 600 mm, so that all four rims
/// are inside the model.
struct WidePanel {
    Model model;
    std::vector<int> line;
    Region region;

    explicit WidePanel(Diagonals diagonals, int nx = 76, int ny = 54);
};

/// Throws with the error's sentence when the move fails.
MoveResult move_line(const WidePanel& panel, const TargetCurve& target, const MoveOptions& options);

} // namespace tapeline::testing
