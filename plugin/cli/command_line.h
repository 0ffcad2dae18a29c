// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/options.h"

#include <string>
#include <variant>

namespace tapeline {

/// One of the program's commands.
struct CommandInfo {
    Command command;
    std::string_view name;
    std::string_view help;    ///< one sentence
    std::string_view example; ///< a whole command line
};
std::span<const CommandInfo> command_table();

/// What a command line asks for: a command with its settings.
struct Invocation {
    Command command = run_command;
    Job job;
};

/// A text to print instead, and the exit code: help, version, schema on standard output with 0, a usage error with 1.
struct Answer {
    std::string text;
    int exit_code = 0;
};

/// Reads the command line (CLI11 on the option table).
std::variant<Invocation, Answer> read_command_line(int argc, const char* const* argv);

/// Help of one command: its operands and options by section, with units, ranges and defaults, and an example.
std::string command_help(const CommandInfo& info);
/// Help of the program: its commands, exit codes and an example.
std::string program_help();

} // namespace tapeline
