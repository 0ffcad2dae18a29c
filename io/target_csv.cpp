// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/fit.h"
#include "io/target_formats.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tapeline {

namespace {

std::string_view trim(std::string_view text)
{
    constexpr std::string_view blanks = " \t\v\f";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::vector<std::string_view> split(std::string_view line)
{
    std::vector<std::string_view> values;
    while (true) {
        const size_t comma = line.find(',');
        values.push_back(trim(line.substr(0, comma)));
        if (comma == std::string_view::npos) {
            return values;
        }
        line.remove_prefix(comma + 1);
    }
}

bool is_header(const std::vector<std::string_view>& values)
{
    const auto is = [](std::string_view text, char letter) {
        return text.size() == 1 && std::tolower(static_cast<unsigned char>(text[0])) == letter;
    };
    return values.size() == 3 && is(values[0], 'x') && is(values[1], 'y') && is(values[2], 'z');
}

/// A finite number that fills the text completely.
std::optional<double> number(std::string_view text)
{
    double value = 0;
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The bytes of a cell, fit for a message.
std::string shown(std::string_view text)
{
    std::string result(text.substr(0, 40));
    std::ranges::replace_if(
        result, [](unsigned char c) { return c < 32 || c > 126; }, '?');
    return result;
}

Result<Vec3> read_row(const std::vector<std::string_view>& values, const std::string& place)
{
    if (values.size() != 3) {
        return fail(ErrorKind::unreadable, fmt::format("{}: {} value{} where x,y,z are needed", place, values.size(),
                                                       values.size() == 1 ? "" : "s"));
    }
    Vec3 point;
    for (int k = 0; k < 3; ++k) {
        const auto value = number(values[k]);
        if (!value) {
            return fail(ErrorKind::unreadable,
                        fmt::format("{}: \"{}\" is not a finite number", place, shown(values[k])));
        }
        point[k] = *value;
    }
    return point;
}

Result<std::vector<Vec3>> read_rows(const std::string& file, std::string_view content)
{
    std::vector<Vec3> points;
    bool header = false;
    for (int number = 1; !content.empty(); ++number) {
        const size_t end = std::min(content.find_first_of("\r\n"), content.size());
        const std::string_view line = trim(content.substr(0, std::min(end, content.find('#'))));
        content.remove_prefix(end);
        content.remove_prefix(content.starts_with("\r\n") ? 2 : content.empty() ? 0 : 1);
        if (line.empty()) {
            continue;
        }
        const std::string place = fmt::format("{}, line {}", file, number);
        if (!header) {
            if (!is_header(split(line))) {
                return fail(ErrorKind::unreadable, fmt::format("{}: \"{}\" is not the header x,y,z that a CSV target "
                                                               "begins with (or the file is no target at all)",
                                                               place, shown(line)));
            }
            header = true;
            continue;
        }
        const auto point = read_row(split(line), place);
        if (!point) {
            return tl::unexpected(point.error());
        }
        points.push_back(*point);
    }
    return points;
}

} // namespace

Result<TargetLine> target_from_csv(const std::string& file, std::string_view content)
{
    content.remove_prefix(content.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    auto points = read_rows(file, content);
    if (!points) {
        return tl::unexpected(points.error());
    }
    double length = 0;
    for (size_t i = 1; i < points->size(); ++i) {
        length += ((*points)[i] - (*points)[i - 1]).norm();
    }
    const bool closed = points->size() > 3 && (points->front() - points->back()).norm() <= 1e-9 * length;
    if (closed) {
        points->pop_back();
    }
    return interpolate_points(*points, closed).map_error([&](Error error) {
        error.message = fmt::format("{}: {}", file, error.message);
        return error;
    });
}

std::string target_to_csv(const TargetLine& line)
{
    const BSplineData data = line.data();
    const double spans = static_cast<double>(data.control_points.size()) - data.degree;
    const int n = static_cast<int>(std::clamp(32 * spans, 200.0, 20000.0));
    std::string text = "x,y,z\n";
    for (int i = 0; i <= n; ++i) {
        const double t = i == n ? line.last_parameter() : line.parameter_at(line.length() * i / n);
        const Vec3 p = line.point(i == n && line.closed() ? line.first_parameter() : t);
        text += fmt::format("{},{},{}\n", p.x(), p.y(), p.z());
    }
    return text;
}

} // namespace tapeline
