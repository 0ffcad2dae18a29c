// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/job.h"

#include <limits>
#include <span>
#include <string_view>
#include <variant>

namespace tapeline {

/// The commands of the program, as bits.
enum Command : unsigned {
    mesh_command = 1,
    lines_command = 2,
    target_command = 4,
    move_command = 8,
    check_command = 16,
    run_command = 32,
    compare_command = 64,
    all_commands = 127
};

/// Where in a Job an option's value lives; the kind of pointer is the option's type.
using OptionSlot = std::variant<bool*, int*, double*, std::optional<double>*, std::string*, std::filesystem::path*,
                                LineSelector*, std::vector<int>*, std::vector<double>*, std::vector<std::string>*,
                                std::vector<std::filesystem::path>*, std::vector<LineSelector>*>;

/// What a path is for.
enum class FileRole { none, input, output };

/// One option. Command-line flags, job keys, the job schema and the keyword arguments of other faces are all made
/// from this one record; its default is what a default-constructed Job holds.
struct Option {
    std::string_view section = {}; ///< of the job file; "" = top level, "command" = not in job files
    std::string_view name = {};    ///< job key; the flag is "--" + name with dashes
    OptionSlot (*slot)(Job&) = nullptr;
    unsigned commands = 0;      ///< which commands take it as a flag (or as their operand)
    std::string_view help = {}; ///< one sentence, without unit, range and default
    std::string_view unit = {}; ///< "mm", "deg" or empty
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::vector<std::string_view> choices = {}; ///< for texts and lists of them: the allowed values; empty = any text
    FileRole file = FileRole::none;
    std::string_view zero = {}; ///< what the value 0 (or an empty one) means, e.g. "automatic"; empty = nothing special
    unsigned required = 0;      ///< commands that cannot do without it
    std::string_view letter = {}; ///< short flag, e.g. "o"
    bool operand = false;         ///< given by position, not by a flag
    int count = 0;                ///< lists: exact number of entries; 0 = any

    bool in_job() const { return section != "command"; }
    /// "section.name", as messages call it.
    std::string path() const;
    /// "--max-edge" for max_edge.
    std::string flag() const;
};

/// All options, in the order in which help and schema show them.
std::span<const Option> option_table();

/// The sections of a job file, each with a sentence.
struct OptionSection {
    std::string_view name;
    std::string_view help;
};
std::span<const OptionSection> option_sections();

} // namespace tapeline
