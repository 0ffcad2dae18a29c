// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/job_file.h"

#include "kernel/spelling.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/option_value.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <set>

namespace tapeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

/// Applies `change` to every file name that an option holds.
template <class Change>
void change_paths(const Option& option, Job& job, const Change& change)
{
    const auto change_selector = [&](LineSelector& selector) {
        if (!selector.empty() && !selector.names_line()) {
            selector.text = change(selector.text).string();
        }
    };
    const OptionSlot slot = option.slot(job);
    if (auto* path = std::get_if<fs::path*>(&slot); path && !(*path)->empty()) {
        **path = change(**path);
    } else if (auto* paths = std::get_if<std::vector<fs::path>*>(&slot)) {
        std::ranges::transform(**paths, (*paths)->begin(), change);
    } else if (auto* selector = std::get_if<LineSelector*>(&slot)) {
        change_selector(**selector);
    } else if (auto* selectors = std::get_if<std::vector<LineSelector>*>(&slot)) {
        std::ranges::for_each(**selectors, change_selector);
    }
}

const Option* find_option(std::string_view section, std::string_view name)
{
    for (const Option& option : option_table()) {
        if (option.in_job() && option.section == section && option.name == name) {
            return &option;
        }
    }
    return nullptr;
}

bool is_section(std::string_view name)
{
    return std::ranges::any_of(option_sections(), [&](const OptionSection& s) { return s.name == name; });
}

/// The known key nearest to an unknown one: by its name within the section, or a key of that very name elsewhere.
std::string suggestion(const std::string& section, const std::string& name)
{
    std::vector<std::string> candidates;
    for (const Option& option : option_table()) {
        if (option.in_job() && option.name == name) {
            return option.path();
        }
        if (option.in_job() && option.section == section) {
            candidates.emplace_back(option.name);
        }
    }
    if (section.empty()) {
        for (const OptionSection& s : option_sections()) {
            candidates.emplace_back(s.name);
        }
    }
    return nearest_word(name, candidates);
}

class JobReader {
public:
    JobReader(std::string name, fs::path folder) : name_(std::move(name)), folder_(std::move(folder)) {}

    Result<Job> read(const json& document)
    {
        if (!document.is_object()) {
            return fail(ErrorKind::usage,
                        fmt::format("{}: a job must be a JSON object, not {}", name_, document.type_name()));
        }
        for (const auto& [key, value] : document.items()) {
            if (key == "$schema") {
                continue;
            }
            if (is_section(key)) {
                if (auto done = read_section(key, value); !done) {
                    return tl::unexpected(done.error());
                }
            } else if (auto done = read_key("", key, value); !done) {
                return tl::unexpected(done.error());
            }
        }
        return std::move(job_);
    }

private:
    Result<void> read_section(const std::string& section, const json& values)
    {
        if (!values.is_object()) {
            return fail(ErrorKind::usage, fmt::format("{}: key '{}' must be an object with keys such as '{}', not {}",
                                                      name_, section, first_key(section), values.type_name()));
        }
        for (const auto& [key, value] : values.items()) {
            if (auto done = read_key(section, key, value); !done) {
                return done;
            }
        }
        return {};
    }

    Result<void> read_key(const std::string& section, const std::string& key, const json& value)
    {
        const std::string path = section.empty() ? key : section + "." + key;
        const Option* option = find_option(section, key);
        if (option == nullptr) {
            return fail(ErrorKind::usage, fmt::format("{}: key '{}' is unknown; did you mean '{}'?", name_,
                                                      path.substr(0, 100), suggestion(section, key)));
        }
        auto done = set_option(*option, job_, value, fmt::format("{}: key '{}'", name_, path));
        if (done) {
            change_paths(*option, job_, [&](const fs::path& file) {
                return file.is_absolute() || folder_.empty() ? file : (folder_ / file).lexically_normal();
            });
        }
        return done;
    }

    static std::string first_key(const std::string& section)
    {
        const auto found = std::ranges::find(option_table(), section, &Option::section);
        return std::string(found->name);
    }

    std::string name_;
    fs::path folder_;
    Job job_;
};

/// The text without the library's own label in front.
std::string plain(const char* what)
{
    const std::string text(what);
    const std::size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

} // namespace

Result<Job> parse_job(std::string_view text, const std::string& name, const fs::path& folder)
{
    std::vector<std::set<std::string>> open_objects;
    std::string repeated;
    const auto watch = [&](int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start) {
            open_objects.emplace_back();
        } else if (event == json::parse_event_t::object_end) {
            open_objects.pop_back();
        } else if (event == json::parse_event_t::key && !open_objects.back().insert(parsed.get<std::string>()).second) {
            repeated = parsed.get<std::string>();
        }
        return true;
    };
    try {
        const json document = json::parse(text, watch);
        if (!repeated.empty()) {
            return fail(ErrorKind::usage, fmt::format("{}: key '{}' is given twice; keep one", name, repeated));
        }
        return JobReader(name, folder).read(document);
    } catch (const json::exception& error) {
        return fail(ErrorKind::unreadable, fmt::format("{}: not a JSON file: {}", name, plain(error.what())));
    }
}

Result<Job> read_job(const fs::path& path)
{
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: there is no such file", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: check its permissions", path.string()));
    }
    return parse_job(text, path.string(), path.parent_path());
}

std::string job_text(const Job& job, const fs::path& folder)
{
    Job copy = job;
    const auto relative = [&](const fs::path& file) {
        std::error_code error;
        const fs::path from = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
        return fs::absolute(file, error).lexically_normal().lexically_relative(from);
    };
    ordered_json document = ordered_json::object();
    for (const Option& option : option_table()) {
        if (!option.in_job() || option_json(option, job) == option_default(option)) {
            continue;
        }
        change_paths(option, copy, relative);
        ordered_json& place = option.section.empty() ? document : document[std::string(option.section)];
        place[std::string(option.name)] = option_json(option, copy);
    }
    return json_text(document);
}

} // namespace tapeline
