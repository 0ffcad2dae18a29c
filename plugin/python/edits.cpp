// SPDX-License-Identifier: GPL-3.0-or-later
// Editor and its previews.
#include "plugin/python/call.h"
#include "plugin/python/objects.h"
#include "plugin/runner/editor.h"
#include "plugin/runner/stats.h"

#include <nlohmann/json.hpp>

namespace tapeline::python {

namespace {

/// tapeline.Editor
struct EditorObject {
    std::shared_ptr<const HeldModel> model;
    std::unique_ptr<Editor> editor;
    py::object threads;
};

/// tapeline.Preview
struct PreviewObject {
    std::shared_ptr<const EditorPreview> preview;
    py::capsule owner() const { return keep(preview); }
};

std::unique_ptr<EditorObject> make_editor(const ModelObject& model, const LineObject& line, py::object threads,
                                          const py::kwargs& keywords)
{
    {
        [[maybe_unused]] const Call checks_them(py::none(), py::none(), threads);
    }
    BoundJob bound = bind_job(model, line, py::none(), keywords, {"target", "remesh", "region", "move", "gate"});
    return std::make_unique<EditorObject>(EditorObject{
        model.held, std::make_unique<Editor>(std::move(bound.job), std::move(bound.inputs)), std::move(threads)});
}

void start(const EditorObject& self, const TargetObject& target, py::object progress, py::object cancel)
{
    Call(std::move(progress), std::move(cancel), self.threads).run([&](const Progress& watched) {
        return self.editor->start(target.line, watched);
    });
}

PreviewObject preview(const EditorObject& self, const TargetObject& target, double budget_ms, py::object progress,
                      py::object cancel)
{
    return {std::make_shared<EditorPreview>(
        Call(std::move(progress), std::move(cancel), self.threads).run([&](const Progress& watched) {
            return self.editor->preview(target.line, budget_ms, watched);
        }))};
}

ResultObject solve(const EditorObject& self, const TargetObject& target, py::object progress, py::object cancel)
{
    auto outcome = Call(std::move(progress), std::move(cancel), self.threads).run([&](const Progress& watched) {
        return self.editor->solve(target.line, watched);
    });
    return {self.editor->job(), self.editor->inputs_with(target.line), std::move(outcome)};
}

void save_job(const EditorObject& self, const py::object& path, const TargetObject& target,
              const py::object& target_path)
{
    const std::string name = path_text(path);
    const std::string target_name = target_path.is_none() ? "" : path_text(target_path);
    without_gil([&] { return self.editor->save(target.line, name, target_name); });
}

void add_preview(py::module_& module)
{
    py::class_<PreviewObject>(module, "Preview", "An approximate result, quick to have.")
        .def_property_readonly(
            "vertices", [](const PreviewObject& self) { return shown(self.preview->V, self.owner()); },
            "(n, 3) float64 [mm], moved positions of the shown mesh.")
        .def_property_readonly(
            "rest_vertices", [](const PreviewObject& self) { return shown(self.preview->rest->V, self.owner()); },
            "(n, 3) float64 [mm], the shown mesh before the move.")
        .def_property_readonly(
            "faces", [](const PreviewObject& self) { return shown(self.preview->rest->F, self.owner()); },
            "(m, 3) int32, its triangles.")
        .def_property_readonly(
            "mesh_number", [](const PreviewObject& self) { return self.preview->mesh_number; },
            "int that changes when previews show another mesh.")
        .def_property_readonly(
            "line_vertices", [](const PreviewObject& self) { return shown(self.preview->line, self.owner()); },
            "(k,) int32, vertices of the moved line; they lie on the target exactly.")
        .def_property_readonly(
            "tension_faces", [](const PreviewObject& self) { return shown(self.preview->parts.tension, self.owner()); },
            "Region triangles that are stretched.")
        .def_property_readonly(
            "compression_faces",
            [](const PreviewObject& self) { return shown(self.preview->parts.compressed, self.owner()); },
            "Region triangles that make room.")
        .def_property_readonly(
            "placement", [](const PreviewObject& self) { return object_of(placement_json(self.preview->placement)); },
            "dict, as Region.placement, without the triangles.")
        .def_property_readonly(
            "measures", [](const PreviewObject& self) { return object_of(strip_json(*self.preview)); },
            "dict under the keys of MoveResult.measures: line error, bulge, sections, crease, flipped; None "
            "where time was short.")
        .def_property_readonly(
            "exact", [](const PreviewObject& self) { return self.preview->exact; },
            "True when this is the answer of solve() itself.")
        .def_property_readonly(
            "leaves_region", [](const PreviewObject& self) { return self.preview->leaves_region; },
            "True when the target ends on or beyond the rim, so that only solve() shows it rightly.")
        .def_property_readonly(
            "seconds", [](const PreviewObject& self) { return self.preview->seconds; }, "float, how long it took.");
}

} // namespace

void add_edits(py::module_& module)
{
    add_preview(module);
    py::class_<EditorObject>(
        module, "Editor",
        "Follows a target while it is dragged about: quick previews, exact results. Keywords as those of "
        "move(); `threads` holds for all its calls. May be used from several threads at once.")
        .def(py::init(&make_editor), py::arg("model"), py::arg("line"), py::kw_only(), py::arg("threads") = 0)
        .def("start", &start, py::arg("target"), py::kw_only(), py::arg("progress") = py::none(),
             py::arg("cancel") = py::none(),
             "Prepares previews with the region for this target; otherwise the first preview does.")
        .def("preview", &preview, py::arg("target"), py::arg("budget_ms") = 100.0, py::kw_only(),
             py::arg("progress") = py::none(), py::arg("cancel") = py::none(),
             "Preview within about `budget_ms`: positions always, measures as far as time allows.")
        .def("solve", &solve, py::arg("target"), py::kw_only(), py::arg("progress") = py::none(),
             py::arg("cancel") = py::none(), "MoveResult, the same bytes as move(); later previews start at it.")
        .def("save_job", &save_job, py::arg("path"), py::arg("target"), py::arg("target_path") = py::none(),
             "Writes the job file that `tapeline run` repeats to the same bytes; see MoveResult.save_job.");
}

} // namespace tapeline::python
