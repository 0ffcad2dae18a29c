// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json_fields.h"

#include "kernel/spelling.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace tapeline {

namespace {

using nlohmann::json;

/// What a message calls the value's type.
std::string kind_of(const json& value)
{
    if (value.is_array()) {
        return fmt::format("a list of {}", value.size());
    }
    if (value.is_number()) {
        return fmt::format("the number {}", value.dump().substr(0, 40));
    }
    return value.is_null() ? "null" : value.is_object() ? "an object" : value.is_boolean() ? "true/false" : "a text";
}

tl::unexpected<Error> wrong(const JsonField& field, std::string_view wanted)
{
    if (field.missing()) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{}: the key \"{}\" is missing, it must be {}", field.file, field.key, wanted));
    }
    const std::string place = field.key.empty() ? "the content" : fmt::format("\"{}\"", field.key);
    return fail(ErrorKind::unreadable,
                fmt::format("{}: {} must be {}, not {}", field.file, place, wanted, kind_of(*field.value)));
}

} // namespace

JsonField JsonField::member(std::string_view name) const
{
    const auto found = value->find(std::string(name));
    return {found == value->end() ? nullptr : &*found, file,
            key.empty() ? std::string(name) : fmt::format("{}.{}", key, name)};
}

JsonField JsonField::element(size_t index) const { return {&(*value)[index], file, fmt::format("{}[{}]", key, index)}; }

Result<json> parse_json(const std::string& file, std::string_view content)
try {
    return json::parse(content);
} catch (const json::exception& failure) {
    // "[json.exception.parse_error.101] parse error at line 3, column 7: …"
    std::string reason = failure.what();
    reason.erase(0, reason.find("] ") == std::string::npos ? 0 : reason.find("] ") + 2);
    for (char& c : reason) {
        c = static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126 ? '?' : c;
    }
    return fail(ErrorKind::unreadable, fmt::format("{} is not valid JSON: {}", file, reason.substr(0, 200)));
}

Result<void> check_object(const JsonField& field, const std::vector<std::string_view>& known_keys)
{
    if (field.missing() || !field.value->is_object()) {
        return wrong(field, "an object { … }");
    }
    for (const auto& [key, value] : field.value->items()) {
        if (std::ranges::find(known_keys, key) != known_keys.end()) {
            continue;
        }
        const std::string shown = key.substr(0, 60);
        const std::string nearest = nearest_word(shown, {known_keys.begin(), known_keys.end()});
        const std::string place = field.key.empty() ? "" : fmt::format(" in \"{}\"", field.key);
        return fail(ErrorKind::unreadable, fmt::format("{}: unknown key \"{}\"{}; the nearest known key is \"{}\"",
                                                       field.file, shown, place, nearest));
    }
    return {};
}

Result<double> read_number(const JsonField& field)
{
    if (field.missing() || !field.value->is_number()) {
        return wrong(field, "a number");
    }
    return field.value->get<double>();
}

Result<int> read_integer(const JsonField& field)
{
    if (field.missing() || !field.value->is_number()) {
        return wrong(field, "a whole number");
    }
    const double value = field.value->get<double>();
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
        return wrong(field, "a whole number");
    }
    return static_cast<int>(value);
}

Result<bool> read_flag(const JsonField& field)
{
    if (field.missing() || !field.value->is_boolean()) {
        return wrong(field, "true or false");
    }
    return field.value->get<bool>();
}

Result<std::vector<double>> read_numbers(const JsonField& field)
{
    if (field.missing() || !field.value->is_array()) {
        return wrong(field, "a list of numbers");
    }
    std::vector<double> numbers;
    for (size_t i = 0; i < field.value->size(); ++i) {
        const auto number = read_number(field.element(i));
        if (!number) {
            return tl::unexpected(number.error());
        }
        numbers.push_back(*number);
    }
    return numbers;
}

Result<Vec3> read_point(const JsonField& field)
{
    const bool three = !field.missing() && field.value->is_array() && field.value->size() == 3 &&
                       std::ranges::all_of(*field.value, [](const json& value) { return value.is_number(); });
    if (!three) {
        return wrong(field, "a list of three numbers [x, y, z]");
    }
    return Vec3((*field.value)[0].get<double>(), (*field.value)[1].get<double>(), (*field.value)[2].get<double>());
}

Result<std::vector<Vec3>> read_points(const JsonField& field)
{
    if (field.missing() || !field.value->is_array()) {
        return wrong(field, "a list of points [[x, y, z], …]");
    }
    std::vector<Vec3> points;
    for (size_t i = 0; i < field.value->size(); ++i) {
        const auto point = read_point(field.element(i));
        if (!point) {
            return tl::unexpected(point.error());
        }
        points.push_back(*point);
    }
    return points;
}

} // namespace tapeline
