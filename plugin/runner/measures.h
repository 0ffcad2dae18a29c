// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/move.h"
#include "kernel/quality.h"
#include "plugin/runner/job.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tapeline {

/// How a move was solved.
struct SolverMeasures {
    std::string method;
    int iterations = 0;                  ///< of all solver runs
    double error_estimate_mm = 0;        ///< largest of all solver runs
    std::optional<double> uniqueness_mm; ///< distance between the answers from two starts, when asked for
};

/// What `tapeline move` and `tapeline check` know about a result. Measures that need something that is not there (the
/// target, the same triangles before and after) are missing, and `omitted` says why.
struct Measures {
    QualityReport quality;
    bool has_line = false;                         ///< a line is known: crease, squash, sections
    bool has_target = false;                       ///< a target is known: line error
    bool has_rest = false;                         ///< same vertices and triangles before and after
    bool has_compressed = false;                   ///< a compressed side is known: bulge
    std::optional<double> surface_distance_max_mm; ///< of moved vertices to the surface before, without the others
    std::optional<double> surface_distance_rms_mm;
    BulgeReference surface_distance_reference = BulgeReference::triangles;
    std::optional<SolverMeasures> solver; ///< of a move, not of a check
    std::vector<std::string> omitted;
};

/// Measures 1-7 as JSON with stable keys; missing ones are null. Lengths mm, angles deg.
nlohmann::ordered_json measures_json(const Measures& measures);

/// The same for people: rows of measure, before, after, the first one with these words.
std::vector<std::vector<std::string>> measure_rows(const Measures& measures);
/// The rows as a table.
std::string measures_table(const Measures& measures);

/// One limit that was asked for.
struct GateResult {
    std::string name; ///< job key, e.g. "max_bulge"
    double limit = 0;
    std::optional<double> value; ///< missing when the measure is
    bool passed = false;
};
std::vector<GateResult> evaluate_gates(const GateSettings& settings, const Measures& measures);

/// The failure to report when a limit is missed: names every missed one with its value.
std::optional<Error> gate_failure(const std::vector<GateResult>& gates);

nlohmann::ordered_json gates_json(const std::vector<GateResult>& gates);

SolverMeasures solver_measures(const MoveResult& move);

/// What to measure for a finished move: the sides as the move cut them, or grown from the line when it did not.
QualityInput quality_input(const MoveResult& move, const TargetCurve& target);

/// Measures a finished move.
Result<Measures> measure_move(const MoveResult& move, const TargetCurve& target);

/// Text in columns: the first left-aligned, the others right-aligned.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

} // namespace tapeline
