// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "patches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::models {

namespace {

constexpr double length = 1400, half_width = 600; // [mm]
constexpr double fade_start = 250, fade_end = 1250;

/// Plan view of the character line.
double line_y(double x)
{
    const double t = (x - length / 2) / (length / 2);
    return 45 - 90 * t * t;
}

/// Slope of each side against the crown at the line: half the crease angle's tangent.
double side_slope(double x)
{
    const double t = std::clamp((x - fade_start) / (fade_end - fade_start), 0.0, 1.0);
    const double rest = 1 - t;
    // Quintic step: curvature is continuous where the fade starts and ends.
    return std::tan(10 * std::numbers::pi / 180) * rest * rest * rest * (1 + 3 * t + 6 * t * t);
}

double height(double x, double y)
{
    const double t = x - length / 2;
    const double crown = -t * t / 6000 - y * y / 3600;
    // The slope of the line's sides dies away from it, slowly enough that sections keep one sign of curvature.
    constexpr double reach = 700;
    return crown - side_slope(x) * reach * (1 - std::exp(-std::abs(y - line_y(x)) / reach));
}

TopoDS_Face side(double rim_y)
{
    const Direction along{{0, 125, 250, 350, 450, 550, 650, 750, 850, 950, 1050, 1150, 1250, 1325, 1400}, 5};
    const Direction across = uniform(0, 1, 4, 5);
    return face_of(interpolate(along, across, [rim_y](double x, double t) {
        const double y = line_y(x) + t * (rim_y - line_y(x));
        return gp_Pnt(x, y, height(x, y));
    }));
}

} // namespace

TopoDS_Shape hood()
{
    // One side has its surface normal turned down by its parameters; the face is turned, as CAD systems do.
    TopoDS_Face left = side(half_width), right = side(-half_width);
    right.Reverse();
    return shell_of({left, right});
}

} // namespace tapeline::models
