// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/cli/console.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <unistd.h>

namespace tapeline {

namespace {

// A signal handler can reach nothing but a global.
std::atomic<bool> interrupted{false};

extern "C" void on_interrupt(int)
{
    if (interrupted.exchange(true)) {
        _exit(exit_code(ErrorKind::cancelled));
    }
}

} // namespace

void watch_for_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

Console::Console(const CommandSettings& settings)
    : log_(std::make_shared<spdlog::logger>("tapeline", std::make_shared<spdlog::sinks::stderr_color_sink_st>()))
{
    log_->set_pattern("%n: %^%l%$: %v");
    log_->set_level(settings.quiet ? spdlog::level::err : spdlog::level::info);
    json_ = settings.progress == "json";
    bar_ = settings.progress == "bar" || (settings.progress == "auto" && !settings.quiet && isatty(STDERR_FILENO) == 1);
}

Console::~Console() { clear_bar(); }

Progress Console::progress()
{
    return Progress([this](double fraction, std::string_view stage) {
        show(fraction, stage);
        return !interrupted.load();
    });
}

void Console::show(double fraction, std::string_view stage)
{
    std::string line;
    if (json_) {
        line = nlohmann::ordered_json{{"fraction", fraction}, {"stage", stage}}.dump() + "\n";
    } else if (bar_) {
        constexpr int width = 32;
        const int filled = std::clamp(static_cast<int>(fraction * width), 0, width);
        line = fmt::format("\r\033[K[{}{}] {:3.0f} % {}", std::string(filled, '='), std::string(width - filled, ' '),
                           100 * fraction, stage);
        bar_shown_ = true;
    }
    if (!line.empty() && line != last_shown_) {
        std::fputs(line.c_str(), stderr);
        std::fflush(stderr);
        last_shown_ = line;
    }
}

void Console::clear_bar()
{
    if (bar_shown_) {
        std::fputs("\r\033[K", stderr);
        std::fflush(stderr);
        bar_shown_ = false;
        last_shown_.clear();
    }
}

void Console::print(std::string_view result)
{
    clear_bar();
    std::fwrite(result.data(), 1, result.size(), stdout);
    std::fflush(stdout);
}

void Console::warn(const std::vector<std::string>& warnings)
{
    clear_bar();
    for (const std::string& warning : warnings) {
        log_->warn("{}", warning);
    }
}

int Console::fail(const Error& error)
{
    clear_bar();
    log_->error("{}", error.message);
    return exit_code(error.kind);
}

} // namespace tapeline
