// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/option_value.h"

#include "kernel/spelling.h"
#include "plugin/runner/json_text.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tapeline {

namespace {

using nlohmann::json;

struct KindText {
    const Option& option;
    std::string in_unit(std::string text) const
    {
        return option.unit.empty() ? text : fmt::format("{} in {}", text, option.unit);
    }
    std::string list(std::string text) const
    {
        return option.count > 0 ? fmt::format("a list of {} {}", option.count, text) : "a list of " + text;
    }
    std::string operator()(const bool*) const { return "true or false"; }
    std::string operator()(const int*) const { return in_unit("a whole number"); }
    std::string operator()(const double*) const { return in_unit("a number"); }
    std::string operator()(const std::optional<double>*) const { return in_unit("a number"); }
    std::string operator()(const std::string*) const
    {
        return option.choices.empty() ? "a text" : fmt::format("one of {}", fmt::join(option.choices, ", "));
    }
    std::string operator()(const std::filesystem::path*) const { return "a file name"; }
    std::string operator()(const LineSelector*) const { return "a line number, a part ID@FROM..TO or a file name"; }
    std::string operator()(const std::vector<int>*) const { return list("whole numbers"); }
    std::string operator()(const std::vector<double>*) const { return in_unit(list("numbers")); }
    std::string operator()(const std::vector<std::string>*) const
    {
        return option.choices.empty() ? list("texts") : fmt::format("a list from {}", fmt::join(option.choices, ", "));
    }
    std::string operator()(const std::vector<std::filesystem::path>*) const { return list("file names"); }
    std::string operator()(const std::vector<LineSelector>*) const { return list("line numbers or file names"); }
};

/// Sets a slot from JSON; the first failure is kept as a sentence in `problem`.
struct Setter {
    const Option& option;
    const json& value;
    std::string problem;

    bool wrong_type()
    {
        problem = fmt::format("must be {}, not {}", kind_text(option),
                              value.is_null() ? "null" : fmt::format("{} {}", value.type_name(), json_line(value)));
        if (problem.size() > 300) {
            problem = fmt::format("must be {}, not {}", kind_text(option), value.type_name());
        }
        return false;
    }
    bool number(const json& j, double& x)
    {
        if (!j.is_number()) {
            return wrong_type();
        }
        const auto candidate = j.get<double>();
        if (!std::isfinite(candidate) || candidate < option.min || candidate > option.max) {
            problem = std::isfinite(option.max)
                          ? fmt::format("is {} but must lie in {} to {}", candidate, option.min, option.max)
                          : fmt::format("is {} but must be at least {}", candidate, option.min);
            return false;
        }
        x = candidate;
        return true;
    }
    bool whole(const json& j, int& x)
    {
        double candidate = 0;
        if (!j.is_number() || j.get<double>() != std::floor(j.get<double>())) {
            return wrong_type();
        }
        if (!number(j, candidate)) {
            return false;
        }
        if (std::abs(candidate) > std::numeric_limits<int>::max()) {
            problem = fmt::format("is {}, which is too large", candidate);
            return false;
        }
        x = static_cast<int>(candidate);
        return true;
    }
    bool text(const json& j, std::string& x)
    {
        if (!j.is_string()) {
            return wrong_type();
        }
        const auto candidate = j.get<std::string>();
        if (candidate.find('\0') != std::string::npos) {
            problem = "holds a zero byte";
            return false;
        }
        x = candidate;
        return true;
    }
    bool selector(const json& j, LineSelector& x)
    {
        if (j.is_number_unsigned()) {
            x.text = std::to_string(j.get<std::uint64_t>());
            return true;
        }
        return text(j, x.text);
    }
    template <class T, class One>
    bool list(std::vector<T>* slot, One one)
    {
        const json entries = value.is_array() ? value : json::array({value});
        if (option.count > 0 && static_cast<int>(entries.size()) != option.count) {
            problem = fmt::format("must be {}, but {} are given", kind_text(option), entries.size());
            return false;
        }
        std::vector<T> values(entries.size());
        for (std::size_t k = 0; k < entries.size(); ++k) {
            if (!one(entries[k], values[k])) {
                return false;
            }
        }
        *slot = std::move(values);
        return true;
    }

    bool operator()(bool* slot)
    {
        if (!value.is_boolean()) {
            return wrong_type();
        }
        *slot = value.get<bool>();
        return true;
    }
    bool operator()(int* slot) { return whole(value, *slot); }
    bool operator()(double* slot) { return number(value, *slot); }
    bool operator()(std::optional<double>* slot)
    {
        double x = 0;
        if (!number(value, x)) {
            return false;
        }
        *slot = x;
        return true;
    }
    bool operator()(std::string* slot) { return choice(value, *slot); }
    bool operator()(std::vector<std::string>* slot)
    {
        return list(slot, [&](const json& j, std::string& x) { return choice(j, x); });
    }
    bool choice(const json& j, std::string& x)
    {
        std::string candidate;
        if (!text(j, candidate)) {
            return false;
        }
        if (!option.choices.empty() && std::ranges::find(option.choices, candidate) == option.choices.end()) {
            const std::vector<std::string> choices(option.choices.begin(), option.choices.end());
            problem = fmt::format("is '{}' but must be {}; did you mean '{}'?", candidate.substr(0, 64),
                                  kind_text(option), nearest_word(candidate, choices));
            return false;
        }
        x = candidate;
        return true;
    }
    bool operator()(std::filesystem::path* slot)
    {
        std::string name;
        if (!text(value, name)) {
            return false;
        }
        *slot = name;
        return true;
    }
    bool operator()(LineSelector* slot) { return selector(value, *slot); }
    bool operator()(std::vector<int>* slot)
    {
        return list(slot, [&](const json& j, int& x) { return whole(j, x); });
    }
    bool operator()(std::vector<double>* slot)
    {
        return list(slot, [&](const json& j, double& x) { return number(j, x); });
    }
    bool operator()(std::vector<std::filesystem::path>* slot)
    {
        return list(slot, [&](const json& j, std::filesystem::path& x) {
            std::string name;
            const bool fine = text(j, name);
            x = name;
            return fine;
        });
    }
    bool operator()(std::vector<LineSelector>* slot)
    {
        return list(slot, [&](const json& j, LineSelector& x) { return selector(j, x); });
    }
};

/// Reads a text as the JSON that the slot would take; what cannot be read stays a text and fails as such later.
json read_number(const std::string& text)
{
    const char* end = text.data() + text.size();
    long long whole = 0;
    if (const auto [at, error] = std::from_chars(text.data(), end, whole); error == std::errc() && at == end) {
        return whole;
    }
    double x = 0;
    if (const auto [at, error] = std::from_chars(text.data(), end, x); error == std::errc() && at == end) {
        return x;
    }
    return text;
}

std::vector<std::string> split_at_commas(const std::vector<std::string>& texts)
{
    std::vector<std::string> parts;
    for (const std::string& text : texts) {
        std::size_t from = 0;
        for (std::size_t to = text.find(','); to != std::string::npos; to = text.find(',', from)) {
            parts.push_back(text.substr(from, to - from));
            from = to + 1;
        }
        parts.push_back(text.substr(from));
    }
    return parts;
}

struct TextReader {
    const std::vector<std::string>& texts;
    json operator()(const bool*) const
    {
        if (texts.empty() || texts.back() == "true") {
            return true;
        }
        return texts.back() == "false" ? json(false) : json(texts.back());
    }
    json operator()(const int*) const { return read_number(texts.back()); }
    json operator()(const double*) const { return read_number(texts.back()); }
    json operator()(const std::optional<double>*) const { return read_number(texts.back()); }
    json operator()(const std::string*) const { return texts.back(); }
    json operator()(const std::filesystem::path*) const { return texts.back(); }
    json operator()(const LineSelector*) const { return texts.back(); }
    json operator()(const std::vector<std::filesystem::path>*) const { return texts; }
    json operator()(const std::vector<std::string>*) const { return split_at_commas(texts); }
    json operator()(const std::vector<LineSelector>*) const { return split_at_commas(texts); }
    template <class Number>
    json operator()(const std::vector<Number>*) const
    {
        json list = json::array();
        for (const std::string& part : split_at_commas(texts)) {
            list.push_back(read_number(part));
        }
        return list;
    }
};

struct Getter {
    json operator()(const std::optional<double>* slot) const { return slot->has_value() ? json(**slot) : json(); }
    json operator()(const std::filesystem::path* slot) const { return slot->string(); }
    json operator()(const LineSelector* slot) const { return slot->text; }
    json operator()(const std::vector<std::filesystem::path>* slot) const
    {
        json list = json::array();
        for (const auto& path : *slot) {
            list.push_back(path.string());
        }
        return list;
    }
    json operator()(const std::vector<LineSelector>* slot) const
    {
        json list = json::array();
        for (const auto& selector : *slot) {
            list.push_back(selector.text);
        }
        return list;
    }
    template <class T>
    json operator()(const T* slot) const
    {
        return *slot;
    }
};

} // namespace

Result<void> set_option(const Option& option, Job& job, const json& value, const std::string& where)
{
    Setter setter{option, value, {}};
    if (!std::visit(setter, option.slot(job))) {
        return fail(ErrorKind::usage, fmt::format("{} {}", where, setter.problem));
    }
    return {};
}

Result<void> set_option_from_text(const Option& option, Job& job, const std::vector<std::string>& texts,
                                  const std::string& where)
{
    const OptionSlot slot = option.slot(job);
    if (texts.empty() && !std::holds_alternative<bool*>(slot)) {
        return fail(ErrorKind::usage, fmt::format("{} needs {}", where, kind_text(option)));
    }
    return set_option(option, job, std::visit(TextReader{texts}, slot), where);
}

json option_json(const Option& option, const Job& job)
{
    // Slots point into a Job that can be written; reading does not.
    return std::visit(Getter{}, option.slot(const_cast<Job&>(job)));
}

json option_default(const Option& option) { return option_json(option, Job()); }

std::string kind_text(const Option& option)
{
    Job job;
    return std::visit(KindText{option}, option.slot(job));
}

std::string help_text(const Option& option)
{
    std::vector<std::string> notes;
    if (!option.unit.empty()) {
        notes.emplace_back(option.unit);
    }
    if (!option.choices.empty()) {
        notes.push_back(fmt::format("{}", fmt::join(option.choices, "|")));
    }
    if (std::isfinite(option.min) && std::isfinite(option.max)) {
        notes.push_back(fmt::format("{} to {}", option.min, option.max));
    } else if (std::isfinite(option.min)) {
        notes.push_back(fmt::format("at least {}", option.min));
    }
    const json value = option_default(option);
    if (value.is_number()) {
        notes.push_back(value == 0 && !option.zero.empty() ? fmt::format("default 0: {}", option.zero)
                                                           : fmt::format("default {}", value.get<double>()));
    } else if (value.is_string() && !value.get<std::string>().empty()) {
        notes.push_back(fmt::format("default {}", value.get<std::string>()));
    } else if (value.is_array() && !option.zero.empty()) {
        notes.push_back(fmt::format("default {}", option.zero));
    }
    return notes.empty() ? std::string(option.help) : fmt::format("{} [{}]", option.help, fmt::join(notes, "; "));
}

} // namespace tapeline
