// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tapeline {

/// Number of single-letter insertions, removals, replacements and swaps of neighbours that turn a into b.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate spelled most like `word` (the first of equals); empty when there are none.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

} // namespace tapeline
