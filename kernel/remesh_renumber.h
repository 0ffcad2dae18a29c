// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tapeline {

/// New numbers for a list of which some members stay in their old places and others are new.
/// `old_place` has one entry per member: the old number (each at most once), or -1 for a new one. Members with an old
/// number keep it; new ones, in order, take the free numbers below `old_count`, then those from there on. When too few
/// are new to fill the gaps, the gaps are closed in order. Returns the number of each member.
std::vector<int> stable_numbers(const std::vector<int>& old_place, int old_count);

} // namespace tapeline
