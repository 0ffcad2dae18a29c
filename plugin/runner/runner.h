// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/move.h"
#include "kernel/progress.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/preparation.h"

#include <string_view>

namespace tapeline {

/// Version of the program, "0.1.0".
std::string_view version();

/// What a job did.
struct JobOutcome {
    Preparation preparation;
    MoveResult move;
    Measures measures;
    std::vector<InnerLine> inner_lines; ///< other feature lines in the region
    std::vector<GateResult> gates;
    std::vector<std::string> warnings;                   ///< of all stages, in order
    std::vector<std::pair<std::string, double>> seconds; ///< per stage, in order
    std::string input_sha256;
};

/// The move's options as the job says. Fails (usage) on an unknown name.
MoveOptions move_options(const Job& job);

/// The failure of a move whose solver did not reach its tolerance: which side, by how much.
Error not_converged(const MoveResult& move);
/// The failure of a move that ended elsewhere from another start.
Error ambiguity(const MoveResult& move);

/// Runs one job from its files to its files: read, find the line, make the target, remesh, choose the region, move,
/// measure, write. All outputs are written together at the end, so a job that fails has touched none of them. A
/// solver that did not converge is a failure unless the job allows it; a missed quality gate is not (see
/// `gate_failure`): its outputs are written.
Result<JobOutcome> run_job(const Job& job, const Progress& progress = {});

/// `run_job` without its files: what `inputs` holds takes the place of those that the job names, and nothing is written
/// (`write_outputs` can do that later).
Result<JobOutcome> solve_job(const Job& job, const JobInputs& inputs, const Progress& progress = {});

/// The short table that `tapeline move` prints.
std::string outcome_table(const JobOutcome& outcome);

} // namespace tapeline
