// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_readers.h"
#include "io/text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

/// What OBJ may hold beside vertices and faces and what we pass over: normals, texture, grouping, display, points and
/// polylines.
constexpr std::array<std::string_view, 22> passed_over{
    "vn",    "vt",       "g",        "o",      "s",      "usemtl",     "mtllib",    "mg",    "l",     "p",   "lod",
    "bevel", "c_interp", "d_interp", "maplib", "usemap", "shadow_obj", "trace_obj", "ctech", "stech", "deg", "cstype"};
/// Keywords of OBJ's own curves and surfaces.
constexpr std::array<std::string_view, 16> free_form{"vp",   "curv", "curv2", "surf", "bmat", "step", "parm", "trim",
                                                     "hole", "scrv", "sp",    "end",  "con",  "bzp",  "bsp",  "res"};

class ObjReader {
public:
    ObjReader(std::string_view content, ImportReport& report) : scanner_(content), report_(report) {}

    PolygonSoup read()
    {
        std::string_view line;
        while (scanner_.next_filled_line(line)) {
            const std::size_t start = scanner_.line_start();
            line = join_continued(line);
            const auto keyword = take_word(line);
            if (keyword == "v") {
                soup_.points.push_back(scanner_.point(line, soup_.points.size()));
            } else if (keyword == "f" || keyword == "fo") {
                read_face(line, start);
            } else {
                note_other(keyword, start);
            }
        }
        finish();
        return std::move(soup_);
    }

private:
    /// A line that ends in a backslash goes on in the next one.
    std::string_view join_continued(std::string_view line)
    {
        const auto continues = [&line] {
            return line.find_last_not_of(" \t") != std::string_view::npos && line[line.find_last_not_of(" \t")] == '\\';
        };
        if (!continues() || line[0] == '#') {
            return line;
        }
        joined_.clear();
        do {
            joined_.append(line.substr(0, line.find_last_not_of(" \t"))).append(" ");
            if (!scanner_.next_line(line)) {
                return joined_;
            }
        } while (continues());
        joined_.append(line);
        return joined_;
    }

    void read_face(std::string_view line, std::size_t start)
    {
        for (auto word = take_word(line); !word.empty(); word = take_word(line)) {
            soup_.corners.push_back(vertex_of(word, start));
        }
        if (soup_.corners.size() == (soup_.ends.empty() ? 0 : soup_.ends.back())) {
            throw ParseError{start,
                             fmt::format("face {} (counted from 0) has no corners: remove it or export the model "
                                         "again",
                                         soup_.size())};
        }
        soup_.close_polygon();
    }

    /// The vertex of i, i/t, i//n or i/t/n. Later vertices may be named, so positive ones are checked at the end.
    int vertex_of(std::string_view word, std::size_t start)
    {
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
        const auto rest = word.substr(static_cast<std::size_t>(end - word.data()));
        if (error != std::errc() || (!rest.empty() && rest[0] != '/') ||
            rest.find_first_not_of("/-0123456789") != std::string_view::npos) {
            throw ParseError{start, fmt::format("face corner {} is not of the form 1, 1/2, 1//3 or 1/2/3: correct it",
                                                in_quotes(word))};
        }
        const auto defined = static_cast<std::int64_t>(soup_.points.size());
        if (index == 0 || index < -defined || index > std::numeric_limits<int>::max()) {
            throw ParseError{start, fmt::format("face corner {} names no vertex ({} are defined so far, the first is "
                                                "1, the last -1): correct it or export the model again",
                                                in_quotes(word), defined)};
        }
        if (index > largest_) {
            largest_ = index;
            largest_at_ = start;
        }
        return static_cast<int>(index > 0 ? index - 1 : defined + index);
    }

    void note_other(std::string_view keyword, std::size_t start)
    {
        if (std::ranges::find(passed_over, keyword) != passed_over.end()) {
            return;
        }
        if (std::ranges::find(free_form, keyword) != free_form.end()) {
            ++free_form_lines_;
        } else if (unknown_++ == 0) {
            first_unknown_ = keyword;
            unknown_at_ = start;
        }
    }

    void finish()
    {
        if (largest_ > static_cast<std::int64_t>(soup_.points.size())) {
            throw ParseError{largest_at_, fmt::format("the face names vertex {}, but the file has {}: correct it or "
                                                      "export the model again",
                                                      largest_, soup_.points.size())};
        }
        if (free_form_lines_ > 0) {
            report_.warnings.push_back(fmt::format("{} lines about free-form curves and surfaces are ignored, only "
                                                   "polygons are read: export STEP for exact surfaces",
                                                   free_form_lines_));
        }
        if (unknown_ > 0) {
            report_.warnings.push_back(
                fmt::format("{} lines with unknown keywords are ignored, the first is line {}: {}", unknown_,
                            line_number(scanner_.text(), unknown_at_), in_quotes(first_unknown_)));
        }
    }

    TextScanner scanner_;
    ImportReport& report_;
    PolygonSoup soup_;
    std::string joined_;
    std::int64_t largest_ = 0;
    std::size_t largest_at_ = 0;
    int free_form_lines_ = 0, unknown_ = 0;
    std::string first_unknown_;
    std::size_t unknown_at_ = 0;
};

} // namespace

PolygonSoup read_obj(std::string_view content, ImportReport& report) { return ObjReader(content, report).read(); }

} // namespace tapeline
