// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/keywords.h"

#include "kernel/spelling.h"
#include "plugin/runner/option_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Given as objects, or of no use to a call.
bool is_keyword(const Option& option)
{
    constexpr std::array<std::string_view, 4> others = {"description", "input", "lines.line", "target.target"};
    return option.in_job() && std::ranges::find(others, option.path()) == others.end();
}

struct TypeName {
    const char* operator()(const bool*) const { return "bool"; }
    const char* operator()(const int*) const { return "int"; }
    const char* operator()(const double*) const { return "float"; }
    const char* operator()(const std::optional<double>*) const { return "float | None"; }
    const char* operator()(const std::string*) const { return "str"; }
    const char* operator()(const std::filesystem::path*) const { return "path"; }
    const char* operator()(const LineSelector*) const { return "line"; }
    const char* operator()(const std::vector<int>*) const { return "list[int]"; }
    const char* operator()(const std::vector<double>*) const { return "list[float]"; }
    const char* operator()(const std::vector<std::string>*) const { return "list[str]"; }
    const char* operator()(const std::vector<std::filesystem::path>*) const { return "list[path]"; }
    const char* operator()(const std::vector<LineSelector>*) const { return "list[line]"; }
};

ordered_json bound(double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); }

ordered_json text(std::string_view s) { return s.empty() ? ordered_json(nullptr) : ordered_json(s); }

ordered_json command_names(unsigned commands)
{
    constexpr std::array<std::pair<unsigned, const char*>, 7> names = {{{mesh_command, "mesh"},
                                                                        {lines_command, "lines"},
                                                                        {target_command, "target"},
                                                                        {move_command, "move"},
                                                                        {check_command, "check"},
                                                                        {run_command, "run"},
                                                                        {compare_command, "compare"}}};
    ordered_json list = ordered_json::array();
    for (const auto& [bit, name] : names) {
        if ((commands & bit) != 0) {
            list.push_back(name);
        }
    }
    return list;
}

} // namespace

Result<void> set_keywords(Job& job, const json& keywords, std::initializer_list<std::string_view> sections,
                          unsigned commands)
{
    std::vector<std::string> known;
    std::vector<const Option*> options;
    for (const Option& option : option_table()) {
        if (is_keyword(option) && std::ranges::find(sections, option.section) != sections.end() &&
            (option.commands & commands) != 0) {
            known.emplace_back(option.name);
            options.push_back(&option);
        }
    }
    for (const auto& [key, value] : keywords.items()) {
        const auto place = std::ranges::find(known, key);
        if (place == known.end()) {
            return fail(ErrorKind::usage, fmt::format("keyword '{}' is unknown here; did you mean '{}'?",
                                                      key.substr(0, 100), nearest_word(key, known)));
        }
        if (value.is_null()) {
            continue;
        }
        const Option& option = *options[static_cast<std::size_t>(place - known.begin())];
        if (auto done = set_option(option, job, value, fmt::format("keyword '{}'", key)); !done) {
            return done;
        }
    }
    return {};
}

Result<void> set_command_keyword(Job& job, std::string_view name, const json& value)
{
    const auto option = std::ranges::find_if(option_table(), [&](const Option& candidate) {
        return candidate.section == "command" && candidate.name == name;
    });
    return value.is_null() ? Result<void>() : set_option(*option, job, value, fmt::format("keyword '{}'", name));
}

ordered_json options_json()
{
    ordered_json list = ordered_json::array();
    Job job;
    for (const Option& option : option_table()) {
        list.push_back({{"name", option.name},
                        {"section", option.section},
                        {"type", std::visit(TypeName{}, option.slot(job))},
                        {"default", option_default(option)},
                        {"minimum", bound(option.min)},
                        {"maximum", bound(option.max)},
                        {"choices", option.choices.empty() ? ordered_json(nullptr) : ordered_json(option.choices)},
                        {"unit", text(option.unit)},
                        {"help", option.help},
                        {"zero", text(option.zero)},
                        {"count", option.count > 0 ? ordered_json(option.count) : ordered_json(nullptr)},
                        {"file", option.file == FileRole::none    ? ordered_json(nullptr)
                                 : option.file == FileRole::input ? ordered_json("input")
                                                                  : ordered_json("output")},
                        {"commands", command_names(option.commands)}});
    }
    return list;
}

} // namespace tapeline
