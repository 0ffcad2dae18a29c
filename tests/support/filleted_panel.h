// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/moves.h"
#include "tests/support/shapes.h"

#include <vector>

namespace tapeline::testing {

/// A panel of two flat sides, 600 × 440 mm, with a styled line along y = 0: from y < 0 the surface rises to it by 4°,
/// then falls into a bend `width` wide, 25° steep at the line and flat at the bend's end (a parabola), and goes on flat.
/// The bend has six rows of triangles, on which the vertices have their exact heights. With a second width it grows evenly
/// from the first at x = -150 mm to that at x = 150 mm.
struct FilletedPanel {
    Model model;
    std::vector<int> line, middle; ///< from border to border; |x| ≤ 150 mm of it
    Region region;
    double width, last_width;

    explicit FilletedPanel(double bend_width = 8, double last_width = 0);
    double width_at(double x) const;
    double height(double x, double y) const;
    double floor() const { return height(-150, width); }   ///< of the flat side beyond an even bend [mm]
    Mesh side(const Positions& V, bool left = true) const; ///< the side with the bend (left of the line), or the other
};

/// y = s cos²(πx/400) for |x| ≤ 200, `lift` mm above the line's own height.
ParametricCurve level_slide(double s, double lift = 0);

} // namespace tapeline::testing
