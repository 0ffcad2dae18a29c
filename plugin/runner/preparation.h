// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/model_file.h"
#include "kernel/extension.h"
#include "kernel/inner_lines.h"
#include "kernel/progress.h"
#include "kernel/region.h"
#include "plugin/runner/inputs.h"
#include "plugin/runner/stopwatch.h"
#include "plugin/runner/target_choice.h"

#include <optional>

namespace tapeline {

/// What remeshing did.
struct RemeshInfo {
    bool applied = false;
    double max_edge_mm = 0;
    double min_angle_before = 0; ///< over the region [deg]
    double min_angle_after = 0;
    int added_vertices = 0; ///< new ones minus dropped ones
    int projected = 0;
};

/// Everything that a move needs, from the files that the job names.
struct Preparation {
    ImportReport import;
    Model model;                         ///< as imported, or remeshed around the line
    FeatureLine line;                    ///< on `model`
    std::optional<TargetChoice> target;  ///< always there after `prepare`
    Region region;                       ///< on `model`
    std::vector<AppendedVertex> rim_cut; ///< vertices that cutting the region's rim added to `model`
    RemeshInfo remesh;
    std::vector<NamedLine> lines; ///< all feature lines, as they were before remeshing
    std::vector<std::string> warnings;
};

/// How to read the job's model. Fails (usage) on an unknown unit.
ImportOptions import_options(const ImportSettings& settings);

/// Length of one unit of mesh files [mm].
double unit_length_mm(const std::string& unit);

/// The first half of `prepare`: a target line for the job, on the model as imported or, where the line is slid or laid
/// on a CAD surface, on its remeshed surroundings, which lie closer to the exact surface. Leaves `region` empty.
Result<Preparation> prepare_target(const Job& job, Stopwatch& watch, const Progress& progress,
                                   const JobInputs& inputs = {});

/// Reads the model, finds and picks the line, makes the target, remeshes where asked or needed, and chooses the region.
/// Stages that were run are added to `watch`. What `inputs` holds takes the place of the job's files.
Result<Preparation> prepare(const Job& job, Stopwatch& watch, const Progress& progress, const JobInputs& inputs = {});

} // namespace tapeline
