// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes.h"
#include "io/mesh_readers.h"
#include "io/text_scanner.h"
#include "io/vertex_welder.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

bool is_keyword(std::string_view word, std::string_view keyword)
{
    return std::ranges::equal(word, keyword, [](char a, char b) { return (a | 0x20) == b; });
}

/// Reads the words of an ASCII STL one after the other, wherever its lines break.
class StlWords {
public:
    explicit StlWords(std::string_view content) : scanner_(content) {}

    std::string_view next()
    {
        while (true) {
            const auto word = take_word(line_);
            if (!word.empty() || !scanner_.next_line(line_)) {
                return word;
            }
        }
    }
    void expect(std::string_view keyword, std::string_view after)
    {
        const auto word = next();
        if (!is_keyword(word, keyword)) {
            fail_here(word.empty() ? fmt::format("the file ends where \"{}\" should follow {}: it is cut off, export "
                                                 "the model again",
                                                 keyword, after)
                                   : fmt::format("{} stands where \"{}\" should follow {}: export the model again",
                                                 in_quotes(word), keyword, after));
        }
    }
    /// A solid's name may hold any words, so it goes with its line.
    void skip_line() { line_ = {}; }

    Vec3 point(std::size_t index)
    {
        if (line_.find_first_not_of(" \t") == std::string_view::npos) {
            scanner_.next_line(line_);
        }
        return scanner_.point(line_, index);
    }
    [[noreturn]] void fail_here(std::string message) const { scanner_.fail_here(std::move(message)); }

private:
    TextScanner scanner_;
    std::string_view line_;
};

void read_facet(StlWords& words, VertexWelder& welder, PolygonSoup& soup)
{
    auto word = words.next();
    if (is_keyword(word, "normal")) { // not used: the order of the corners says it, and some files have nan here
        for (int axis = 0; axis < 3; ++axis) {
            words.next();
        }
        word = words.next();
    }
    if (!is_keyword(word, "outer")) {
        words.fail_here("\"outer loop\" should follow the facet's three normal values: the file is damaged or cut off, "
                        "export the model again");
    }
    words.expect("loop", "\"outer\"");
    for (int k = 0; k < 3; ++k) {
        words.expect("vertex", fmt::format("vertex {} of 3", k));
        soup.corners.push_back(welder.index_of(words.point(soup.corners.size())));
    }
    words.expect("endloop", "three vertices");
    words.expect("endfacet", "\"endloop\"");
    soup.close_polygon();
}

PolygonSoup finish(PolygonSoup soup, VertexWelder& welder, ImportReport& report)
{
    soup.points = welder.take_points();
    report.welded_corners = static_cast<int>(soup.corners.size() - soup.points.size());
    return soup;
}

} // namespace

PolygonSoup read_stl_ascii(std::string_view content, ImportReport& report)
{
    StlWords words(content);
    VertexWelder welder;
    PolygonSoup soup;
    bool in_solid = false;
    for (auto word = words.next(); !word.empty(); word = words.next()) {
        if (is_keyword(word, "facet") && in_solid) {
            read_facet(words, welder, soup);
        } else if (is_keyword(word, "solid") && !in_solid) {
            in_solid = true;
            words.skip_line();
        } else if (is_keyword(word, "endsolid") && in_solid) {
            in_solid = false;
            words.skip_line();
        } else {
            words.fail_here(fmt::format("{} stands where \"{}\" should: export the model again", in_quotes(word),
                                        in_solid ? "facet" : "solid"));
        }
    }
    if (in_solid) {
        words.fail_here("the file ends without \"endsolid\": it is cut off, export the model again");
    }
    return finish(std::move(soup), welder, report);
}

PolygonSoup read_stl_binary(std::string_view content, ImportReport& report)
{
    constexpr std::size_t header = 84, record = 50;
    if (content.size() < header) {
        throw ParseError{content.size(),
                         fmt::format("a binary STL has at least 84 bytes, this file has {}: it is cut off or no STL "
                                     "file, export the model again",
                                     content.size()),
                         false};
    }
    const std::size_t count = load<std::uint32_t>(content.data() + 80, Endian::little);
    const std::size_t room = (content.size() - header) / record;
    if (count > room) {
        throw ParseError{80,
                         fmt::format("the header announces {} triangles, but the file's {} bytes hold {}: it is cut "
                                     "off or damaged, export the model again",
                                     count, content.size(), room),
                         false};
    }
    if (const std::size_t rest = content.size() - header - count * record; rest > 0) {
        report.warnings.push_back(fmt::format("{} bytes after the last of {} triangles are ignored", rest, count));
    }
    VertexWelder welder(count / 2); // a closed mesh has half as many vertices as triangles
    PolygonSoup soup;
    soup.corners.reserve(3 * count);
    soup.ends.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
        const char* bytes = content.data() + header + t * record + 12;
        for (int k = 0; k < 3; ++k, bytes += 12) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] = load<float>(bytes + 4 * axis, Endian::little);
            }
            if (!p.allFinite()) {
                throw ParseError{static_cast<std::size_t>(bytes - content.data()),
                                 fmt::format("corner {} of triangle {} (counted from 0) is not a finite point: repair "
                                             "it or export the model again",
                                             k, t),
                                 false};
            }
            soup.corners.push_back(welder.index_of(p));
        }
        soup.close_polygon();
    }
    return finish(std::move(soup), welder, report);
}

} // namespace tapeline
