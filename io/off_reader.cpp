// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_readers.h"
#include "io/text_scanner.h"

#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

/// Takes the keyword off the first line and refuses the variants whose points are not x y z.
void read_keyword(TextScanner& scanner, std::string_view& line)
{
    auto rest = line;
    const auto word = take_word(rest);
    if (!word.ends_with("OFF")) {
        return; // the keyword may be left out
    }
    if (word.find('4') != std::string_view::npos || word.find('n') != std::string_view::npos) {
        scanner.fail_here(fmt::format("{} has points of more or fewer than three coordinates: save it as plain OFF",
                                      in_quotes(word)));
    }
    line = rest;
}

std::size_t read_count(const TextScanner& scanner, std::string_view& line, std::string_view what,
                       std::size_t bytes_each)
{
    const auto count = scanner.integer(take_word(line), fmt::format("the number of {}", what));
    if (count < 0 || count > std::numeric_limits<int>::max() ||
        static_cast<std::size_t>(count) > (scanner.bytes_left() + 1) / bytes_each) {
        scanner.fail_here(fmt::format("the header announces {} {}, more than the file's {} bytes can hold: it is cut "
                                      "off or damaged, export the model again",
                                      count, what, scanner.text().size()));
    }
    return static_cast<std::size_t>(count);
}

void read_face(const TextScanner& scanner, std::string_view line, PolygonSoup& soup)
{
    const auto corners = scanner.integer(take_word(line), fmt::format("the corner count of face {}", soup.size()));
    if (corners < 0 || corners > static_cast<std::int64_t>(line.size()) / 2) {
        scanner.fail_here(fmt::format("face {} (counted from 0) announces {} corners, but its line has room for {}: "
                                      "correct it or export the model again",
                                      soup.size(), corners, line.size() / 2));
    }
    for (std::int64_t k = 0; k < corners; ++k) {
        const auto word = take_word(line);
        if (word.empty()) {
            scanner.fail_here(fmt::format("face {} (counted from 0) announces {} corners but lists {}: correct it or "
                                          "export the model again",
                                          soup.size(), corners, k));
        }
        const auto index = scanner.integer(word, "a face's vertex index");
        if (index < 0 || index >= static_cast<std::int64_t>(soup.points.size())) {
            scanner.fail_here(fmt::format("face {} (counted from 0) names vertex {}, but there are {}, counted from 0: "
                                          "correct it or export the model again",
                                          soup.size(), index, soup.points.size()));
        }
        soup.corners.push_back(static_cast<int>(index));
    }
    soup.close_polygon(); // what follows on the line is the face's colour
}

} // namespace

PolygonSoup read_off(std::string_view content, ImportReport&)
{
    TextScanner scanner(content);
    std::string_view line;
    const auto next = [&](std::string_view what, std::size_t done, std::size_t of) {
        if (!scanner.next_filled_line(line)) {
            scanner.fail_here(
                fmt::format("the file ends after {} of {} {}: it is cut off, export the model again", done, of, what));
        }
    };
    next("header lines", 0, 1);
    read_keyword(scanner, line);
    if (line.find_first_not_of(" \t#") == std::string_view::npos || line[line.find_first_not_of(" \t")] == '#') {
        next("header lines", 1, 2);
    }
    const std::size_t vertices = read_count(scanner, line, "vertices", 6);
    const std::size_t faces = read_count(scanner, line, "faces", 2); // the number of edges may follow, nobody needs it
    PolygonSoup soup;
    soup.points.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        next("vertices", v, vertices);
        soup.points.push_back(scanner.point(line, v)); // normals, colours and texture may follow
    }
    soup.ends.reserve(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        next("faces", f, faces);
        read_face(scanner, line, soup);
    }
    return soup;
}

} // namespace tapeline
