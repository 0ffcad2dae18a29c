// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/move.h"
#include "kernel/progress.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/preparation.h"

#include <optional>
#include <string>
#include <vector>

namespace tapeline {

/// What one method made of the job.
struct MethodRun {
    std::string method;
    std::optional<MoveResult> move;     ///< none when the method failed
    Measures measures;                  ///< of `move`
    std::vector<InnerLine> inner_lines; ///< of `move`: other feature lines in the region
    std::vector<GateResult> gates;      ///< of the job's limits
    std::optional<Error> failure;       ///< why there is no result, or why the one there is cannot be trusted
    double seconds = 0;                 ///< of the move itself, on its share of the processors

    /// A result that may be ranked.
    bool sound() const { return move.has_value() && !failure; }
};

/// All methods on one job.
struct Comparison {
    Preparation preparation; ///< the same for all
    int threads_per_method = 1;
    std::vector<MethodRun> runs; ///< in the order asked for
    std::vector<int> ranking;    ///< sound runs, best first (see `rank_runs`)
    std::vector<std::string> warnings;
    std::vector<std::pair<std::string, double>> seconds; ///< per stage, in order
    std::string input_sha256;
};

/// The methods that the job's comparison names, all that there are when it names none. Fails (usage) when one is named
/// twice.
Result<std::vector<std::string>> compared_methods(const Job& job);

/// The job for one of the compared methods. What the job says about single steps of a method (retraction, extension
/// target, stiffness) holds for its own method; the others run as they are meant.
Job method_job(const Job& job, const std::string& method);

/// Prepares the job once, then runs every method on it, several at a time where processors allow, and measures the
/// results. A method that fails or does not converge is a run with a failure, not the end; only a job that cannot be
/// prepared and a cancelled one fail. Results do not depend on the number of threads. What `inputs` holds takes the
/// place of the job's files.
Result<Comparison> compare_methods(const Job& job, const Progress& progress = {}, const JobInputs& inputs = {});

/// Sound runs from best to worst: those that keep the job's limits first; then by flipped triangles; then on-surface
/// moves by bulge, where bulges within 0.1 % of the slide of the least one count as equal, by new inflections on both
/// sides and by squash, others by new inflections and changed curvature signs. Equal ones keep their order.
std::vector<int> rank_runs(const std::vector<MethodRun>& runs);

/// Who wins and by what, in one or two sentences.
std::string comparison_headline(const std::vector<MethodRun>& runs, const std::vector<int>& ranking);

/// The answer on the terminal.
std::string comparison_table(const Comparison& comparison);

} // namespace tapeline
