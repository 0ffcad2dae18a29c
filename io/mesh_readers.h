// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/file_format.h"
#include "io/model_file.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace tapeline {

/// Polygons as a mesh file lists them: any number of corners each, points in the file's order and unit.
struct PolygonSoup {
    std::vector<Vec3> points;
    std::vector<int> corners;      ///< point indices of all polygons, one polygon after the other; all in range
    std::vector<std::size_t> ends; ///< for each polygon the end of its corners

    std::size_t size() const { return ends.size(); }
    std::span<const int> polygon(std::size_t i) const
    {
        const std::size_t begin = i == 0 ? 0 : ends[i - 1];
        return {corners.data() + begin, ends[i] - begin};
    }
    void close_polygon() { ends.push_back(corners.size()); }
};

/// The readers behind `read_mesh`, one per format, on the whole content of a file. Each checks every count against
/// the bytes that are there before it allocates, and writes what is worth knowing to the report. Only for
/// `read_mesh`: they throw ParseError (io/text_scanner.h), std::length_error and std::bad_alloc.
PolygonSoup read_stl_ascii(std::string_view content, ImportReport& report);
PolygonSoup read_stl_binary(std::string_view content, ImportReport& report);
PolygonSoup read_obj(std::string_view content, ImportReport& report);
PolygonSoup read_off(std::string_view content, ImportReport& report);
/// PLY in all three encodings.
PolygonSoup read_ply(std::string_view content, ImportReport& report);

/// `read_mesh` on bytes that are in memory already. name: for messages, and its ending for `sniff_format`.
Result<ImportedModel> read_mesh_content(std::string_view name, std::string_view content,
                                        const ImportOptions& options = {});

} // namespace tapeline
