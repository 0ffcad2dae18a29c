// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace tapeline {

/// How many threads the caller may use: the process's limit, or less inside `on_threads`.
inline int allowed_threads()
{
    const auto limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return std::min(static_cast<int>(limit), tbb::this_task_arena::max_concurrency());
}

/// Runs a step on at most `threads` threads, the calling one among them; 0 = as many as there are. Unlike the process's
/// limit this one holds for the step alone, so that calls side by side can have different ones.
template <class Step>
auto on_threads(int threads, const Step& step)
{
    if (threads <= 0) {
        return step();
    }
    // TBB complains of a wish beyond the process's limit.
    tbb::task_arena arena(std::min(threads, allowed_threads()));
    return arena.execute(step);
}

} // namespace tapeline
