// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/python/call.h"

#include "plugin/runner/keywords.h"

#include <nlohmann/json.hpp>

namespace tapeline::python {

Call::Call(py::object progress, py::object cancel, const py::object& threads)
    : progress_(std::move(progress)), cancel_(std::move(cancel))
{
    if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0) {
        raise({ErrorKind::usage, "progress must be a function of a fraction and a stage"});
    }
    if (!cancel_.is_none() && !py::hasattr(cancel_, "is_set")) {
        raise({ErrorKind::usage, "cancel must have a method is_set(), as threading.Event has"});
    }
    Job job;
    value(set_command_keyword(job, "threads", json_of(threads)));
    threads_ = job.command.threads;
}

bool Call::goes_on(double fraction, std::string_view stage) const
{
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
    if (!cancel_.is_none() && py::bool_(cancel_.attr("is_set")())) {
        return false;
    }
    if (progress_.is_none()) {
        return true;
    }
    // None, what a function without return gives, goes on.
    const py::object answer = progress_(fraction, py::str(stage.data(), stage.size()));
    return answer.is_none() || py::bool_(answer);
}

bool Call::report(double fraction, std::string_view stage)
{
    const py::gil_scoped_acquire acquired;
    if (thrown_) {
        return false;
    }
    try {
        return goes_on(fraction, stage);
    } catch (py::error_already_set& error) {
        thrown_.emplace(std::move(error));
        return false;
    }
}

} // namespace tapeline::python
