// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "plugin/runner/options.h"

#include <nlohmann/json.hpp>

namespace tapeline {

/// Sets an option from a JSON value after checking its type, range and choices. Fails (usage) with one sentence that
/// begins with `where`, e.g. "job.json: key 'remesh.max_edge'".
Result<void> set_option(const Option& option, Job& job, const nlohmann::json& value, const std::string& where);

/// Sets an option from the texts given on a command line: numbers are parsed, lists split at commas. A boolean takes
/// no text, "true" or "false".
Result<void> set_option_from_text(const Option& option, Job& job, const std::vector<std::string>& texts,
                                  const std::string& where);

/// The option's value in a job as JSON; null where there is none.
nlohmann::json option_json(const Option& option, const Job& job);

/// The option's value in a default-constructed Job.
nlohmann::json option_default(const Option& option);

/// What kind of value the option takes, for messages: "a number in mm", "one of auto, on, off".
std::string kind_text(const Option& option);

/// Help in one line: the sentence, then unit, range and default in brackets.
std::string help_text(const Option& option);

} // namespace tapeline
