// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/moves.h"
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

} // namespace tapeline::testing
