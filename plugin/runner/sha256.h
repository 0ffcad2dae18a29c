// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"

#include <filesystem>
#include <string>

namespace tapeline {

/// SHA-256 of a file's bytes as 64 hexadecimal digits. Fails (unreadable) when the file cannot be read.
Result<std::string> file_sha256(const std::filesystem::path& path);

} // namespace tapeline
