// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/target_line.h"
#include "io/model_file.h"
#include "kernel/feature_lines.h"
#include "kernel/progress.h"
#include "plugin/runner/job.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tapeline {

class PreparationMemory;

/// A model kept in memory for many jobs, with what a job file would say of it.
struct HeldModel {
    ImportedModel imported;
    std::filesystem::path path; ///< where it was read from; empty when it was given as arrays
    ImportSettings settings;
    std::string sha256; ///< of the file; empty for arrays
};

/// A feature line of a held model and how a job file would name it.
struct HeldLine {
    FeatureLine line;      ///< on the model as imported
    LineSettings settings; ///< how lines were found; `settings.line` is the selector, or empty: the vertices themselves
    std::shared_ptr<const Model> refined = {}; ///< where a part needs more vertices than the model has on its long
                                               ///< edges: the model with them, which come last

    /// The vertices in order; of a closed line the first one again at the end, as `line_through` takes them.
    std::vector<int> chain() const;
};

/// What a job takes from memory instead of from the files that it names. Everything after that is the same, so the
/// same model, line and target give the same bytes either way.
///
/// `memory` is for jobs that differ in nothing but the target, one after the other or at once.
struct JobInputs {
    std::shared_ptr<const HeldModel> model;    ///< instead of Job::input
    std::vector<int> line;                     ///< chain of vertices instead of lines.line
    std::optional<TargetLine> target;          ///< instead of target.target
    std::shared_ptr<PreparationMemory> memory; ///< of steps that need not be done again; none is fine
};

/// Reads a model from a file to hold it.
Result<std::shared_ptr<const HeldModel>> hold_model(const std::filesystem::path& path, const ImportSettings& settings,
                                                    const Progress& progress = {});
/// Holds a mesh given as arrays, in `settings.units`, repaired as a mesh file would be.
Result<std::shared_ptr<const HeldModel>> hold_mesh(Mesh mesh, const ImportSettings& settings);

/// The model's feature lines, longest first, as `tapeline lines` finds them.
std::vector<HeldLine> held_lines(const HeldModel& model, const LineSettings& settings);
/// A chain of vertices as a line: rejected when an index does not exist, otherwise as `line_through` says.
Result<HeldLine> held_chain(const HeldModel& model, std::vector<int> vertices, const LineSettings& settings);
/// The part FROM..TO of a whole line, each in mm or %, as in "0@FROM..TO", chosen as a job chooses it (see
/// `refine_before_choice`); fails as `select_line` does.
Result<HeldLine> held_part(const HeldModel& model, const HeldLine& line, const std::string& from, const std::string& to,
                           const RemeshSettings& remesh = {});

/// Fills in what a job says of a held model and line, and puts what has no name in a file into the inputs.
JobInputs use_held(Job& job, std::shared_ptr<const HeldModel> model, const HeldLine& line,
                   std::optional<TargetLine> target);

} // namespace tapeline
