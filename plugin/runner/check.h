// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/progress.h"
#include "plugin/runner/inputs.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/move_record.h"

namespace tapeline {

/// What `tapeline check` found.
struct CheckOutcome {
    Measures measures;
    std::vector<GateResult> gates;
    std::string match;           ///< how vertices before and after were matched
    std::vector<int> line;       ///< vertices of the checked line
    std::string compressed_side; ///< "left", "right" or "none"
    std::vector<std::string> warnings;
};

/// What a check takes from memory instead of from the files that its job names; what is empty is read.
struct CheckInputs {
    std::shared_ptr<const HeldModel> after, before; ///< instead of job.input and job.command.against
    std::vector<int> line;                          ///< instead of job.command.line_vertices
    std::optional<TargetLine> target;               ///< instead of job.target.target
    std::optional<MoveRecord> record;               ///< instead of job.command.stats
};

/// Measures the mesh job.input, the result of a move, against job.command.against, the model before. The line comes
/// from a vertex list, from the move's statistics, from a line number, or is the feature line that moved most; the
/// compressed side from the options, the statistics, or the displacement's sign. Measures that need what is not there
/// are left out and named in `measures.omitted`.
Result<CheckOutcome> check_result(const Job& job, const Progress& progress = {}, const CheckInputs& inputs = {});

/// The outcome as JSON text.
std::string check_json(const CheckOutcome& outcome);

} // namespace tapeline
