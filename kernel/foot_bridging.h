// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>
#include <vector>

namespace tapeline {

/// Stations of a row of points on a curve: arc lengths that should grow from point to point. The first and last count
/// as given.
struct StationRow {
    std::vector<double> station; ///< on the curve [mm]
    std::vector<double> along;   ///< on the polyline, strictly growing [mm]
    std::vector<bool> bad;       ///< the station is not known
};

/// Replaces stations that are unknown, run backwards or are very unevenly spread: each such stretch is widened
/// until its average spread is between 0.6 and 1.6 times the whole row's, then its inner points are spread in
/// proportion to `along`. Returns per point whether its station was replaced; or, when more than half of the row would
/// be replaced, the point where the first bad stretch begins.
tl::expected<std::vector<bool>, int> bridge(StationRow& row);

/// Index of the entry that is farthest, round the cycle, from every true entry; 0 when none is true.
int farthest_from(const std::vector<bool>& bad);

} // namespace tapeline
