// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vertex_welder.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace tapeline {

namespace {

/// Finaliser of MurmurHash3: every input bit changes every output bit with probability near one half.
std::uint64_t mix(std::uint64_t h)
{
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 33;
    h *= 0xc4ceb9fe1a85ec53ULL;
    return h ^ (h >> 33);
}

std::uint64_t hash(const Vec3& p)
{
    std::uint64_t h = 0x9e3779b97f4a7c15ULL;
    for (int axis = 0; axis < 3; ++axis) {
        h = mix(h ^ std::bit_cast<std::uint64_t>(p[axis])) + 0x9e3779b97f4a7c15ULL;
    }
    return h;
}

} // namespace

VertexWelder::VertexWelder(std::size_t expected_points) : slots_(std::bit_ceil(2 * expected_points + 1024), -1)
{
    points_.reserve(expected_points);
}

std::size_t VertexWelder::slot_of(const Vec3& point) const
{
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(point) & mask;
    while (slots_[slot] >= 0 && points_[slots_[slot]] != point) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

void VertexWelder::grow()
{
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        slots_[slot_of(points_[i])] = static_cast<int>(i);
    }
}

int VertexWelder::index_of(const Vec3& point)
{
    if (2 * points_.size() >= slots_.size()) {
        grow();
    }
    const Vec3 p = point.array() + 0.0; // -0 + 0 is +0
    const std::size_t slot = slot_of(p);
    if (slots_[slot] < 0) {
        if (points_.size() == static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            throw std::length_error("more than 2147483647 vertices");
        }
        slots_[slot] = static_cast<int>(points_.size());
        points_.push_back(p);
    }
    return slots_[slot];
}

} // namespace tapeline
