// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes.h"
#include "io/mesh_readers.h"
#include "io/ply_header.h"
#include "io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

/// The data of an ASCII file: one line for each row of an element.
class TextRows {
public:
    explicit TextRows(std::string_view content, std::size_t start) : scanner_(content, start) {}

    std::size_t room_for(const PlyElement& element) const
    {
        return (scanner_.bytes_left() + 1) / (2 * element.properties.size());
    }
    void begin_row()
    {
        if (!scanner_.next_filled_line(line_)) {
            fail_here("the data end here: the file is cut off, export the model again");
        }
    }
    void end_row()
    {
        if (!take_word(line_).empty()) {
            fail_here("the line has more values than the header says: correct it or export the model again");
        }
    }
    double real(PlyType) { return scanner_.number(take_word(line_), "a value"); }
    std::int64_t integer(PlyType) { return scanner_.integer(take_word(line_), "a value"); }
    std::size_t room_for_items(PlyType) const { return (line_.size() + 1) / 2; }
    void skip(PlyType, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (take_word(line_).empty()) {
                fail_here("the line has fewer values than the header says: correct it or export the model again");
            }
        }
    }
    [[noreturn]] void fail_here(std::string message) const { scanner_.fail_here(std::move(message)); }

private:
    TextScanner scanner_;
    std::string_view line_;
};

/// The data of a binary file.
class BinaryRows {
public:
    BinaryRows(std::string_view content, std::size_t start, Endian order) : content_(content), at_(start), order_(order)
    {
    }

    std::size_t room_for(const PlyElement& element) const
    {
        std::size_t row = 0;
        for (const auto& property : element.properties) {
            row += size_of(property.list ? property.count_type : property.type);
        }
        return bytes_left() / std::max<std::size_t>(row, 1);
    }
    void begin_row() {}
    void end_row() {}
    double real(PlyType type)
    {
        const char* bytes = take(type);
        return type == PlyType::float64   ? load<double>(bytes, order_)
               : type == PlyType::float32 ? load<float>(bytes, order_)
                                          : static_cast<double>(whole(bytes, type));
    }
    std::int64_t integer(PlyType type) { return whole(take(type), type); }
    std::size_t room_for_items(PlyType type) const { return bytes_left() / size_of(type); }
    void skip(PlyType type, std::size_t count)
    {
        if (count > room_for_items(type)) {
            fail_here("the data end here: the file is cut off, export the model again");
        }
        at_ += count * size_of(type);
    }
    [[noreturn]] void fail_here(std::string message) const { throw ParseError{at_, std::move(message), false}; }

private:
    std::size_t bytes_left() const { return content_.size() - at_; }
    const char* take(PlyType type)
    {
        const char* bytes = content_.data() + at_;
        skip(type, 1);
        return bytes;
    }
    std::int64_t whole(const char* bytes, PlyType type) const
    {
        switch (type) {
        case PlyType::int8:
            return static_cast<signed char>(*bytes);
        case PlyType::uint8:
            return static_cast<unsigned char>(*bytes);
        case PlyType::int16:
            return load<std::int16_t>(bytes, order_);
        case PlyType::uint16:
            return load<std::uint16_t>(bytes, order_);
        case PlyType::int32:
            return load<std::int32_t>(bytes, order_);
        default:
            return load<std::uint32_t>(bytes, order_);
        }
    }

    std::string_view content_;
    std::size_t at_;
    Endian order_;
};

template <class Rows>
std::size_t list_length(Rows& rows, const PlyProperty& property)
{
    const std::int64_t length = rows.integer(property.count_type);
    if (length < 0 || static_cast<std::uint64_t>(length) > rows.room_for_items(property.type)) {
        rows.fail_here(fmt::format("list {} announces {} items, more than there is room for: the file is cut off or "
                                   "damaged, export the model again",
                                   in_quotes(property.name), length));
    }
    return static_cast<std::size_t>(length);
}

template <class Rows>
void skip_property(Rows& rows, const PlyProperty& property)
{
    rows.skip(property.type, property.list ? list_length(rows, property) : 1);
}

template <class Rows>
void read_vertices(Rows& rows, const PlyElement& element, PolygonSoup& soup)
{
    std::vector<int> axis_of(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
        const int found = element.find(std::string_view("xyz").substr(axis, 1));
        if (found < 0 || element.properties[found].list) {
            rows.fail_here(fmt::format("the vertices have no property {}: correct the header", "xyz"[axis]));
        }
        axis_of[found] = axis;
    }
    soup.points.reserve(element.count);
    for (std::size_t v = 0; v < element.count; ++v) {
        rows.begin_row();
        Vec3 p;
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (axis_of[k] < 0) {
                skip_property(rows, property);
                continue;
            }
            p[axis_of[k]] = rows.real(property.type);
            if (!std::isfinite(p[axis_of[k]])) {
                rows.fail_here(fmt::format("{} of vertex {} (counted from 0) is not a finite number: correct it or "
                                           "export the model again",
                                           "xyz"[axis_of[k]], v));
            }
        }
        rows.end_row();
        soup.points.push_back(p);
    }
}

template <class Rows>
void read_faces(Rows& rows, const PlyElement& element, std::uint64_t vertices, PolygonSoup& soup)
{
    const int plural = element.find("vertex_indices");
    const int list = plural >= 0 ? plural : element.find("vertex_index");
    if (list < 0 || !element.properties[list].list || !is_integer(element.properties[list].type)) {
        rows.fail_here(
            "the faces have no list of whole numbers named vertex_indices or vertex_index: correct the header");
    }
    soup.ends.reserve(element.count);
    for (std::size_t f = 0; f < element.count; ++f) {
        rows.begin_row();
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (static_cast<int>(k) != list) {
                skip_property(rows, property);
                continue;
            }
            const std::size_t corners = list_length(rows, property);
            for (std::size_t i = 0; i < corners; ++i) {
                const std::int64_t index = rows.integer(property.type);
                if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
                    rows.fail_here(fmt::format("face {} (counted from 0) names vertex {}, but there are {}, counted "
                                               "from 0: correct it or export the model again",
                                               f, index, vertices));
                }
                soup.corners.push_back(static_cast<int>(index));
            }
        }
        rows.end_row();
        soup.close_polygon();
    }
}

template <class Rows>
PolygonSoup read_elements(Rows rows, const PlyHeader& header)
{
    PolygonSoup soup;
    std::uint64_t vertices = 0;
    for (const PlyElement& element : header.elements) {
        vertices = element.name == "vertex" ? element.count : vertices;
    }
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty() || element.count == 0) {
            continue;
        }
        if (element.count > std::numeric_limits<int>::max() || element.count > rows.room_for(element)) {
            rows.fail_here(fmt::format("the header announces {} rows of element {}, more than the file can hold: it is "
                                       "cut off or damaged, export the model again",
                                       element.count, in_quotes(element.name)));
        }
        if (element.name == "vertex") {
            read_vertices(rows, element, soup);
        } else if (element.name == "face") {
            read_faces(rows, element, vertices, soup);
        } else if (element.name == "tristrips") {
            rows.fail_here("the file holds triangle strips, which are not supported: save it with faces");
        } else {
            for (std::size_t i = 0; i < element.count; ++i) {
                rows.begin_row();
                for (const PlyProperty& property : element.properties) {
                    skip_property(rows, property);
                }
                rows.end_row();
            }
        }
    }
    if (soup.points.size() != vertices) {
        rows.fail_here("the vertices are announced without properties: correct the header");
    }
    return soup;
}

} // namespace

PolygonSoup read_ply(std::string_view content, ImportReport&)
{
    const PlyHeader header = read_ply_header(content);
    switch (header.format) {
    case PlyFormat::little:
        return read_elements(BinaryRows(content, header.size, Endian::little), header);
    case PlyFormat::big:
        return read_elements(BinaryRows(content, header.size, Endian::big), header);
    case PlyFormat::ascii:
        break;
    }
    return read_elements(TextRows(content, header.size), header);
}

} // namespace tapeline
