// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "patches.h"

#include <cmath>
#include <numbers>

namespace tapeline::models {

TopoDS_Shape panel()
{
    const auto point = [](double x, double y) {
        return gp_Pnt(x, y, -x * x / 12000 - y * y / 6000 - std::tan(6 * std::numbers::pi / 180) * std::abs(y));
    };
    const double xs[] = {-400, -150, 120, 400}, ys[] = {-300, 0, 300};
    std::vector<TopoDS_Face> faces;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 3; ++i) {
            // Neighbours differ in degree and knots, as patches from different hands do; each is exact.
            const Direction u = uniform(xs[i], xs[i + 1], 2 + (i + j) % 2, 2 + i % 2);
            const Direction v = uniform(ys[j], ys[j + 1], 2 + i % 2, 2 + j);
            faces.push_back(face_of(interpolate(u, v, point)));
        }
    }
    return compound_of(faces);
}

} // namespace tapeline::models
