// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace tapeline {

/// Measures consecutive stages [s].
class Stopwatch {
public:
    /// Ends a stage that began when the one before ended (or at construction); equal names add up.
    void lap(const std::string& stage)
    {
        const auto now = std::chrono::steady_clock::now();
        add(stage, std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }
    /// Books time that was measured elsewhere.
    void add(const std::string& stage, double seconds)
    {
        for (auto& [name, sum] : seconds_) {
            if (name == stage) {
                sum += seconds;
                return;
            }
        }
        seconds_.emplace_back(stage, seconds);
    }
    /// Forgets the time since the last stage (it was booked by `add`).
    void restart() { last_ = std::chrono::steady_clock::now(); }

    const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::vector<std::pair<std::string, double>> seconds_;
};

} // namespace tapeline
