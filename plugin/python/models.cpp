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

ModelObject read(const py::object& path, py::object progress, py::object cancel, const py::object& threads,
                 const py::kwargs& keywords)
{
    Job job;
    value(set_keywords(job, json_of(keywords), {"import"}));
    const std::string name = path_text(path);
    return {Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
        return hold_model(name, job.import, watched);
    })};
}

ModelObject from_arrays(const py::object& V, const py::object& F, const std::string& units)
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
        other = Mesh{positions_of(V, "V"), own.F};
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
                        const py::object& threads, const py::kwargs& keywords)
{
    const BoundJob bound = bind_job(self, line, py::none(), keywords, {"target", "remesh"});
    const Preparation made = Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
        Stopwatch watch;
        return prepare_target(bound.job, watch, watched, bound.inputs);
    });
    return {made.target->line, made.target->fit_error_mm};
}

RegionObject region(const ModelObject& self, const LineObject& line, const py::object& target, py::object progress,
                    py::object cancel, const py::object& threads, const py::kwargs& keywords)
{
    const BoundJob bound = bind_job(self, line, target, keywords, {"target", "remesh", "region", "move"});
    Placing placing = Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
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
    py::class_<ModelObject>(
        module, "Model",
        "A surface model: one triangle mesh in mm and, for CAD input, where its triangles come from. "
        "Never changed.")
        .def_static("read", &read, py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
                    py::arg("cancel") = py::none(), py::arg("threads") = 0,
                    "Reads STEP, IGES, BREP, STL, OBJ, PLY or OFF, told apart by content. Keywords: section import "
                    "of options().")
        .def_static("from_arrays", &from_arrays, py::arg("vertices"), py::arg("faces"), py::kw_only(),
                    py::arg("units") = "mm",
                    "A model from vertices (n, 3), any number type, in `units`, and triangles (m, 3), counter- "
                    "clockwise seen from outside. Both are copied and repaired as a mesh file would be; vertex "
                    "numbers stay.")
        .def("write", &write, py::arg("path"), py::arg("vertices") = py::none(), py::kw_only(),
             py::arg("ascii") = false,
             "Writes .stl, .obj, .ply or .off by the ending, in the model's unit, in full precision; "
             "`vertices` (n, 3) [mm] instead of the model's own; `ascii`: STL and PLY as text.")
        .def_property_readonly(
            "vertices", [](const ModelObject& self) { return shown(self.model().mesh.V, self.owner()); },
            "(n, 3) float64 [mm], row i = vertex i. A view that cannot be written to.")
        .def_property_readonly(
            "faces", [](const ModelObject& self) { return shown(self.model().mesh.F, self.owner()); },
            "(m, 3) int32, row t = the vertices of triangle t, counter-clockwise seen from outside. A view.")
        .def_property_readonly(
            "face_ids",
            [](const ModelObject& self) {
                const Model& model = self.model();
                return model.cad_face.empty() ? copied(std::vector<int>(model.mesh.F.rows(), -1))
                                              : shown(model.cad_face, self.owner());
            },
            "(m,) int32, the CAD face of each triangle, -1 = none.")
        .def_property_readonly(
            "edge_ids",
            [](const ModelObject& self) {
                std::vector<int> rows;
                for (const CadEdgeTag& tag : self.model().cad_edges) {
                    rows.insert(rows.end(), {tag.a, tag.b, tag.cad_edge});
                }
                return copied(rows).reshape({-1, 3});
            },
            "(k, 3) int32, mesh edges on CAD edges: vertex, vertex, number of the CAD edge. Empty for "
            "meshes.")
        .def_property_readonly(
            "has_surfaces", [](const ModelObject& self) { return self.model().surface != nullptr; },
            "True when the exact CAD faces are there, so that new vertices are put on them.")
        .def_property_readonly(
            "units", [](const ModelObject& self) { return self.held->settings.units; },
            "Unit of mesh files that are read and written: mm, cm, m, in or ft.")
        .def_property_readonly(
            "path",
            [](const ModelObject& self) -> py::object {
                return self.held->path.empty() ? py::object(py::none()) : py::str(self.held->path.string());
            },
            "The file that the model was read from, None for arrays.")
        .def_property_readonly(
            "report", [](const ModelObject& self) { return object_of(import_json(self.held->imported.report)); },
            "dict: what was found and done while reading (format, units, counts, warnings).")
        .def("feature_lines", &feature_lines,
             "list of FeatureLine, longest first, as `tapeline lines`. Keywords: section lines of options().")
        .def("line_through", &line_through_vertices, py::arg("vertices"),
             "The chain of these vertex numbers as a FeatureLine; first = last makes it closed.")
        .def("fit_target", &fit_target, py::arg("line"), py::kw_only(), py::arg("progress") = py::none(),
             py::arg("cancel") = py::none(), py::arg("threads") = 0,
             "TargetLine fitted to the line and changed as the keywords say, as `tapeline target`. Keywords: "
             "sections target and remesh.")
        .def("region", &region, py::arg("line"), py::arg("target") = py::none(), py::kw_only(),
             py::arg("progress") = py::none(), py::arg("cancel") = py::none(), py::arg("threads") = 0,
             "Region that a move of the line to the target (None: the keywords say it) would deform, and its "
             "placement. Keywords: sections target, remesh, region and move.");
}

void add_line(py::module_& module)
{
    const auto number = [](auto member) { return [member](const LineObject& self) { return self.held.line.*member; }; };
    py::class_<LineObject>(module, "FeatureLine", "A sharp line of a model: a chain of mesh edges.")
        .def_property_readonly("id", number(&FeatureLine::id),
                               "int, number among the model's lines, longest first, from 0; -1 for other chains.")
        .def_property_readonly("closed", number(&FeatureLine::closed),
                               "True for a loop; its first vertex is not repeated.")
        .def_property_readonly("length_mm", number(&FeatureLine::length_mm), "float [mm].")
        .def_property_readonly("crease_angle_mean", number(&FeatureLine::crease_angle_mean),
                               "float [deg], 0 = flat, weighted by length.")
        .def_property_readonly("crease_angle_min", number(&FeatureLine::crease_angle_min), "float [deg].")
        .def_property_readonly("crease_angle_max", number(&FeatureLine::crease_angle_max), "float [deg].")
        .def_property_readonly(
            "vertices", [](const LineObject& self) { return copied(self.held.line.vertices); },
            "(k,) int32, vertex numbers in the model, in order. Those from len(model.vertices) on are new ones that "
            "part() puts on the long edges of a CAD model, as a move does; `points` has their places too.")
        .def_property_readonly(
            "cad_edges", [](const LineObject& self) { return copied(self.held.line.cad_edges); },
            "(j,) int32, CAD edges along the line, ascending.")
        .def_property_readonly(
            "selector", [](const LineObject& self) { return self.held.settings.line.text; },
            "How commands and job files name the line, e.g. '0@10%..85%'; empty for a chain of vertices.")
        .def_property_readonly(
            "points",
            [](const LineObject& self) { return copied(line_points(self.model_of_vertices().mesh, self.held.line)); },
            "(k, 3) float64 [mm], positions of the vertices.")
        .def(
            "part",
            [](const LineObject& self, const py::object& from, const py::object& to, const py::kwargs& keywords) {
                Job job;
                value(set_keywords(job, json_of(keywords), {"remesh"}));
                const std::string first = bound_text(from), last = bound_text(to);
                return LineObject{self.model, without_gil([&] {
                                      return held_part(*self.model, self.held, first, last, job.remesh);
                                  })};
            },
            py::arg("start"), py::arg("end"),
            "The part from `start` to `end`, arc length in mm (a number) or percent ('10%'), as --line ID@START..END. "
            "Keywords: section remesh, which says whether long edges are split up first, and how far.");
}

void add_region(py::module_& module)
{
    py::class_<RegionObject>(
        module, "Region",
        "What a move would deform. Numbers count in `model`, which for CAD input is remeshed around the "
        "line.")
        .def_property_readonly(
            "model", [](const RegionObject& self) { return ModelObject{self.model}; },
            "Model with the region's triangles.")
        .def_property_readonly(
            "line",
            [](const RegionObject& self) {
                HeldLine line{self.placing->correspondence.line, {}};
                return LineObject{self.model, std::move(line)};
            },
            "FeatureLine, the part of the line that moves.")
        .def_property_readonly(
            "target", [](const RegionObject& self) { return TargetObject{self.placing->preparation.target->line}; },
            "TargetLine, the goal that was used.")
        .def_property_readonly(
            "faces", [](const RegionObject& self) { return shown(of(self).faces, keep(self.placing)); },
            "(f,) int32, triangles of the region, ascending.")
        .def_property_readonly(
            "vertices", [](const RegionObject& self) { return shown(of(self).vertices, keep(self.placing)); },
            "(v,) int32, their vertices, ascending.")
        .def_property_readonly(
            "fixed",
            [](const RegionObject& self) {
                std::vector<int> fixed;
                std::ranges::set_union(of(self).fixed_rim, of(self).inner_fixed, std::back_inserter(fixed));
                return copied(fixed);
            },
            "(r,) int32, vertices that stay: the rim and fixed ones inside.")
        .def_property_readonly(
            "distance_mm", [](const RegionObject& self) { return of(self).distance_mm; },
            "float, half-width of the band around line and target; 0 when chosen in another way.")
        .def_property_readonly(
            "warnings", [](const RegionObject& self) { return of(self).warnings; }, "list of sentences.")
        .def_property_readonly(
            "displacements",
            [](const RegionObject& self) { return copied(self.placing->correspondence.displacements); },
            "(k, 3) float64 [mm], where each vertex of `line` goes, relative to its place.")
        .def_property_readonly(
            "placement", &placement_dict,
            "dict: verdict ('on_surface' or 'off_surface'), off_fraction, compressed_side ('left', 'right' "
            "or None), u_max_mm and others, and the triangles tension_faces and compression_faces.");
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
