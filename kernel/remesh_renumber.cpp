// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/remesh_renumber.h"

#include <cstddef>

namespace tapeline {

std::vector<int> stable_numbers(const std::vector<int>& old_place, int old_count)
{
    std::vector<char> taken(old_count, 0);
    for (const int place : old_place) {
        if (place >= 0) {
            taken[place] = 1;
        }
    }
    std::vector<int> number(old_place.size());
    int next = 0;
    for (std::size_t i = 0; i < old_place.size(); ++i) {
        if (old_place[i] >= 0) {
            number[i] = old_place[i];
            continue;
        }
        while (next < old_count && taken[next]) {
            ++next;
        }
        number[i] = next++;
    }
    // Free numbers from `next` on remain; those above them move down.
    std::vector<int> shift(old_count, 0);
    int gaps = 0;
    for (int n = 0; n < old_count; ++n) {
        shift[n] = gaps;
        gaps += n >= next && !taken[n] ? 1 : 0;
    }
    for (int& n : number) {
        n -= n < old_count ? shift[n] : 0;
    }
    return number;
}

} // namespace tapeline
