// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/strip.h"

#include <utility>
#include <vector>

namespace tapeline {

/// A bend fitted to a profile: the angle τ of the surface's normal about the line by the distance d from it.
struct BendFit {
    double left = 1;  ///< share of the straight fit's squares that is left
    double width = 0; ///< w [mm]; 0 = there is no bend
    double inner = 0; ///< slope κ of τ up to w [rad/mm]
    double outer = 0; ///< and κ' beyond

    bool found() const { return width > 0; }
};

/// The median of the profiles at each distance; they are equally long and at least one.
std::vector<double> median_profile(const std::vector<std::vector<double>>& profiles);

/// The bend whose fit explains most (see find_strip), with w within that range [mm]; `distances` ascend from 0 to how far
/// the side was looked at [mm], `tau` holds the angle at each [rad]. None is found where the options ask for more.
BendFit best_bend(const std::vector<double>& distances, const std::vector<double>& tau, std::pair<double, double> range,
                  const StripOptions& options);

/// The bend's width at each station along the line [mm]: fitted to the median profile of the station and its neighbours,
/// at most four times wider or narrower than the `whole` line's; taken from the nearest place where there is no such bend
/// with at least half of the whole one's angle; without lone outliers and evened out. Empty where the bend is as wide
/// everywhere, within a quarter, or is not seen at half of the stations.
std::vector<double> widths_along(const std::vector<double>& distances, const std::vector<std::vector<double>>& profiles,
                                 bool closed, const BendFit& whole, const StripOptions& options);

} // namespace tapeline
