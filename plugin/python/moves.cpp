// SPDX-License-Identifier: GPL-3.0-or-later
// move, its result, and whole jobs.
#include "plugin/python/call.h"
#include "plugin/python/objects.h"
#include "plugin/runner/job_file.h"
#include "plugin/runner/job_outputs.h"
#include "plugin/runner/job_saving.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/keywords.h"
#include "plugin/runner/stats.h"

#include <fmt/format.h>

namespace tapeline::python {

namespace {

ResultObject move(const ModelObject& model, const LineObject& line, const py::object& target, py::object progress,
                  py::object cancel, const py::object& threads, const py::kwargs& keywords)
{
    BoundJob bound = bind_job(model, line, target, keywords, {"target", "remesh", "region", "move", "gate"});
    auto outcome = Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
        return solve_job(bound.job, bound.inputs, watched);
    });
    return {std::move(bound.job), std::move(bound.inputs), std::make_shared<JobOutcome>(std::move(outcome))};
}

void save_result_job(const ResultObject& self, const py::object& path, const py::object& target_path)
{
    const std::string name = path_text(path);
    const std::string target_name = target_path.is_none() ? "" : path_text(target_path);
    without_gil([&] { return save_job(self.job, self.inputs, name, target_name); });
}

void write(const ResultObject& self, const py::object& path, py::object progress, py::object cancel,
           const py::object& threads, const py::kwargs& keywords)
{
    Job job = self.job;
    job.outputs = {};
    if (!path.is_none()) {
        keywords["out"] = path; // the dictionary is this call's own
    }
    value(set_keywords(job, json_of(keywords), {"outputs"}));
    Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
        return check_output_names(job).and_then([&] {
            JobOutcome outcome = *self.outcome;
            Stopwatch watch;
            for (const auto& [stage, seconds] : outcome.seconds) {
                watch.add(stage, seconds);
            }
            return write_outputs(job, outcome, watch, watched);
        });
    });
}

py::dict maps(ResultObject& self)
{
    const JobOutcome& o = *self.outcome;
    if (!self.maps) {
        self.maps = without_gil([&]() -> Result<std::shared_ptr<const QualityMaps>> {
            return std::make_shared<QualityMaps>(quality_maps(quality_input(o.move, o.preparation.target->line)));
        });
    }
    const Eigen::VectorXd moved = (o.move.V - o.move.rest.mesh.V).rowwise().norm();
    py::dict dict;
    dict["displacement"] = copied(std::span<const double>(moved.data(), static_cast<std::size_t>(moved.size())));
    const py::capsule owner = keep(self.maps);
    dict["distance_to_original"] = shown(self.maps->bulge_mm, owner);
    dict["gaussian_before"] = shown(self.maps->gauss_before, owner);
    dict["gaussian_after"] = shown(self.maps->gauss_after, owner);
    dict["mean_before"] = shown(self.maps->mean_before, owner);
    dict["mean_after"] = shown(self.maps->mean_after, owner);
    return dict;
}

/// A model of the result for the next move, as reading the written mesh would give it.
ModelObject moved_model(const ResultObject& self)
{
    return {without_gil([&] {
        const MoveResult& move = self.outcome->move;
        ImportSettings settings;
        settings.units = self.job.import.units;
        // Divided here and multiplied there, as writing and reading do.
        return hold_mesh(Mesh{move.V / unit_length_mm(settings.units), move.rest.mesh.F}, settings);
    })};
}

ModelObject rest_model(const ResultObject& self)
{
    auto held = std::make_shared<HeldModel>();
    held->imported = {self.outcome->move.rest, self.outcome->preparation.import};
    held->settings = self.job.import;
    return {std::move(held)};
}

const MoveResult& of(const ResultObject& self) { return self.outcome->move; }
py::capsule owner(const ResultObject& self) { return keep(self.outcome); }

py::array side_faces(const ResultObject& self, bool compressed)
{
    const QualityInput input = quality_input(of(self), self.outcome->preparation.target->line);
    return copied(compressed ? input.compressed_faces : input.tension_faces);
}

void add_result(py::module_& module)
{
    py::class_<ResultObject>(
        module, "MoveResult",
        "A moved model. Vertex i is vertex i of the model as it was prepared; appended ones come last.")
        .def_property_readonly(
            "vertices", [](const ResultObject& self) { return shown(of(self).V, owner(self)); },
            "(n, 3) float64 [mm], moved positions; outside the region equal to rest_vertices to the bit.")
        .def_property_readonly(
            "rest_vertices", [](const ResultObject& self) { return shown(of(self).rest.mesh.V, owner(self)); },
            "(n, 3) float64 [mm], the same vertices before the move.")
        .def_property_readonly(
            "faces", [](const ResultObject& self) { return shown(of(self).rest.mesh.F, owner(self)); },
            "(m, 3) int32, triangles of both.")
        .def_property_readonly(
            "line_vertices",
            [](const ResultObject& self) { return shown(of(self).correspondence.line.vertices, owner(self)); },
            "(k,) int32, vertices of the moved line, in order.")
        .def_property_readonly(
            "region_faces", [](const ResultObject& self) { return shown(of(self).region.faces, owner(self)); },
            "(f,) int32, triangles that could move.")
        .def_property_readonly(
            "tension_faces", [](const ResultObject& self) { return side_faces(self, false); },
            "Region triangles that were stretched.")
        .def_property_readonly(
            "compression_faces", [](const ResultObject& self) { return side_faces(self, true); },
            "Region triangles that made room; none off the surface.")
        .def_property_readonly(
            "target", [](const ResultObject& self) { return TargetObject{self.outcome->preparation.target->line}; },
            "TargetLine, the goal that was used.")
        .def_property_readonly("rest", &rest_model,
                               "Model before the move, with the same vertices and triangles as the result.")
        .def_property_readonly(
            "moved", &moved_model,
            "Model of the result, for the next move of a chain: what reading the written mesh would give.")
        .def_property_readonly(
            "stats", [](const ResultObject& self) { return object_of(stats_json(self.job, *self.outcome)); },
            "dict, what `tapeline move --stats` writes. Lengths mm, angles deg, times s.")
        .def_property_readonly(
            "measures", [](const ResultObject& self) { return object_of(measures_json(self.outcome->measures)); },
            "dict of the measures before and after; None where a measure does not apply.")
        .def_property_readonly(
            "gates", [](const ResultObject& self) { return object_of(gates_json(self.outcome->gates)); },
            "list of dict: name, limit, value and passed, of the limits given as keywords of section gate.")
        .def_property_readonly(
            "table", [](const ResultObject& self) { return outcome_table(*self.outcome); },
            "str, the table that `tapeline move` prints.")
        .def_property_readonly(
            "warnings", [](const ResultObject& self) { return self.outcome->warnings; }, "list of sentences.")
        .def_property_readonly(
            "maps", &maps,
            "dict of (n,) float64, NaN outside the region: displacement [mm], distance_to_original [mm], "
            "gaussian_before and gaussian_after [1/mm2], mean_before and mean_after [1/mm].")
        .def("sections", &sections_of, py::arg("stations") = 9,
             "list of dict, sections normal to the moved line at equal steps: compressed_before, compressed_after, "
             "tension_before and tension_after, each a dict of points (n, 3) [mm], curvature (n, 3), the comb's teeth "
             "[1/mm], and inflections (k, 3) [mm].")
        .def("save_job", &save_result_job, py::arg("path"), py::arg("target_path") = py::none(),
             "Writes the job file that `tapeline run` repeats to the same bytes, and beside it what it needs: "
             "NAME.target.json (or `target_path`), for a line given by vertices NAME.line.txt, for a model "
             "from arrays NAME.model.obj in its unit.")
        .def("write", &write, py::arg("path") = py::none(), py::kw_only(), py::arg("progress") = py::none(),
             py::arg("cancel") = py::none(), py::arg("threads") = 0,
             "Writes the result to `path` and to the keywords of section outputs (rest, stats, report, "
             "pictures, line_vertices, save_target, ascii), all or none.");
}

py::object run_file(const py::object& job, py::object progress, py::object cancel, const py::object& threads)
{
    const Job read = job_of(job);
    const JobOutcome outcome = Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
        return run_job(read, watched);
    });
    return object_of(stats_json(read, outcome));
}

} // namespace

Job job_of(const py::object& job)
{
    Job read = py::isinstance<py::dict>(job) ? value(parse_job(json_text(json_of(job)), "the job", {}))
                                             : value(read_job(path_text(job)));
    if (read.input.empty()) {
        raise({ErrorKind::usage, "the job's key 'input' is missing; name the model file"});
    }
    return read;
}

void add_moves(py::module_& module)
{
    add_result(module);
    module.def("move", &move, py::arg("model"), py::arg("line"), py::arg("target") = py::none(), py::kw_only(),
               py::arg("progress") = py::none(), py::arg("cancel") = py::none(), py::arg("threads") = 0,
               "Moves the line to the target (None: keywords such as slide say it), as `tapeline move`: the "
               "same input gives the same bytes. Keywords: sections target, remesh, region, move and gate. A "
               "missed gate is no error; see MoveResult.gates.");
    module.def("run_job", &run_file, py::arg("job"), py::kw_only(), py::arg("progress") = py::none(),
               py::arg("cancel") = py::none(), py::arg("threads") = 0,
               "Runs a job file, or the same as a dict (names count from the current folder), with all its "
               "outputs, as `tapeline run`; returns its statistics.");
}

} // namespace tapeline::python
