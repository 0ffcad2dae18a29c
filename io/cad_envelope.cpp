// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cad_envelope.h"

#include <array>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace tapeline {

namespace {

tl::unexpected<Error> cut_short(const std::string& path, const std::string& what)
{
    return fail(ErrorKind::unreadable,
                fmt::format("{} is cut short or damaged: {}; export or copy the file again", path, what));
}

std::optional<long> number(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '+')) {
        text.remove_prefix(1);
    }
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

/// Splits off the next line, without its ending (\n, \r\n or \r).
std::string_view next_line(std::string_view& rest)
{
    const size_t end = rest.find_first_of("\r\n");
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end);
    if (rest.starts_with("\r\n")) {
        rest.remove_prefix(2);
    } else if (!rest.empty()) {
        rest.remove_prefix(1);
    }
    return line;
}

Result<void> check_step(std::string_view content, const std::string& path)
{
    if (content.find("END-ISO-10303-21") == std::string_view::npos) {
        return cut_short(path, "the closing END-ISO-10303-21 is missing");
    }
    return {};
}

/// IGES: fixed lines of 80 columns; column 73 names the section, the T line counts the lines of each section.
Result<void> check_iges(std::string_view content, const std::string& path)
{
    constexpr std::string_view sections = "SGDP";
    std::array<long, 4> lines{};
    std::string_view last;
    for (std::string_view rest = content; !rest.empty();) {
        const std::string_view line = next_line(rest);
        if (line.size() < 73) {
            continue;
        }
        if (line[72] == 'T') {
            last = line;
        } else if (const size_t section = sections.find(line[72]); section != std::string_view::npos) {
            ++lines[section];
        }
    }
    if (last.empty()) {
        return cut_short(path, "the terminate section is missing");
    }
    for (size_t i = 0; i < sections.size(); ++i) {
        const auto count = number(last.substr(8 * i + 1, 7));
        if (last[8 * i] != sections[i] || !count || *count != lines[i]) {
            return cut_short(path, fmt::format("section {} has {} lines, the terminate line says \"{}\"", sections[i],
                                               lines[i], last.substr(8 * i, 8)));
        }
    }
    return {};
}

/// Text BREP: tables "Curve2ds N", "Curves N", "Surfaces N" …, then "TShapes N" of which each ends with "*".
Result<void> check_brep(std::string_view content, const std::string& path)
{
    for (const std::string_view table :
         {"\nLocations ", "\nCurve2ds ", "\nCurves ", "\nPolygon3D ", "\nPolygonOnTriangulations ", "\nSurfaces ",
          "\nTriangulations ", "\nTShapes "}) {
        const size_t at = content.find(table);
        const std::string_view name = table.substr(1, table.size() - 2);
        if (at == std::string_view::npos) {
            return cut_short(path, fmt::format("its table {} is missing", name));
        }
        // Each entry takes two characters at least: a larger count would make the reader claim memory for nothing.
        const auto count = number(content.substr(at + table.size(), 20));
        if (!count || *count < 0 || *count > static_cast<long>((content.size() - at) / 2)) {
            return cut_short(path, fmt::format("its table {} announces more entries than the file can hold", name));
        }
        if (name == "TShapes") {
            std::string_view rest = content.substr(at + table.size());
            long ended = 0;
            size_t last = 0;
            for (size_t star = rest.find('*'); star != std::string_view::npos; star = rest.find('*', star + 1)) {
                ++ended;
                last = star;
            }
            if (ended < *count || rest.find_first_of("0123456789", last + 1) == std::string_view::npos) {
                return cut_short(path, fmt::format("{} of {} shapes are there", ended, *count));
            }
        }
    }
    return {};
}

} // namespace

Result<void> check_cad_envelope(FileFormat format, std::string_view content, const std::string& path)
{
    switch (format) {
    case FileFormat::step:
        return check_step(content, path);
    case FileFormat::iges:
        return check_iges(content, path);
    case FileFormat::brep:
        return check_brep(content, path);
    default:
        return {};
    }
}

} // namespace tapeline
