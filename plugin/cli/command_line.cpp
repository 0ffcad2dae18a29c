// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/cli/command_line.h"

#include "kernel/spelling.h"
#include "plugin/runner/job_file.h"
#include "plugin/runner/option_value.h"
#include "plugin/runner/runner.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr std::array<CommandInfo, 7> commands = {
    {{mesh_command, "mesh", "Read a model, report what was found, and write its triangles.",
      "tapeline mesh hood.step --linear-deflection 0.05 -o hood.obj"},
     {lines_command, "lines", "Find the model's feature lines and number them, longest first.",
      "tapeline lines hood.step --crease-angle 8 --json lines.json --picture lines.png"},
     {target_command, "target", "Make a target line from a feature line: fit, edit, slide, fair, drop onto the model.",
      "tapeline target hood.step --line 0 --slide 0,60,0 -o target.json"},
     {move_command, "move", "Move a feature line to its target and let the surface follow.",
      "tapeline move hood.step --line 0 --target target.json -o moved.obj --stats stats.json"},
     {check_command, "check", "Measure a moved mesh against the model before the move.",
      "tapeline check moved.obj --against rest.obj --stats stats.json --target target.json --max-bulge 0.1"},
     {run_command, "run", "Run a job file, from the model to all its outputs.", "tapeline run hood.json"},
     {compare_command, "compare", "Run every method on one job and show them side by side in one HTML page.",
      "tapeline compare hood.json -o hood_methods --methods asan-fl,asan-fl-paper,arap"}}};

/// Names of all flags that a command takes.
std::vector<std::string> flags_of(Command command)
{
    std::vector<std::string> flags = {"--help"};
    for (const Option& option : option_table()) {
        if ((option.commands & command) != 0 && !option.operand) {
            flags.push_back(option.flag());
        }
    }
    return flags;
}

Answer usage_error(const std::string& where, const std::string& problem)
{
    return {fmt::format("{}: error: {}; see {} --help\n", where, problem, where), exit_code(ErrorKind::usage)};
}

/// Feeds the settings of one invocation from CLI11's options.
class Parser {
public:
    Parser()
    {
        app_.set_help_flag("-h,--help");
        app_.set_version_flag("--version", fmt::format("tapeline {}", version()));
        app_.require_subcommand(0, 1);
        app_.add_subcommand("schema")->callback([this] { schema_ = true; });
        for (const Option& option : option_table()) {
            if (option.commands == all_commands) {
                add(app_, option);
            }
        }
        for (const CommandInfo& info : commands) {
            CLI::App* sub = app_.add_subcommand(std::string(info.name));
            sub->set_help_flag("-h,--help");
            for (const Option& option : option_table()) {
                if ((option.commands & info.command) != 0) {
                    const bool required = (option.required & info.command) != 0;
                    add(*sub, option)->required(required);
                }
            }
        }
    }

    std::variant<Invocation, Answer> parse(int argc, const char* const* argv)
    {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            const CommandInfo* info = chosen();
            return Answer{info != nullptr ? command_help(*info) : program_help(), 0};
        } catch (const CLI::CallForVersion&) {
            return Answer{fmt::format("tapeline {}\n", version()), 0};
        } catch (const CLI::ExtrasError&) {
            return explain_extra();
        } catch (const CLI::ParseError& error) {
            return usage_error(place(), error.what());
        }
        if (!problem_.empty()) {
            return usage_error(place(), problem_);
        }
        if (schema_) {
            return Answer{job_schema(), 0};
        }
        const CommandInfo* info = chosen();
        if (info == nullptr) {
            return Answer{program_help(), exit_code(ErrorKind::usage)};
        }
        invocation_.command = info->command;
        return std::move(invocation_);
    }

private:
    CLI::Option* add(CLI::App& app, const Option& option)
    {
        const auto set = [this, &option](const std::vector<std::string>& texts) {
            const std::string where = option.operand ? std::string(option.name) : option.flag();
            const auto done = set_option_from_text(option, invocation_.job, texts, where);
            if (!done && problem_.empty()) {
                problem_ = done.error().message;
            }
            return true;
        };
        const std::string name = option.operand          ? std::string(option.name)
                                 : option.letter.empty() ? option.flag()
                                                         : fmt::format("-{},{}", option.letter, option.flag());
        const OptionSlot slot = option.slot(invocation_.job);
        if (std::holds_alternative<bool*>(slot)) {
            return app.add_flag_callback(name, [set] { set({}); });
        }
        CLI::Option* added = app.add_option(name, CLI::callback_t(set));
        if (std::holds_alternative<std::vector<std::filesystem::path>*>(slot) ||
            std::holds_alternative<std::vector<std::string>*>(slot) ||
            std::holds_alternative<std::vector<LineSelector>*>(slot)) {
            added->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);
        }
        return added;
    }

    const CommandInfo* chosen() const
    {
        for (const CommandInfo& info : commands) {
            if (app_.got_subcommand(std::string(info.name))) {
                return &info;
            }
        }
        return nullptr;
    }

    std::string place() const
    {
        const CommandInfo* info = chosen();
        return info == nullptr ? "tapeline" : fmt::format("tapeline {}", info->name);
    }

    Answer explain_extra() const
    {
        const CommandInfo* info = chosen();
        const std::vector<std::string> extras =
            info != nullptr ? app_.get_subcommand(std::string(info->name))->remaining() : app_.remaining();
        const std::string extra = extras.empty() ? "" : extras.front();
        if (info != nullptr && extra.starts_with("-")) {
            return usage_error(place(), fmt::format("option {} is unknown; did you mean {}?", extra,
                                                    nearest_word(extra, flags_of(info->command))));
        }
        if (info != nullptr) {
            return usage_error(place(), fmt::format("argument {} is one too many", extra));
        }
        std::vector<std::string> names;
        for (const CommandInfo& known : commands) {
            names.emplace_back(known.name);
        }
        return usage_error(place(),
                           fmt::format("command {} is unknown; did you mean {}?", extra, nearest_word(extra, names)));
    }

    CLI::App app_;
    Invocation invocation_;
    std::string problem_;
    bool schema_ = false;
};

} // namespace

std::span<const CommandInfo> command_table() { return commands; }

std::variant<Invocation, Answer> read_command_line(int argc, const char* const* argv)
{
    return Parser().parse(argc, argv);
}

} // namespace tapeline
