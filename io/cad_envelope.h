// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/file_format.h"
#include "kernel/error.h"

#include <string>
#include <string_view>

namespace tapeline {

/// Checks that a CAD file is whole before OpenCASCADE reads it, whose readers may end the process on a file that is
/// cut short: STEP must reach END-ISO-10303-21, the IGES sections must have the line counts that the terminate line
/// gives, a text BREP must hold as many curves, surfaces and shapes as it announces. Fails with
/// ErrorKind::unreadable and one sentence that names `path`.
Result<void> check_cad_envelope(FileFormat format, std::string_view content, const std::string& path);

} // namespace tapeline
