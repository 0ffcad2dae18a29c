// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/segment.h"

#include <algorithm>

namespace tapeline {

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 step = b - a;
    const double t = step.squaredNorm() > 0 ? std::clamp(step.dot(p - a) / step.squaredNorm(), 0.0, 1.0) : 0;
    return (p - a - t * step).norm();
}

} // namespace tapeline
