// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/pictures.h"
#include "plugin/runner/runner.h"

namespace tapeline {

/// One self-contained HTML page: what was done, the measures before and after, warnings, and the pictures.
std::string html_report(const Job& job, const JobOutcome& outcome, const std::vector<Picture>& pictures);

/// Text with the characters that HTML reserves replaced.
std::string html_text(std::string_view text);

/// Base64 of bytes (RFC 4648).
std::string base64(std::string_view bytes);

} // namespace tapeline
