// SPDX-License-Identifier: GPL-3.0-or-later
// compare and check.
#include "plugin/python/call.h"
#include "plugin/python/objects.h"
#include "plugin/runner/check.h"
#include "plugin/runner/compare_outputs.h"
#include "plugin/runner/keywords.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapeline::python {

namespace {

using nlohmann::ordered_json;

/// tapeline.Comparison
struct ComparisonObject {
    std::shared_ptr<const Comparison> made;
    ordered_json json; ///< of compare.json
};

/// tapeline.MethodRun
struct RunObject {
    std::shared_ptr<const Comparison> all;
    const MethodRun* run;
    ordered_json json; ///< its entry in compare.json

    py::capsule owner() const { return keep(all); }
};

/// What both faces of compare share: which methods, and the folder to write into, if any.
void set_wishes(Job& job, const py::object& methods, const py::object& output)
{
    const bool one = py::isinstance<py::str>(methods);
    value(set_command_keyword(job, "methods", one ? json_of(py::make_tuple(methods)) : json_of(methods)));
    if (!output.is_none()) {
        job.command.out_folder = path_text(output);
    }
}

ComparisonObject compared(const Job& job, const JobInputs& inputs, Call call)
{
    const bool writes = !job.command.out_folder.empty();
    auto made = std::make_shared<Comparison>(call.run([&](const Progress& watched) {
        return (writes ? check_compare_outputs(job) : Result<void>())
            .and_then([&] { return compare_methods(job, watched.part(0.0, writes ? 0.7 : 1.0), inputs); })
            .and_then([&](Comparison comparison) {
                return (writes ? write_comparison(job, comparison, watched.part(0.7, 1.0)) : Result<void>()).map([&] {
                    return std::move(comparison);
                });
            });
    }));
    ordered_json json = ordered_json::parse(compare_json(job, *made));
    return {std::move(made), std::move(json)};
}

ComparisonObject compare_model(const ModelObject& model, const LineObject& line, const py::object& target,
                               const py::object& methods, const py::object& output, py::object progress,
                               py::object cancel, const py::object& threads, const py::kwargs& keywords)
{
    BoundJob bound = bind_job(model, line, target, keywords, {"target", "remesh", "region", "move", "gate"});
    set_wishes(bound.job, methods, output);
    return compared(bound.job, bound.inputs, Call(std::move(progress), std::move(cancel), threads));
}

ComparisonObject compare_job(const py::object& job, const py::object& methods, const py::object& output,
                             bool check_unique, py::object progress, py::object cancel, const py::object& threads)
{
    Job read = job_of(job);
    read.move.check_unique = read.move.check_unique || check_unique;
    set_wishes(read, methods, output);
    return compared(read, {}, Call(std::move(progress), std::move(cancel), threads));
}

RunObject run_named(const ComparisonObject& self, const std::string& method)
{
    for (std::size_t k = 0; k < self.made->runs.size(); ++k) {
        if (self.made->runs[k].method == method) {
            return {self.made, &self.made->runs[k], self.json.at("methods").at(k)};
        }
    }
    throw py::key_error(method);
}

std::vector<std::string> names(const ComparisonObject& self)
{
    std::vector<std::string> list;
    for (const MethodRun& run : self.made->runs) {
        list.push_back(run.method);
    }
    return list;
}

std::vector<std::string> ranking(const ComparisonObject& self)
{
    std::vector<std::string> list;
    for (const int k : self.made->ranking) {
        list.push_back(self.made->runs[k].method);
    }
    return list;
}

/// What a method's move gives; None where it failed.
template <class Show>
auto of_move(const Show& show)
{
    return [show](const RunObject& self) -> py::object {
        return self.run->move ? py::object(show(*self.run->move, self.owner())) : py::object(py::none());
    };
}

/// An entry of the method in compare.json.
auto entry(const char* key)
{
    return [key](const RunObject& self) { return object_of(self.json.at(key)); };
}

py::object check(const ModelObject& before, const ModelObject& after, const py::object& line, const py::object& target,
                 const py::object& stats, py::object progress, py::object cancel, const py::object& threads,
                 const py::kwargs& keywords)
{
    Job job;
    CheckInputs inputs{after.held, before.held, {}, {}, {}};
    if (!line.is_none()) {
        const auto& chosen = line.cast<const LineObject&>();
        if (chosen.model != before.held && chosen.model != after.held) {
            raise({ErrorKind::usage, "the line belongs to a third model; take it from the model before or after"});
        }
        job.lines = chosen.held.settings;
        if (chosen.model == after.held || job.lines.line.empty()) {
            inputs.line = chosen.held.chain();
        }
    }
    if (!target.is_none()) {
        inputs.target = target.cast<const TargetObject&>().line;
    }
    if (py::isinstance<py::dict>(stats)) {
        inputs.record = value(move_record_of(json_of(stats), "the statistics"));
    } else if (!stats.is_none()) {
        job.command.stats = path_text(stats);
    }
    value(set_keywords(job, json_of(keywords), {"lines", "move", "gate"}, check_command));
    const CheckOutcome outcome =
        Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
            return check_result(job, watched, inputs);
        });
    return object_of(ordered_json::parse(check_json(outcome)));
}

void add_run(py::module_& module)
{
    py::class_<RunObject>(module, "MethodRun", "What one method made of the job.")
        .def_property_readonly("method", entry("method"), "str, its name.")
        .def_property_readonly("state", entry("state"),
                               "'done', 'failed', 'not_converged' or 'ambiguous'; only 'done' is ranked.")
        .def_property_readonly("reason", entry("reason"), "str, why the state is not 'done'; else None.")
        .def_property_readonly("rank", entry("rank"), "int, 1 = best; None when it is not ranked.")
        .def_property_readonly(
            "vertices", of_move([](const MoveResult& move, const py::capsule& owner) { return shown(move.V, owner); }),
            "(n, 3) float64 [mm], moved positions; None when the method failed, as for all arrays here.")
        .def_property_readonly("rest_vertices", of_move([](const MoveResult& move, const py::capsule& owner) {
                                   return shown(move.rest.mesh.V, owner);
                               }),
                               "(n, 3) float64 [mm], the same vertices before the move.")
        .def_property_readonly("faces", of_move([](const MoveResult& move, const py::capsule& owner) {
                                   return shown(move.rest.mesh.F, owner);
                               }),
                               "(m, 3) int32, triangles of both.")
        .def_property_readonly("line_vertices", of_move([](const MoveResult& move, const py::capsule& owner) {
                                   return shown(move.correspondence.line.vertices, owner);
                               }),
                               "(k,) int32, vertices of the moved line, in order.")
        .def_property_readonly("measures", entry("quality"),
                               "dict under the keys of MoveResult.measures; None when the method failed.")
        .def_property_readonly("gates", entry("gates"), "list of dict: name, limit, value and passed.")
        .def_property_readonly("warnings", entry("warnings"), "list of sentences.")
        .def_property_readonly("seconds", entry("seconds"), "float, of the move on its share of the threads.")
        .def_property_readonly(
            "stats", [](const RunObject& self) { return object_of(self.json); },
            "dict, its entry in compare.json: placement, retraction, solve, uniqueness, quality and others.");
}

void add_comparison(py::module_& module)
{
    py::class_<ComparisonObject>(
        module, "Comparison", "Methods on one job: a mapping from their names, in the order asked for, to MethodRun.")
        .def("__len__", [](const ComparisonObject& self) { return self.made->runs.size(); })
        .def("__iter__", [](const ComparisonObject& self) { return py::iter(py::cast(names(self))); })
        .def("__contains__",
             [](const ComparisonObject& self, const std::string& method) {
                 return std::ranges::count(self.made->runs, method, &MethodRun::method) > 0;
             })
        .def("__getitem__", &run_named, py::arg("method"))
        .def("keys", &names, "list of str, the methods.")
        .def_property_readonly("ranking", &ranking, "list of str, the methods that can be ranked, best first.")
        .def_property_readonly(
            "winner", [](const ComparisonObject& self) { return object_of(self.json.at("winner")); },
            "str, the best method; None when none can be ranked.")
        .def_property_readonly(
            "headline", [](const ComparisonObject& self) { return object_of(self.json.at("headline")); },
            "str, who wins and by what.")
        .def_property_readonly(
            "table", [](const ComparisonObject& self) { return comparison_table(*self.made); },
            "str, the table that `tapeline compare` prints.")
        .def_property_readonly(
            "warnings", [](const ComparisonObject& self) { return self.made->warnings; }, "list of sentences.")
        .def_property_readonly(
            "stats", [](const ComparisonObject& self) { return object_of(self.json); },
            "dict, what compare.json holds. Lengths mm, angles deg, times s.");
}

} // namespace

void add_comparisons(py::module_& module)
{
    add_run(module);
    add_comparison(module);
    module.def(
        "compare", &compare_model, py::arg("model"), py::arg("line"), py::arg("target") = py::none(), py::kw_only(),
        py::arg("methods") = py::none(), py::arg("output") = py::none(), py::arg("progress") = py::none(),
        py::arg("cancel") = py::none(), py::arg("threads") = 0,
        "Moves the line under each of `methods` (names; None: all there are) and ranks the results, as `tapeline "
        "compare`. `output`: a folder for compare.html, compare.json, METHOD.obj and pictures. A method that "
        "fails is no exception; see MethodRun.state. Keywords: those of move().");
    module.def("compare", &compare_job, py::arg("job"), py::kw_only(), py::arg("methods") = py::none(),
               py::arg("output") = py::none(), py::arg("check_unique") = false, py::arg("progress") = py::none(),
               py::arg("cancel") = py::none(), py::arg("threads") = 0,
               "The same of a job file, or of a dict of the same.");
    module.def(
        "check", &check, py::arg("before"), py::arg("after"), py::arg("line") = py::none(), py::kw_only(),
        py::arg("target") = py::none(), py::arg("stats") = py::none(), py::arg("progress") = py::none(),
        py::arg("cancel") = py::none(), py::arg("threads") = 0,
        "Measures the model `after` a move against the one `before`, as `tapeline check`: dict of measures, match, "
        "line, compressed_side, omitted, gates and warnings. `line`: a FeatureLine of either; None: that of "
        "`stats`, or the one that moved most. `target`: the TargetLine, for the line error. `stats`: "
        "MoveResult.stats or the file that `tapeline move --stats` wrote. Keywords: section lines, "
        "compressed_side and section gate.");
}

} // namespace tapeline::python
