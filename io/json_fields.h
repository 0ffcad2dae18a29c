// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tapeline {

/// A value inside a JSON file and how to name it in a message: file, and path of keys such as `edits[2].to`.
struct JsonField {
    const nlohmann::json* value = nullptr;
    std::string file;
    std::string key; ///< empty for the whole content

    /// Member of an object; `value` is null where it is missing.
    JsonField member(std::string_view name) const;
    JsonField element(size_t index) const;
    bool missing() const { return value == nullptr; }
};

/// Parses a whole file's content. Fails with ErrorKind::unreadable: one sentence with line and column.
Result<nlohmann::json> parse_json(const std::string& file, std::string_view content);

/// Fails unless the field is an object whose keys all are known; an unknown key is named together with the nearest
/// known one.
Result<void> check_object(const JsonField& field, const std::vector<std::string_view>& known_keys);

/// Typed values; failures name the file, the key and the type wanted. Missing members fail too.
Result<double> read_number(const JsonField& field);
Result<int> read_integer(const JsonField& field);
Result<bool> read_flag(const JsonField& field);
Result<std::vector<double>> read_numbers(const JsonField& field);
Result<Vec3> read_point(const JsonField& field);
Result<std::vector<Vec3>> read_points(const JsonField& field);

} // namespace tapeline
