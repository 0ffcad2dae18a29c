// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/runner.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tapeline {

/// Statistics of a job as JSON with stable keys; lengths mm, angles deg, times s, indices in the result mesh.
nlohmann::ordered_json stats_json(const Job& job, const JobOutcome& outcome);
std::string stats_text(const Job& job, const JobOutcome& outcome);

/// The parts of the statistics that describe a move.
nlohmann::ordered_json placement_json(const PlacementResult& placement);
nlohmann::ordered_json solve_json(const std::vector<SolveReport>& solves);
nlohmann::ordered_json uniqueness_json(const MoveResult& move); ///< null when it was not asked for
nlohmann::ordered_json retraction_json(const RetractionReport& retraction);
/// The word for a role in statistics and on pages.
const char* role_word(InnerLineRole role);
nlohmann::ordered_json inner_lines_json(const std::vector<InnerLine>& lines);
nlohmann::ordered_json exact_surface_json(const ExactSurfaceReport& exact);

/// What was found while reading a model.
nlohmann::ordered_json import_json(const ImportReport& report);
/// The same as a table for people; zero counts are left out.
std::string import_table(const ImportReport& report);

} // namespace tapeline
