// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace tapeline {

enum class ChildEnd {
    finished,
    crashed,    ///< ended by a signal or an exit code
    timed_out,  ///< ended by us after the time limit
    not_started ///< the system gives no further process
};

struct ChildOutput {
    ChildEnd end = ChildEnd::not_started;
    std::string bytes; ///< what `work` returned; only when finished
};

/// Runs `work` in a copy of this process and returns its bytes, so that a crash in there, whatever the library, costs
/// no more than an answer. What the copy prints goes nowhere; nothing else of it comes back. `work` must not need other
/// threads of this process.
ChildOutput run_in_child(const std::function<std::string()>& work, int limit_seconds);

} // namespace tapeline
