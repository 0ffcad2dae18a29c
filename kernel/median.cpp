// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/median.h"

#include <algorithm>

namespace tapeline {

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

} // namespace tapeline
