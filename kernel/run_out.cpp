// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/run_out.h"

#include "kernel/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tapeline {

namespace {

/// Where an edge of the prolonged line lies, seen from the nearer end of the used part that has a prolongation.
struct Station {
    double way =
        -std::numeric_limits<double>::infinity(); ///< of its middle beyond that end, along the line at rest [mm]
    bool after = false;                           ///< whether that is the last end
};

std::vector<Station> stations(const ExtendedLine& line)
{
    const int n = static_cast<int>(line.vertices.size()), edges = line.closed ? n : n - 1;
    std::vector<Station> stations(edges);
    const auto place = [&](int k) -> Vec3 { return line.model.mesh.V.row(line.vertices[k % n]); };
    // From an end over the edges beyond it, or over the used ones.
    const auto walk = [&](bool beyond, bool after) {
        const int step = beyond == after ? 1 : -1;
        double s = 0;
        for (int k = 0, e = (after ? line.last : line.first) - (step < 0 ? 1 : 0); k < edges; ++k, e += step) {
            const int i = line.closed ? (e % n + n) % n : e;
            if (i < 0 || i >= edges || (i >= line.first && i < line.last) == beyond) {
                break;
            }
            const double length = (place(i + 1) - place(i)).norm(), way = (beyond ? 1 : -1) * (s + length / 2);
            if (std::abs(way) < std::abs(stations[i].way)) {
                stations[i] = {way, after};
            }
            s += length;
        }
    };
    for (const bool after : {true, false}) {
        if (line.closed || (after ? line.last < edges : line.first > 0)) {
            walk(true, after);
            walk(false, after);
        }
    }
    return stations;
}

/// How far the end of the used line moves sideways [mm].
double sideways(const ExtendedLine& line, bool after)
{
    const int end = after ? line.last : line.first, next = after ? line.last - 1 : line.first + 1;
    const Vec3 at = line.model.mesh.V.row(line.vertices[end]);
    const Vec3 along = (at - Vec3(line.model.mesh.V.row(line.vertices[next]))).normalized();
    return (line.targets[end] - at).cross(along).norm();
}

} // namespace

std::vector<RunOut> run_out(const ExtendedLine& line, const std::vector<double>& angles, double sharp)
{
    const std::vector<Station> at = stations(line);
    const std::array<double, 2> moved{sideways(line, false), sideways(line, true)};
    std::vector<RunOut> result(at.size());
    for (size_t i = 0; i < at.size(); ++i) {
        const double share = sharp > 0 ? std::min(1.0, std::abs(angles[i]) / sharp) : 0;
        const double length = share * moved[at[i].after ? 1 : 0];
        result[i].after = at[i].after;
        if (at[i].way >= length) {
            result[i].left = 0;
        } else if (at[i].way > -length) {
            result[i].left = 1 - smooth_step(at[i].way, -length, length);
        }
    }
    return result;
}

} // namespace tapeline
