// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace tapeline::testing {

/// Makes the line, or ends the test with the error's sentence.
inline TargetLine line_of(const BSplineData& data)
{
    auto line = TargetLine::from_data(data);
    if (!line) {
        throw std::runtime_error(line.error().message);
    }
    return *line;
}

/// A cubic with eight control points, unevenly spaced knots and torsion; about 60 mm long.
inline BSplineData data_of_spatial_cubic()
{
    return {3,
            {0, 0, 0, 0, 0.15, 0.3, 0.65, 0.8, 1, 1, 1, 1},
            {},
            {Vec3(0, 0, 0), Vec3(5, 8, 1), Vec3(12, 9, -3), Vec3(20, -4, 2), Vec3(26, -8, 6), Vec3(33, 5, 4),
             Vec3(41, 9, 0), Vec3(46, 2, -2)},
            false};
}

/// A full circle about the z direction, exact (rational quadratic), counter-clockwise from (+radius, 0).
inline TargetLine circle(const Vec3& centre, double radius)
{
    BSplineData data{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {}, {}, true};
    const double corners[9][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int i = 0; i < 9; ++i) {
        data.control_points.push_back(centre + radius * Vec3(corners[i][0], corners[i][1], 0));
        data.weights.push_back(i % 2 == 0 ? 1 : std::sqrt(0.5));
    }
    return line_of(data);
}

inline TargetLine straight(const Vec3& a, const Vec3& b) { return line_of({1, {0, 0, 1, 1}, {}, {a, b}, false}); }

} // namespace tapeline::testing
