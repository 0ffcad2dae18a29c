// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/python/values.h"
#include "plugin/runner/inputs.h"
#include "plugin/runner/placing.h"
#include "plugin/runner/runner.h"

#include <map>
#include <mutex>

namespace tapeline::python {

/// tapeline.Model
struct ModelObject {
    std::shared_ptr<const HeldModel> held;
    const Model& model() const { return held->imported.model; }
    py::capsule owner() const { return keep(held); }
};

/// tapeline.FeatureLine
struct LineObject {
    std::shared_ptr<const HeldModel> model;
    HeldLine held;
    const Model& model_of_vertices() const { return held.refined ? *held.refined : model->imported.model; }
};

/// tapeline.TargetLine
struct TargetObject {
    TargetLine line;
    std::optional<double> fit_error_mm = {};
};

/// tapeline.Region: what a job would move.
struct RegionObject {
    std::shared_ptr<const Placing> placing;
    std::shared_ptr<const HeldModel> model; ///< placing->preparation.model, moved there
};

/// A job with what it takes from memory.
struct BoundJob {
    Job job;
    JobInputs inputs;
};

/// The job of a model, a line, a target (None: the keywords say it) and keywords of the given sections.
BoundJob bind_job(const ModelObject& model, const LineObject& line, const py::object& target,
                  const py::kwargs& keywords, std::initializer_list<std::string_view> sections);

/// A job file, or the same as a dict (names count from the current folder).
Job job_of(const py::object& job);

/// tapeline.MoveResult
struct ResultObject {
    Job job;
    JobInputs inputs;
    std::shared_ptr<const JobOutcome> outcome;
    std::shared_ptr<const QualityMaps> maps = {}; ///< made when first asked for
};

/// The sections across the moved line, from one end to the other: per section a dict of `compressed_before`,
/// `compressed_after`, `tension_before` and `tension_after`, each with `points` (n×3 [mm], from the line outwards),
/// `curvature` (n×3 [1/mm], towards the centre) and `inflections` (k×3 [mm]).
py::list sections_of(const ResultObject& result, int stations);

void add_models(py::module_& module);
void add_targets(py::module_& module);
void add_moves(py::module_& module);
void add_edits(py::module_& module);
void add_comparisons(py::module_& module);

} // namespace tapeline::python
