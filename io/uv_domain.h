// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tapeline {

/// The trimmed part of a parameter plane, bounded by closed polygons (outer borders and holes, any sense).
class UvDomain {
public:
    using Segment = std::array<Eigen::Vector2d, 2>;

    /// The segments of all polygons in any order; none at all means the whole plane.
    explicit UvDomain(std::vector<Segment> segments = {});

    /// Even-odd rule; a point on a segment may count either way.
    bool contains(const Eigen::Vector2d& uv) const;

private:
    int row_of(double v) const;

    std::vector<Segment> segments_;
    double first_v_ = 0, row_height_ = 1;
    std::vector<std::vector<int>> rows_; ///< per slice of v the segments that reach into it
};

} // namespace tapeline
