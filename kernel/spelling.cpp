// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/spelling.h"

#include <algorithm>
#include <limits>

namespace tapeline {

int edit_distance(std::string_view a, std::string_view b)
{
    const std::size_t columns = b.size() + 1;
    std::vector<int> table((a.size() + 1) * columns);
    const auto d = [&](std::size_t i, std::size_t j) -> int& { return table[i * columns + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d(i, j) = static_cast<int>(i + j);
                continue;
            }
            const bool same = a[i - 1] == b[j - 1];
            d(i, j) = std::min({d(i - 1, j) + 1, d(i, j - 1) + 1, d(i - 1, j - 1) + (same ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d(i, j) = std::min(d(i, j), d(i - 2, j - 2) + 1);
            }
        }
    }
    return d(a.size(), b.size());
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates)
{
    // Words of any length come from files: a long one cannot be near anything, and must not cost memory.
    word = word.substr(0, 64);
    std::string nearest;
    int least = std::numeric_limits<int>::max();
    for (const std::string& candidate : candidates) {
        const int distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

} // namespace tapeline
