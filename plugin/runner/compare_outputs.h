// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/progress.h"
#include "plugin/runner/comparison.h"
#include "plugin/runner/stopwatch.h"

#include <string>

namespace tapeline {

/// Checks the folder that a comparison writes into, before any work is done. Fails with usage when it is a file, or
/// when the job's input would be overwritten.
Result<void> check_compare_outputs(const Job& job);

/// compare.json: what was done and measured, with stable keys; lengths mm, angles deg, times s.
std::string compare_json(const Job& job, const Comparison& comparison);

/// Draws the pictures and writes compare.html, compare.json, METHOD.obj and pictures/ into the job's folder, together
/// (see OutputSet).
Result<void> write_comparison(const Job& job, Comparison& comparison, const Progress& progress);

} // namespace tapeline
