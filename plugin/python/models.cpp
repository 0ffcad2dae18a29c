// SPDX-License-Identifier: GPL-3.0-or-later
// Model, FeatureLine and Region.
#include "plugin/python/call.h"
#include "plugin/python/objects.h"
#include "plugin/runner/keywords.h"
#include "plugin/runner/preparation.h"
#include "plugin/runner/stats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapeline::python {

namespace {

ModelObject read(const py::object& path, py::object progress, py::object cancel, const py::kwargs& keywords)
{
    Job job;
    value(set_keywords(job, json_of(keywords), {"import"}));
    const std::string name = path_text(path);
    return {Call(std::move(progress), std::move(cancel)).run([&](const Progress& watched) {
        return hold_model(name, job.import, watched);
    })};
}

ModelObject from_arrays(const py::array& V, const py::array& F, const std::string& units)
{
    Job job;
    value(set_keywords(job, {{"units", units}}, {"import"}));
    Mesh mesh{positions_of(V, "the vertices"), triangles_of(F)};
    return {without_gil([&] { return hold_mesh(std::move(mesh), job.import); })};
}

void write(const ModelObject& self, const py::object& path, const py::object& V, bool ascii)
{
    const std::string name = path_text(path);
    const Mesh& own = self.model().mesh;
    std::optional<Mesh> other;
    if (!V.is_none()) {
        other = Mesh{positions_of(V.cast<py::array>(), "V"), own.F};
        if (other->V.rows() != own.V.rows()) {
            raise({ErrorKind::usage,
                   fmt::format("V has {} rows but the model has {} vertices", other->V.rows(), own.V.rows())});
        }
    }
    const ExportOptions options{ascii, unit_length_mm(self.held->settings.units)};
    without_gil([&] { return write_mesh(name, other ? *other : own, options); });
}

std::vector<LineObject> feature_lines(const ModelObject& self, const py::kwargs& keywords)
{
    Job job;
    value(set_keywords(job, json_of(keywords), {"lines"}));
    auto found = without_gil([&] { return Result<std::vector<HeldLine>>(held_lines(*self.held, job.lines)); });
    std::vector<LineObject> lines;
    for (HeldLine& line : found) {
        lines.push_back({self.held, std::move(line)});
    }
    return lines;
}

LineObject line_through_vertices(const ModelObject& self, const py::object& vertices, const py::kwargs& keywords)
{
    Job job;
    value(set_keywords(job, json_of(keywords), {"lines"}));
    auto chain = py::cast<std::vector<int>>(vertices);
    return {self.held, value(held_chain(*self.held, std::move(chain), job.lines))};
}

std::string bound_text(const py::object& bound)
{
    return py::isinstance<py::str>(bound) ? bound.cast<std::string>() : fmt::format("{}", bound.cast<double>());
}

TargetObject fit_target(const ModelObject& self, const LineObject& line, py::object progress, py::object cancel,
                        const py::kwargs& keywords)
{
    const BoundJob bound = bind_job(self, line, py::none(), keywords, {"target", "remesh"});
    const Preparation made = Call(std::move(progress), std::move(cancel)).run([&](const Progress& watched) {
        Stopwatch watch;
        return prepare_target(bound.job, watch, watched, bound.inputs);
    });
    return {made.target->line, made.target->fit_error_mm};
}

RegionObject region(const ModelObject& self, const LineObject& line, const py::object& target, py::object progress,
                    py::object cancel, const py::kwargs& keywords)
{
    const BoundJob bound = bind_job(self, line, target, keywords, {"target", "remesh", "region", "move"});
    Placing placing = Call(std::move(progress), std::move(cancel)).run([&](const Progress& watched) {
        return place_job(bound.job, bound.inputs, watched);
    });
    auto model = std::make_shared<HeldModel>();
    model->imported = {std::move(placing.preparation.model), placing.preparation.import};
    model->settings = self.held->settings;
    return {std::make_shared<Placing>(std::move(placing)), std::move(model)};
}

py::object placement_dict(const RegionObject& self)
{
    py::object dict = object_of(placement_json(self.placing->placement));
    dict["tension_faces"] = shown(self.placing->parts.tension, keep(self.placing));
    dict["compression_faces"] = shown(self.placing->parts.compressed, keep(self.placing));
    return dict;
}

const Region& of(const RegionObject& self) { return self.placing->preparation.region; }

void add_model(py::module_& module)
{
    py::class_<ModelObject>(module, "Model")
        .def_static("read", &read, py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
                    py::arg("cancel") = py::none())
        .def_static("from_arrays", &from_arrays, py::arg("vertices"), py::arg("faces"), py::kw_only(),
                    py::arg("units") = "mm")
        .def("write", &write, py::arg("path"), py::arg("vertices") = py::none(), py::kw_only(),
             py::arg("ascii") = false)
        .def_property_readonly("vertices",
                               [](const ModelObject& self) { return shown(self.model().mesh.V, self.owner()); })
        .def_property_readonly("faces",
                               [](const ModelObject& self) { return shown(self.model().mesh.F, self.owner()); })
        .def_property_readonly("face_ids",
                               [](const ModelObject& self) {
                                   const Model& model = self.model();
                                   return model.cad_face.empty() ? copied(std::vector<int>(model.mesh.F.rows(), -1))
                                                                 : shown(model.cad_face, self.owner());
                               })
        .def_property_readonly("edge_ids",
                               [](const ModelObject& self) {
                                   std::vector<int> rows;
                                   for (const CadEdgeTag& tag : self.model().cad_edges) {
                                       rows.insert(rows.end(), {tag.a, tag.b, tag.cad_edge});
                                   }
                                   return copied(rows).reshape({-1, 3});
                               })
        .def_property_readonly("has_surfaces", [](const ModelObject& self) { return self.model().surface != nullptr; })
        .def_property_readonly("units", [](const ModelObject& self) { return self.held->settings.units; })
        .def_property_readonly("path",
                               [](const ModelObject& self) -> py::object {
                                   return self.held->path.empty() ? py::object(py::none())
                                                                  : py::str(self.held->path.string());
                               })
        .def_property_readonly(
            "report", [](const ModelObject& self) { return object_of(import_json(self.held->imported.report)); })
        .def("feature_lines", &feature_lines)
        .def("line_through", &line_through_vertices, py::arg("vertices"))
        .def("fit_target", &fit_target, py::arg("line"), py::kw_only(), py::arg("progress") = py::none(),
             py::arg("cancel") = py::none())
        .def("region", &region, py::arg("line"), py::arg("target") = py::none(), py::kw_only(),
             py::arg("progress") = py::none(), py::arg("cancel") = py::none());
}

void add_line(py::module_& module)
{
    const auto number = [](auto member) { return [member](const LineObject& self) { return self.held.line.*member; }; };
    py::class_<LineObject>(module, "FeatureLine")
        .def_property_readonly("id", number(&FeatureLine::id))
        .def_property_readonly("closed", number(&FeatureLine::closed))
        .def_property_readonly("length_mm", number(&FeatureLine::length_mm))
        .def_property_readonly("crease_angle_mean", number(&FeatureLine::crease_angle_mean))
        .def_property_readonly("crease_angle_min", number(&FeatureLine::crease_angle_min))
        .def_property_readonly("crease_angle_max", number(&FeatureLine::crease_angle_max))
        .def_property_readonly("vertices", [](const LineObject& self) { return copied(self.held.line.vertices); })
        .def_property_readonly("cad_edges", [](const LineObject& self) { return copied(self.held.line.cad_edges); })
        .def_property_readonly("selector", [](const LineObject& self) { return self.held.settings.line.text; })
        .def_property_readonly(
            "points",
            [](const LineObject& self) { return copied(line_points(self.model->imported.model.mesh, self.held.line)); })
        .def(
            "part",
            [](const LineObject& self, const py::object& from, const py::object& to) {
                return LineObject{self.model,
                                  value(held_part(*self.model, self.held, bound_text(from), bound_text(to)))};
            },
            py::arg("start"), py::arg("end"));
}

void add_region(py::module_& module)
{
    py::class_<RegionObject>(module, "Region")
        .def_property_readonly("model", [](const RegionObject& self) { return ModelObject{self.model}; })
        .def_property_readonly("line",
                               [](const RegionObject& self) {
                                   HeldLine line{self.placing->correspondence.line, {}};
                                   return LineObject{self.model, std::move(line)};
                               })
        .def_property_readonly(
            "target", [](const RegionObject& self) { return TargetObject{self.placing->preparation.target->line}; })
        .def_property_readonly("faces",
                               [](const RegionObject& self) { return shown(of(self).faces, keep(self.placing)); })
        .def_property_readonly("vertices",
                               [](const RegionObject& self) { return shown(of(self).vertices, keep(self.placing)); })
        .def_property_readonly("fixed",
                               [](const RegionObject& self) {
                                   std::vector<int> fixed;
                                   std::ranges::set_union(of(self).fixed_rim, of(self).inner_fixed,
                                                          std::back_inserter(fixed));
                                   return copied(fixed);
                               })
        .def_property_readonly("distance_mm", [](const RegionObject& self) { return of(self).distance_mm; })
        .def_property_readonly("warnings", [](const RegionObject& self) { return of(self).warnings; })
        .def_property_readonly(
            "displacements",
            [](const RegionObject& self) { return copied(self.placing->correspondence.displacements); })
        .def_property_readonly("placement", &placement_dict);
}

} // namespace

BoundJob bind_job(const ModelObject& model, const LineObject& line, const py::object& target,
                  const py::kwargs& keywords, std::initializer_list<std::string_view> sections)
{
    if (line.model != model.held) {
        raise({ErrorKind::usage, "the line belongs to another model; take it from this one's feature_lines()"});
    }
    std::optional<TargetLine> given;
    if (!target.is_none()) {
        if (!py::isinstance<TargetObject>(target)) {
            raise({ErrorKind::usage, "target must be a TargetLine, or None where keywords such as slide say the goal"});
        }
        given = target.cast<const TargetObject&>().line;
    }
    BoundJob bound;
    value(set_keywords(bound.job, json_of(keywords), sections));
    bound.inputs = use_held(bound.job, model.held, line.held, std::move(given));
    return bound;
}

void add_models(py::module_& module)
{
    add_model(module);
    add_line(module);
    add_region(module);
}

} // namespace tapeline::python
