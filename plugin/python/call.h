// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/progress.h"
#include "plugin/python/values.h"
#include "plugin/runner/guard.h"
#include "plugin/runner/threads.h"

#include <optional>
#include <utility>

namespace tapeline::python {

/// One long call into Tapeline: runs it without the GIL, takes the GIL back for each progress report, there lets a
/// signal (Ctrl-C) through, asks `cancel.is_set()` and calls `progress(fraction, stage)`, whose False cancels. An
/// exception that the callback throws ends the call and goes on to the caller. `threads` limits the call alone, checked
/// as the flag of that name; 0 = as many as there are.
class Call {
public:
    Call(py::object progress, py::object cancel, const py::object& threads);

    /// Runs `step(const Progress&) -> Result<T>` and gives its value.
    template <class Step>
    auto run(const Step& step)
    {
        auto result = [&] {
            const py::gil_scoped_release released;
            return on_threads(threads_, [&] {
                return guarded(
                    [&] { return step(Progress([this](double f, std::string_view s) { return report(f, s); })); });
            });
        }();
        if (thrown_) {
            throw py::error_already_set(std::move(*thrown_));
        }
        return value(std::move(result));
    }

private:
    bool report(double fraction, std::string_view stage);
    bool goes_on(double fraction, std::string_view stage) const;

    py::object progress_, cancel_;
    int threads_ = 0;
    std::optional<py::error_already_set> thrown_;
};

/// The same without progress and cancellation.
template <class Step>
auto without_gil(const Step& step)
{
    return Call(py::none(), py::none(), py::none()).run([&](const Progress&) { return step(); });
}

} // namespace tapeline::python
