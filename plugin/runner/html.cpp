// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/html.h"

#include <algorithm>

namespace tapeline {

std::string html_text(std::string_view text)
{
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

std::string base64(std::string_view bytes)
{
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        unsigned group = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            group = group << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += k + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63U] : '=';
        }
    }
    return text;
}

std::string fill_template(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values)
{
    std::string filled;
    while (true) {
        const std::size_t from = text.find("{{");
        const std::size_t to = from == std::string_view::npos ? from : text.find("}}", from);
        if (to == std::string_view::npos) {
            return filled.append(text);
        }
        filled.append(text.substr(0, from));
        const std::string_view name = text.substr(from + 2, to - from - 2);
        const auto value = std::ranges::find(values, name, [](const auto& entry) { return entry.first; });
        if (value != values.end()) {
            filled += value->second;
        }
        text.remove_prefix(to + 2);
    }
}

std::string script_json(std::string_view json)
{
    std::string safe;
    safe.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            safe += "\\u003c";
        } else {
            safe += c;
        }
    }
    return safe;
}

} // namespace tapeline
