// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/progress.h"
#include "plugin/runner/job.h"

#include <memory>
#include <spdlog/logger.h>
#include <string>
#include <string_view>
#include <vector>

namespace tapeline {

/// The program's voice: results on standard output, everything else on standard error.
class Console {
public:
    explicit Console(const CommandSettings& settings);
    ~Console();

    /// Shows progress as the settings ask, and cancels once the user has interrupted the program.
    Progress progress();

    void print(std::string_view result);
    void warn(const std::vector<std::string>& warnings);
    /// Logs the failure and gives its exit code.
    int fail(const Error& error);

private:
    void show(double fraction, std::string_view stage);
    void clear_bar();

    std::shared_ptr<spdlog::logger> log_;
    bool bar_ = false;
    bool json_ = false;
    bool bar_shown_ = false;
    std::string last_shown_;
};

/// From here on an interrupt (SIGINT, SIGTERM) asks for cancellation; a second one ends the program at once.
void watch_for_interrupts();

} // namespace tapeline
