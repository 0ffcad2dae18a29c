// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

namespace tapeline {

/// Where on the straight line from a (0) to b (1) the point nearest to p is; 0 where the two are the same.
double share_of_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Distance of p to the straight line from a to b, its ends included [mm]; to a where the two are the same.
double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b);

} // namespace tapeline
