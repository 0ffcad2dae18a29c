// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/edit.h"
#include "bspline/target_line.h"
#include "io/file_format.h"
#include "kernel/error.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The formats behind io/target_file.h, one source file each. `file` is only for messages.
namespace tapeline {

Result<TargetLine> target_from_json(const std::string& file, std::string_view content);
std::string target_to_json(const TargetLine& line);
Result<std::vector<ControlPointEdit>> edits_from_json(const std::string& file, std::string_view content);

/// Header x,y,z, then one point a line [mm]. Blank lines and # comments are skipped, spaces are allowed, any line ending.
/// A last point equal to the first makes a closed line.
Result<TargetLine> target_from_csv(const std::string& file, std::string_view content);
/// Points at equal steps of arc length, 32 per span (200 to 20000 in all).
std::string target_to_csv(const TargetLine& line);

/// Curves of a STEP, IGES or BREP file, joined end to end: edges that belong to no face where there are any, else all.
/// The first curve's own sense gives the line's.
Result<TargetLine> target_from_cad(const std::filesystem::path& path, FileFormat format);
/// The file's bytes, the same for the same line (fixed time stamp, 17 digits). `format`: step, iges or brep.
Result<std::string> target_to_cad(const TargetLine& line, FileFormat format);

} // namespace tapeline
