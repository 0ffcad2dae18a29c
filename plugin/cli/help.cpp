// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/method.h"
#include "plugin/cli/command_line.h"
#include "plugin/runner/option_value.h"

#include <array>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr std::size_t indent = 28;
constexpr std::size_t width = 100;

/// A label and a text beside it, wrapped.
std::string entry(const std::string& label, const std::string& text)
{
    std::string out = "  " + label;
    if (out.size() + 2 > indent) {
        out += "\n" + std::string(indent, ' ');
    } else {
        out.resize(indent, ' ');
    }
    std::size_t column = indent;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find(' ', from), text.size());
        const std::string word = text.substr(from, to - from);
        if (column > indent && column + 1 + word.size() > width) {
            out += "\n" + std::string(indent, ' ');
            column = indent;
        }
        out += (column > indent ? " " : "") + word;
        column += word.size() + (column > indent ? 1 : 0);
        from = to + 1;
    }
    return out + "\n";
}

/// What stands for the value in the help, e.g. "MM", "FILE".
struct Placeholder {
    const Option& option;
    std::string unit(const char* other) const
    {
        return option.unit == "mm" ? "MM" : option.unit == "deg" ? "DEG" : other;
    }
    std::string operator()(const bool*) const { return ""; }
    std::string operator()(const int*) const { return unit("N"); }
    std::string operator()(const double*) const { return unit("X"); }
    std::string operator()(const std::optional<double>*) const { return unit("X"); }
    std::string operator()(const std::string*) const { return "WORD"; }
    std::string operator()(const std::vector<std::string>*) const { return "WORD,..."; }
    std::string operator()(const std::filesystem::path*) const
    {
        const bool folder = option.name == "pictures" || option.commands == compare_command;
        return folder ? "DIR" : "FILE";
    }
    std::string operator()(const LineSelector*) const { return "LINE"; }
    std::string operator()(const std::vector<int>*) const { return unit("N") + ",..."; }
    std::string operator()(const std::vector<double>*) const { return unit("X") + ",..."; }
    std::string operator()(const std::vector<std::filesystem::path>*) const { return "FILE"; }
    std::string operator()(const std::vector<LineSelector>*) const { return "LINE,..."; }
};

std::string placeholder(const Option& option)
{
    Job job;
    return std::visit(Placeholder{option}, option.slot(job));
}

std::string operand_name(const Option& option) { return option.name == "job" ? "JOB.json" : "IN"; }

std::string label(const Option& option)
{
    if (option.operand) {
        return operand_name(option);
    }
    const std::string value = placeholder(option);
    const std::string letter = option.letter.empty() ? "" : fmt::format("-{}, ", option.letter);
    return letter + option.flag() + (value.empty() ? "" : " " + value);
}

std::string section_options(Command command, std::string_view section)
{
    std::string text;
    for (const Option& option : option_table()) {
        if (option.section == section && (option.commands & command) != 0) {
            const bool required = (option.required & command) != 0 && !option.operand;
            text += entry(label(option), (required ? "Required. " : "") + help_text(option));
        }
    }
    return text;
}

std::string usage_line(const CommandInfo& info)
{
    std::string line = fmt::format("tapeline {}", info.name);
    for (const Option& option : option_table()) {
        if ((option.required & info.command) != 0) {
            line += " " + (option.operand          ? operand_name(option)
                           : option.letter.empty() ? option.flag() + " " + placeholder(option)
                                                   : fmt::format("-{} {}", option.letter, placeholder(option)));
        }
    }
    return line + " [options]";
}

/// The methods by name, for commands that deform.
std::string methods_section(Command command)
{
    const auto names_method = [&](const Option& o) { return o.name == "method" && (o.commands & command) != 0; };
    if (std::ranges::none_of(option_table(), names_method)) {
        return "";
    }
    std::string text = "\nMethods\n";
    for (const MethodInfo& info : method_table()) {
        text += entry(std::string(info.name), std::string(info.title) + ".");
    }
    return text;
}

} // namespace

std::string command_help(const CommandInfo& info)
{
    std::string text = fmt::format("{}\n\nUsage: {}\n", info.help, usage_line(info));
    text += section_options(info.command, "");
    for (const OptionSection& section : option_sections()) {
        const std::string options = section_options(info.command, section.name);
        if (!options.empty()) {
            text += fmt::format("\n{}\n{}", section.help, options);
        }
    }
    text += methods_section(info.command);
    text += fmt::format("\nThis command\n{}", section_options(info.command, "command"));
    text += entry("-h, --help", "This text.");
    return text + fmt::format("\nExample:\n  {}\n", info.example);
}

std::string program_help()
{
    std::string text = "Tapeline moves feature lines of styled surfaces without a bulge.\n\n"
                       "Usage: tapeline COMMAND ...\n\nCommands (each has its own --help):\n";
    for (const CommandInfo& info : command_table()) {
        text += entry(std::string(info.name), std::string(info.help));
    }
    text += "\nOptions of all commands:\n" + section_options(static_cast<Command>(0x8000), "");
    for (const Option& option : option_table()) {
        if (option.commands == all_commands) {
            text += entry(label(option), help_text(option));
        }
    }
    text += entry("-h, --help", "This text.") + entry("--version", "The program's version.");
    return text + "\nExit codes: 0 done, 1 wrong usage, 2 a file cannot be read or written, 3 the input was rejected,\n"
                  "4 the solver did not converge or the result is ambiguous, 5 a quality gate failed, 130 cancelled.\n"
                  "\nExample:\n  tapeline lines hood.step\n"
                  "  tapeline move hood.step --line 0 --slide 0,60,0 -o moved.obj --pictures pictures\n";
}

} // namespace tapeline
