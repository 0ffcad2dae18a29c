// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace tapeline {

/// Calls body(i) for i in [0, n) on the threads that the caller's arena has (tbb::global_control limits them).
/// Each i must write only its own output, so results do not depend on the number of threads.
template <class Body>
void parallel_for(int n, const Body& body, int grain = 256)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, n, grain), [&](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i != range.end(); ++i) {
            body(i);
        }
    });
}

} // namespace tapeline
