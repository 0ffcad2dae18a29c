// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "patches.h"

#include <cmath>
#include <numbers>

namespace tapeline::models {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double arch_radius = 340, panel_width = 330; // [mm]

/// Radius of the character line, about the wheel's centre: 45 mm above the arch at the top, 35 mm at the ends.
double line_radius(double angle) { return arch_radius + 45 - 10 * std::cos(angle) * std::cos(angle); }

/// How far the panel stands out (along y), at a place in the wheel's plane.
double crown(double x, double z) { return -x * x / 9000 - (z - 100) * (z - 100) / 5000; }

/// The panel beyond the line, at distance t ≥ 0 from it: it leaves the line steeply and bends flat within 30 mm.
double flare(double t)
{
    const double slope = std::tan(16 * pi / 180);
    constexpr double at = 22, sharpness = 3.5; // [mm]
    return slope * sharpness * std::log1p(std::exp((at - t) / sharpness));
}

/// The strip beneath the line, at distance t ≥ 0 from it: it falls back inward.
double strip(double t) { return flare(0) - std::tan(10 * pi / 180) * t - t * t / 2500; }

TopoDS_Face patch(const Direction& across, double side)
{
    const Direction around = uniform(12 * pi / 180, 168 * pi / 180, 16, 5);
    return face_of(interpolate(around, across, [side](double angle, double t) {
        const double distance = side > 0 ? t : t * (line_radius(angle) - arch_radius);
        const double r = line_radius(angle) + side * distance;
        const double x = r * std::cos(angle), z = r * std::sin(angle);
        return gp_Pnt(x, crown(x, z) + (side > 0 ? flare(distance) : strip(distance)), z);
    }));
}

} // namespace

TopoDS_Shape wheel_arch()
{
    // Knots stand close together where the panel bends.
    const Direction beyond{{0, 6, 10, 13, 16, 19, 22, 25, 28, 31, 35, 40, 50, 75, 120, 180, 250, panel_width}, 5};
    TopoDS_Face panel = patch(beyond, 1), lower = patch(uniform(0, 1, 2, 5), -1);
    lower.Reverse();
    return shell_of({panel, lower});
}

} // namespace tapeline::models
