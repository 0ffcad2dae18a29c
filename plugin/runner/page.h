// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/inner_lines.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/pictures.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapeline {

/// One result on a page.
struct PageEntry {
    std::string name;                 ///< of the method
    std::string title;                ///< what the method is, in one line
    const MoveResult* move = nullptr; ///< null: there is none
    const Measures* measures = nullptr;
    std::vector<InnerLine> inner_lines; ///< other feature lines in the region
    std::string verdict;                ///< in two or three words
    std::string missed;                 ///< names of limits that are missed
    std::string reason;                 ///< why the result is missing or not to be trusted; empty when it is sound
    bool sound = true;                  ///< may be marked as the best
    double seconds = 0;
    std::vector<Picture> pictures; ///< of the state after
    std::optional<Picture> sections;
};

/// What a page shows: one result, or several beside each other. Texts are plain, the page escapes them.
struct Page {
    std::string title;
    std::string headline; ///< one or two sentences
    std::string description;
    std::vector<std::pair<std::string, std::string>> facts;
    std::vector<PageEntry> entries; ///< best first
    std::vector<Picture> before;    ///< of the state that all started from
    const TargetCurve* target = nullptr;
    const Stage* stage = nullptr;
    std::vector<std::string> warnings;
    std::vector<std::string> notes; ///< how to read the numbers
    std::string footer;
};

/// One self-contained HTML page: headline, table of measures, a view to turn, pictures and sections. It needs no
/// network; without JavaScript or WebGL only the view to turn is missing.
std::string page_html(const Page& page);

} // namespace tapeline
