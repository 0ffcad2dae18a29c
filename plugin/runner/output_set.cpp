// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/output_set.h"

#include "io/model_file.h"

#include <fmt/format.h>
#include <set>
#include <unistd.h>

namespace tapeline {

namespace fs = std::filesystem;

namespace {

std::string with_real_name(std::string message, const fs::path& temporary, const fs::path& goal)
{
    const std::string name = temporary.string();
    for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at)) {
        message.replace(at, name.size(), goal.string());
        at += goal.string().size();
    }
    return message;
}

/// Removes the files that it was given, unless they have been renamed by then.
struct Temporaries {
    std::vector<fs::path> paths;
    Temporaries() = default;
    Temporaries(const Temporaries&) = delete;
    Temporaries& operator=(const Temporaries&) = delete;
    ~Temporaries()
    {
        std::error_code error;
        for (const fs::path& path : paths) {
            fs::remove(path, error);
        }
    }
};

} // namespace

void OutputSet::add(fs::path goal, Writer writer) { entries_.push_back({std::move(goal), std::move(writer)}); }

void OutputSet::add_text(fs::path goal, std::string content)
{
    add(std::move(goal),
        [text = std::move(content)](const fs::path& path) { return write_file_atomically(path, text); });
}

Result<void> OutputSet::check(const fs::path& input) const
{
    std::set<fs::path> names;
    std::error_code error;
    for (const Entry& entry : entries_) {
        if (fs::is_directory(entry.goal, error) || !entry.goal.has_filename()) {
            return fail(ErrorKind::usage,
                        fmt::format("the output {} is a folder; give a file name", entry.goal.string()));
        }
        const fs::path name = fs::weakly_canonical(entry.goal, error);
        if (!names.insert(name).second) {
            return fail(ErrorKind::usage, fmt::format("the output {} is given twice", entry.goal.string()));
        }
        if (!input.empty() && fs::equivalent(entry.goal, input, error)) {
            return fail(ErrorKind::usage,
                        fmt::format("the output {} would overwrite the input; give another name", entry.goal.string()));
        }
    }
    return {};
}

Result<void> OutputSet::commit() const
{
    Temporaries made;
    for (const Entry& entry : entries_) {
        std::error_code error;
        if (entry.goal.has_parent_path()) {
            fs::create_directories(entry.goal.parent_path(), error);
        }
        // The ending stays, because writers choose the format by it.
        made.paths.push_back(entry.goal.parent_path() / fmt::format(".tapeline-{}-{}-{}", getpid(), made.paths.size(),
                                                                    entry.goal.filename().string()));
        if (const auto written = entry.writer(made.paths.back()); !written) {
            return fail(written.error().kind, with_real_name(written.error().message, made.paths.back(), entry.goal));
        }
    }
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        std::error_code error;
        fs::rename(made.paths[k], entries_[k].goal, error);
        if (error) {
            return fail(ErrorKind::unreadable,
                        fmt::format("cannot write {}: {}", entries_[k].goal.string(), error.message()));
        }
    }
    return {};
}

} // namespace tapeline
