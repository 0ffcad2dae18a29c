// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/line_tangents.h"

namespace tapeline {

std::pair<size_t, size_t> line_neighbours(size_t i, size_t n, bool closed)
{
    return {i > 0 ? i - 1 : (closed ? n - 1 : 0), i + 1 < n ? i + 1 : (closed ? 0 : n - 1)};
}

std::vector<Vec3> line_tangents(const std::vector<Vec3>& points, bool closed)
{
    std::vector<Vec3> result;
    for (size_t i = 0; i < points.size(); ++i) {
        const auto [before, after] = line_neighbours(i, points.size(), closed);
        result.push_back((points[after] - points[before]).normalized());
    }
    return result;
}

double line_length(const Positions& V, const std::vector<int>& line, bool closed)
{
    double length = 0;
    for (size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
        length += (V.row(line[(i + 1) % line.size()]) - V.row(line[i])).norm();
    }
    return length;
}

} // namespace tapeline
