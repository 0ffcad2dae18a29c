// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tapeline::testing {

/// What a run of the program gave.
struct CommandRun {
    int exit_code = -1; ///< 1000 + signal number when it was killed
    std::string out;    ///< standard output
    std::string err;    ///< standard error
};

/// Runs the `tapeline` program with these arguments and waits for it. As soon as its standard
/// error holds `interrupt_at` (if not empty), it is sent SIGINT.
CommandRun run_tapeline(const std::vector<std::string>& arguments, const std::string& interrupt_at = {});

/// Runs another program, found on PATH, and waits for it.
CommandRun run_program(const std::vector<std::string>& words);

/// Names of all files in a folder and its sub-folders, relative to it, ascending.
std::vector<std::string> files_in(const std::filesystem::path& folder);

/// Writes the crease panel (800 × 600 mm, a 12° crease along y = 0) with nx × ny cells as a mesh file.
void write_panel(const std::filesystem::path& path, int nx = 40, int ny = 30);

} // namespace tapeline::testing
