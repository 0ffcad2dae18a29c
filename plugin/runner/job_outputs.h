// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/progress.h"
#include "plugin/runner/runner.h"

namespace tapeline {

/// Checks the names of everything that the job would write, before any work is done: known endings, no name twice,
/// none that is the input. Fails with usage.
Result<void> check_outputs(const Job& job);

/// The same where no mesh needs to be written.
Result<void> check_output_names(const Job& job);

/// Writes everything that the job asks for, together (see OutputSet). Stages are added to `watch` and to
/// outcome.seconds, which the statistics hold without the time of the writing itself.
Result<void> write_outputs(const Job& job, JobOutcome& outcome, Stopwatch& watch, const Progress& progress);

/// Fails (usage) when the name does not end like a mesh format that can be written.
Result<void> check_mesh_name(const std::filesystem::path& path);

/// Fails (usage) when the name does not end like a target format that can be written.
Result<void> check_target_name(const std::filesystem::path& path);

} // namespace tapeline
