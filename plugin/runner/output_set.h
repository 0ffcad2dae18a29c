// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tapeline {

/// All files that one job writes. Nothing is written before `commit`, which first makes every file under a temporary
/// name beside its goal and only then renames them: when one cannot be written, no goal is touched.
class OutputSet {
public:
    /// Writes a file's content to the path that it is given.
    using Writer = std::function<Result<void>(const std::filesystem::path&)>;

    void add(std::filesystem::path goal, Writer writer);
    /// A file with this content.
    void add_text(std::filesystem::path goal, std::string content);

    /// Fails (usage) when two outputs have one name, or one is the file `input`, or one is a folder.
    Result<void> check(const std::filesystem::path& input) const;

    /// Makes missing folders, writes and renames. Fails (unreadable) naming the goal.
    Result<void> commit() const;

private:
    struct Entry {
        std::filesystem::path goal;
        Writer writer;
    };
    std::vector<Entry> entries_;
};

} // namespace tapeline
