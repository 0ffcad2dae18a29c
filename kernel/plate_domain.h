// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/orthotropic.h"

#include <vector>

namespace tapeline {

/// x -> R x + shift.
struct FittedMotion {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Vec3 shift = Vec3::Zero();
    bool still = true; ///< none, to the bit
};

/// The rigid motion that takes vertices of `V` to `targets` (a row each) as well as can be; only the listed entries of
/// both count. Still, to the bit, where they all stay.
FittedMotion fitted_motion(const Positions& V, const std::vector<int>& vertices, const Positions& targets,
                           const std::vector<int>& entries);

/// What a plate is described over: the rest mesh, moved to `start` and stretched from there so that the listed vertices
/// (without repeats, one on each connected part) come to `places`, by the harmonic extension of what they still have to
/// go. `start` itself, to the bit, where nothing is to be stretched or a triangle would keep less than a thousandth of its
/// area.
Positions stretched_domain(const Mesh& rest, const Positions& start, const std::vector<int>& vertices,
                           const Positions& places, const Material& material);

/// The plate's way from its line (vertex chain; may be empty) to where it is held [mm]: its area over the line's length,
/// but not more than the root of its area.
double plate_width(const Mesh& mesh, const std::vector<int>& line, bool closed);

} // namespace tapeline
