// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "plugin/runner/job.h"

#include <string_view>

namespace tapeline {

/// Reads a job file. Relative file names in it count from its folder. Fails when it cannot be read (unreadable) or is
/// not a job (usage): an unknown key is named together with the nearest known one, an ill-typed value or one outside
/// its range with what is wanted.
Result<Job> read_job(const std::filesystem::path& path);

/// The same from text; `name` is what messages call the file, `folder` where relative file names count from.
Result<Job> parse_job(std::string_view text, const std::string& name, const std::filesystem::path& folder);

/// The job as the text of a job file that lies in `folder`: only values that differ from the defaults, file names
/// relative to the folder. Reading it back gives the same job.
std::string job_text(const Job& job, const std::filesystem::path& folder);

/// JSON schema (draft 2020-12) of job files, from the option table.
std::string job_schema();

} // namespace tapeline
