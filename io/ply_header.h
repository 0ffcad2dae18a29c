// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tapeline {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of one value in a binary file.
std::size_t size_of(PlyType type);
inline bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32; ///< of the value, or of a list's items
    bool list = false;
    PlyType count_type = PlyType::uint8; ///< lists: of the length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the named property, -1 = none.
    int find(std::string_view property) const;
};

enum class PlyFormat { ascii, little, big };

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0; ///< first byte of the data
};

/// Reads a PLY header up to and with "end_header" and its line end (the one that the line "ply" has).
/// Throws ParseError (io/text_scanner.h) at unknown keywords, types and formats, doubled elements or properties.
/// Counts are as written, not yet held against the file's size.
PlyHeader read_ply_header(std::string_view content);

} // namespace tapeline
