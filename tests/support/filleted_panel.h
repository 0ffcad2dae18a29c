// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/moves.h"
#include "tests/support/shapes.h"

#include <vector>

namespace tapeline::testing {

/// A panel of two flat sides, 600 × 440 mm, with a styled line along y = 0: from y < 0 the surface rises to it by 4°,
/// then falls into a bend `width` wide, 25° steep at the line and flat at the bend's end (a parabola), and goes on flat.
/// The bend has six rows of triangles, on which the vertices have their exact heights.
struct FilletedPanel {
    Model model;
    std::vector<int> line, middle; ///< from border to border; |x| ≤ 150 mm of it
    Region region;
    double width;

    explicit FilletedPanel(double bend_width = 8);
    double height(double y) const;
    double floor() const { return height(width); }         ///< of the flat side beyond the bend [mm]
    Mesh side(const Positions& V, bool left = true) const; ///< the side with the bend (left of the line), or the other
};

/// y = s cos²(πx/400) for |x| ≤ 200, `lift` mm above the line's own height.
ParametricCurve level_slide(double s, double lift = 0);

} // namespace tapeline::testing
