// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_header.h"

#include "io/text_scanner.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace tapeline {

namespace {

PlyType type_named(const TextScanner& scanner, std::string_view name)
{
    using enum PlyType;
    constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{{"char", int8},
                                                                          {"int8", int8},
                                                                          {"uchar", uint8},
                                                                          {"uint8", uint8},
                                                                          {"short", int16},
                                                                          {"int16", int16},
                                                                          {"ushort", uint16},
                                                                          {"uint16", uint16},
                                                                          {"int", int32},
                                                                          {"int32", int32},
                                                                          {"uint", uint32},
                                                                          {"uint32", uint32},
                                                                          {"float", float32},
                                                                          {"float32", float32},
                                                                          {"double", float64},
                                                                          {"float64", float64}}};
    const auto found = std::ranges::find(names, name, &std::pair<std::string_view, PlyType>::first);
    if (found == names.end()) {
        scanner.fail_here(fmt::format("{} is no PLY number type (char, uchar, short, ushort, int, uint, float, "
                                      "double): correct the header",
                                      in_quotes(name)));
    }
    return found->second;
}

PlyFormat format_named(const TextScanner& scanner, std::string_view name)
{
    if (name == "ascii") {
        return PlyFormat::ascii;
    }
    if (name == "binary_little_endian") {
        return PlyFormat::little;
    }
    if (name != "binary_big_endian") {
        scanner.fail_here(fmt::format("format {} is none of ascii, binary_little_endian, binary_big_endian: correct "
                                      "the header",
                                      in_quotes(name)));
    }
    return PlyFormat::big;
}

void read_property(const TextScanner& scanner, std::string_view line, PlyElement& element)
{
    PlyProperty property;
    auto word = take_word(line);
    property.list = word == "list";
    if (property.list) {
        property.count_type = type_named(scanner, take_word(line));
        if (!is_integer(property.count_type)) {
            scanner.fail_here("a list's length has a floating-point type: correct the header");
        }
        word = take_word(line);
    }
    property.type = type_named(scanner, word);
    property.name = take_word(line);
    if (property.name.empty() || element.find(property.name) >= 0) {
        scanner.fail_here(fmt::format("property {} of element {} has no name or comes twice: correct the header",
                                      in_quotes(property.name), in_quotes(element.name)));
    }
    element.properties.push_back(std::move(property));
}

PlyElement read_element(const TextScanner& scanner, std::string_view line, const std::vector<PlyElement>& earlier)
{
    PlyElement element;
    element.name = take_word(line);
    const auto count =
        scanner.integer(take_word(line), fmt::format("the count of element {}", in_quotes(element.name)));
    if (count < 0 || std::ranges::find(earlier, element.name, &PlyElement::name) != earlier.end()) {
        scanner.fail_here(
            fmt::format("element {} comes twice or has a negative count: correct the header", in_quotes(element.name)));
    }
    element.count = static_cast<std::uint64_t>(count);
    return element;
}

/// First byte after the header's last line. In a binary file the first data byte may look like a line end, so the
/// line end of the first line tells how long this one is.
std::size_t data_start(std::string_view content, std::size_t end_header)
{
    const std::size_t first = std::min(content.find_first_of("\r\n"), content.size());
    const bool two = content.substr(first, 2) == "\r\n";
    const std::size_t last = std::min(content.find_first_of("\r\n", end_header), content.size());
    return std::min(last + (two && content.substr(last, 2) == "\r\n" ? 2 : 1), content.size());
}

} // namespace

std::size_t size_of(PlyType type)
{
    switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
        return 1;
    case PlyType::int16:
    case PlyType::uint16:
        return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
        return 4;
    case PlyType::float64:
        return 8;
    }
    return 8;
}

int PlyElement::find(std::string_view property) const
{
    const auto found = std::ranges::find(properties, property, &PlyProperty::name);
    return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
}

PlyHeader read_ply_header(std::string_view content)
{
    TextScanner scanner(content);
    PlyHeader header;
    bool format_seen = false;
    std::string_view line;
    scanner.next_filled_line(line); // "ply", or it would not have been taken for one
    while (scanner.next_filled_line(line)) {
        const auto keyword = take_word(line);
        if (keyword == "end_header") {
            if (!format_seen) {
                scanner.fail_here("the header has no \"format\" line: correct it or export the model again");
            }
            header.size = data_start(content, scanner.line_start());
            return header;
        }
        if (keyword == "format") {
            header.format = format_named(scanner, take_word(line));
            format_seen = true;
        } else if (keyword == "element") {
            header.elements.push_back(read_element(scanner, line, header.elements));
        } else if (keyword == "property" && !header.elements.empty()) {
            read_property(scanner, line, header.elements.back());
        } else if (keyword != "comment" && keyword != "obj_info") {
            scanner.fail_here(
                fmt::format("{} is no PLY header keyword that can stand here: correct the header", in_quotes(keyword)));
        }
    }
    scanner.fail_here("the header has no \"end_header\": the file is cut off, export the model again");
}

} // namespace tapeline
