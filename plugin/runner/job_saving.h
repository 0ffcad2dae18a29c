// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/inputs.h"

namespace tapeline {

/// Writes the job file that repeats a job whose model, line or target is in memory, and beside it what the job needs
/// as files, named after it: NAME.target.json for a target (or `target_path`), NAME.line.txt for a chain of vertices,
/// NAME.model.obj for a model given as arrays, in its unit, so that the job's mesh files have that unit too. A job that
/// names no output gets NAME.obj. All files are written together; `tapeline run` on the job then gives the same bytes.
/// Fails as an OutputSet does, and (rejected) where a coordinate in mm is no multiple of the unit that a double could
/// hold, so that the file would not give it back.
Result<void> save_job(Job job, const JobInputs& inputs, const std::filesystem::path& path,
                      const std::filesystem::path& target_path = {});

} // namespace tapeline
