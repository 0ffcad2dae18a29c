// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "patches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::models {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double bend_width = 8; // [mm]

double crown(double x, double y) { return -x * x / 12000 - y * y / 6000; }

/// The styled step across the line: rising to it, then falling into the bend and out of it.
double step(double y)
{
    const double t = std::clamp(y, 0.0, bend_width);
    return std::tan(4 * degree) * std::min(y, 0.0) - std::tan(25 * degree) * (t - t * t / (2 * bend_width));
}

} // namespace

TopoDS_Shape filleted_panel()
{
    const auto point = [](double x, double y) { return gp_Pnt(x, y, crown(x, y) + step(y)); };
    const Direction along = uniform(-400, 400, 4, 3);
    return shell_of({face_of(interpolate(along, uniform(-300, 0, 2, 3), point)),
                     face_of(interpolate(along, uniform(0, bend_width, 2, 3), point)),
                     face_of(interpolate(along, uniform(bend_width, 300, 2, 3), point))});
}

} // namespace tapeline::models
