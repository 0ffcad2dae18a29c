// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tapeline {

/// JSON as the text of a file. Bytes that are no UTF-8, as file names may hold, are replaced instead of thrown at.
template <class Json>
std::string json_text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The same in one line, for messages.
template <class Json>
std::string json_line(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace tapeline
