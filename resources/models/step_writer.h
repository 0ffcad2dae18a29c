// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>

namespace tapeline::models {

/// Writes a shape as STEP AP214 in mm. The header holds no date of its own, so that equal shapes give equal bytes.
/// Throws std::runtime_error naming the file.
void write_step(const std::filesystem::path& path, const TopoDS_Shape& shape, const std::string& name);

} // namespace tapeline::models
