// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "plugin/runner/options.h"

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>

namespace tapeline {

/// Sets options of a job from keyword arguments: an object of job keys without their sections. Only keys of the given
/// sections are taken, and none that names the model, the line or the target, which other faces pass as objects.
/// A null leaves the default. Fails (usage) on an unknown key, naming the nearest known one, and on a value that the
/// option table does not allow.
/// `commands`: only keys that one of these commands takes.
Result<void> set_keywords(Job& job, const nlohmann::json& keywords, std::initializer_list<std::string_view> sections,
                          unsigned commands = all_commands);

/// Sets an option of section command from a keyword argument that a call has by itself, such as `threads`; a null
/// leaves the default.
Result<void> set_command_keyword(Job& job, std::string_view name, const nlohmann::json& value);

/// The option table as data, in its order: per option `name`, `section`, `type`, `default`, `minimum`, `maximum`,
/// `choices`, `unit`, `help`, `zero` (what 0 means), `count`, `file` and `commands`; null where there is none.
nlohmann::ordered_json options_json();

} // namespace tapeline
