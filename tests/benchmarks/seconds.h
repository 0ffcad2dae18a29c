// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace tapeline::testing {

/// Wall time that `work()` takes [s].
double seconds_of(const auto& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace tapeline::testing
