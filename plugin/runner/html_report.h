// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/page.h"
#include "plugin/runner/runner.h"

namespace tapeline {

/// What a page says of the job and of what all its results share: input, line, slide, region.
std::vector<std::pair<std::string, std::string>> job_facts(const Job& job, const Preparation& preparation,
                                                           const MoveResult* move);

/// What a page calls the job's model: its file, where it was read from one.
std::string model_name(const Job& job);

/// What a method is, in one line.
std::string method_title(const std::string& method);

/// How to read the measures of a page.
std::vector<std::string> reading_notes();

/// The page of one move (see page_html), from the pictures that `draw_move` made on that stage.
std::string html_report(const Job& job, const JobOutcome& outcome, const std::vector<Picture>& pictures,
                        const Stage& stage);

} // namespace tapeline
