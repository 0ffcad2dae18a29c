// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "patches.h"

#include <cmath>
#include <numbers>

namespace tapeline::models {

namespace {

constexpr double left = -500, right = 500, bottom = -300, top = 300, seam = 60;

double slope(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

/// Height of the upper line, bent like a bow.
double upper(double x) { return 130 + x * x / 9000; }

} // namespace

TopoDS_Shape door()
{
    // The folds add up: z falls away from the shoulder (y = 0), from the upper line, and from the seam (x = 60).
    const auto surface = [](double x, double y) {
        return gp_Pnt(x, y,
                      -x * x / 8000 - y * y / 5000 - slope(7) * std::abs(y) - slope(6) * std::abs(y - upper(x)) -
                          slope(6) * std::abs(x - seam));
    };
    const Direction columns[] = {uniform(left, seam, 5, 3), uniform(seam, right, 4, 3)};
    const Direction lower = uniform(bottom, 0, 3, 3), middle = uniform(0, 1, 2, 3), above = uniform(0, 1, 2, 3);
    std::vector<TopoDS_Face> faces;
    for (const Direction& u : columns) {
        faces.push_back(face_of(interpolate(u, lower, surface)));
        faces.push_back(
            face_of(interpolate(u, middle, [&](double x, double share) { return surface(x, share * upper(x)); })));
        faces.push_back(face_of(interpolate(
            u, above, [&](double x, double share) { return surface(x, upper(x) + share * (top - upper(x))); })));
    }
    return shell_of(faces);
}

} // namespace tapeline::models
