// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/page.h"

#include <string>

/// Inside of page: its pieces, each ready HTML, SVG or JSON.
namespace tapeline::page {

/// The first entry that has a result, or null.
const PageEntry* leading(const Page& page);

/// The table of measures, one row an entry and one for the state before; the best of each column is marked.
std::string measures_table(const Page& page);

/// The same measures for one result, one row a measure.
std::string measures_list(const Measures& measures);

/// Other feature lines of one result, one row a line; nothing where there are none.
std::string inner_lines_list(const std::vector<InnerLine>& lines);

/// Sections of all entries over each other at three places of the line, the state before dotted.
std::string sections_svg(const Page& page);
/// Colour of an entry in the sections, "#rrggbb".
std::string entry_colour(std::size_t entry);

/// What the view to turn shows, as JSON: meshes as base64 of little-endian arrays (float32, uint16 or uint32, int8).
std::string scene_json(const Page& page);

} // namespace tapeline::page
