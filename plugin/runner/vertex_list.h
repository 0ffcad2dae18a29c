// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/feature_lines.h"
#include "plugin/runner/job.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tapeline {

/// Reads vertex indices: numbers separated by blanks, commas or line ends, a JSON array of them, or a JSON object with
/// `vertices` (as `tapeline lines --json` has per line) or `line.vertices` (as statistics have). Fails (unreadable)
/// when there is no number or something else stands in the file.
Result<std::vector<int>> read_vertex_list(const std::filesystem::path& path);

/// The line's vertices, one index a line; a closed line repeats its first vertex.
std::string vertex_list_text(const FeatureLine& line);

/// Fails (usage) when no line is named.
Result<void> check_line_chosen(const LineSelector& selector);

/// The line that a selector names among the model's feature lines, or the chain of vertices in its file.
Result<FeatureLine> choose_line(const Model& model, const std::vector<FeatureLine>& lines,
                                const LineSelector& selector);

/// What the job says about finding lines.
FeatureLineOptions line_options(const LineSettings& settings);

} // namespace tapeline
