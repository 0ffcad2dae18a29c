// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <cstddef>
#include <vector>

namespace tapeline {

/// Gives equal points one index, in the order of their first appearance. Equal means the same three doubles; -0 and
/// +0 are the same. Open addressing on one flat table; linear time.
class VertexWelder {
public:
    /// expected_points: a guess that saves time and need not be right.
    explicit VertexWelder(std::size_t expected_points = 0);

    /// Index of the point, new or known. Coordinates must be finite; throws std::length_error beyond 2^31 - 1 points.
    int index_of(const Vec3& point);

    std::size_t size() const { return points_.size(); }
    std::vector<Vec3> take_points() { return std::move(points_); }

private:
    void grow();
    std::size_t slot_of(const Vec3& point) const;

    std::vector<Vec3> points_;
    std::vector<int> slots_; ///< index into points_, -1 = free; the size is a power of two
};

} // namespace tapeline
