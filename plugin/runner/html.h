// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tapeline {

/// Text with the characters that HTML reserves replaced.
std::string html_text(std::string_view text);

/// Base64 of bytes (RFC 4648).
std::string base64(std::string_view bytes);

/// The template with every {{name}} replaced by its value, as it stands. Values are not looked through again; a name
/// without a value becomes nothing.
std::string fill_template(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values);

/// JSON that may stand inside a script element.
std::string script_json(std::string_view json);

} // namespace tapeline
