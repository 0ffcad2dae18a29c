// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/segment.h"

#include <algorithm>

namespace tapeline {

double share_of_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 step = b - a;
    const double squared = step.squaredNorm();
    return squared > 0 ? std::clamp(step.dot(p - a) / squared, 0.0, 1.0) : 0;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    return (p - a - share_of_segment(p, a, b) * (b - a)).norm();
}

} // namespace tapeline
