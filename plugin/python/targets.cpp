// SPDX-License-Identifier: GPL-3.0-or-later
// TargetLine.
#include "io/target_file.h"
#include "io/target_formats.h"
#include "plugin/python/call.h"
#include "plugin/python/objects.h"
#include "plugin/runner/keywords.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapeline::python {

namespace {

TargetObject from_data(const py::object& control_points, const std::vector<double>& knots, int degree,
                       const std::optional<std::vector<double>>& weights, bool closed)
{
    BSplineData data;
    data.degree = degree;
    data.knots = knots;
    data.weights = weights.value_or(std::vector<double>{});
    data.control_points = points_of(control_points, "the control points");
    data.closed = closed;
    return {value(TargetLine::from_data(data))};
}

TargetObject with_control_points(const TargetObject& self, const py::object& points)
{
    BSplineData data = self.line.data();
    auto moved = points_of(points, "the control points");
    if (moved.size() != data.control_points.size()) {
        raise({ErrorKind::usage,
               fmt::format("{} control points were given for {}", moved.size(), data.control_points.size())});
    }
    data.control_points = std::move(moved);
    return {value(TargetLine::from_data(data))};
}

TargetObject move_control_point(const TargetObject& self, int index, const py::object& point, bool relative)
{
    const std::vector<Vec3> points = points_of(py::make_tuple(point), "the point in a list");
    return {value(move_control_points(self.line, {{index, points.front(), relative}}))};
}

/// The steps that a job makes of a target it was given, on the model's surface around the line.
TargetObject edit(const TargetObject& self, const ModelObject& model, const LineObject& line, const char* key,
                  const py::object& setting, py::object progress, py::object cancel, const py::object& threads,
                  const py::kwargs& keywords)
{
    keywords[key] = setting;
    const BoundJob bound = bind_job(model, line, py::cast(self), keywords, {"target", "remesh"});
    const Preparation made = Call(std::move(progress), std::move(cancel), threads).run([&](const Progress& watched) {
        Stopwatch watch;
        return prepare_target(bound.job, watch, watched, bound.inputs);
    });
    return {made.target->line};
}

TargetObject faired(const TargetObject& self, double limit)
{
    Job job;
    value(set_keywords(job, {{"fair", true}, {"fair_limit", limit}}, {"target"}));
    return {without_gil([&] { return make_target({}, {}, job.target, self.line); }).line};
}

py::array sample(const TargetObject& self, int count)
{
    if (count < 2) {
        raise({ErrorKind::usage, fmt::format("at least 2 points can be sampled, not {}", count)});
    }
    const TargetLine& line = self.line;
    const double length = line.length();
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k + 1 < count; ++k) {
        points.push_back(line.point(line.parameter_at(length * k / (count - 1))));
    }
    points.push_back(line.point(line.last_parameter()));
    return copied(points);
}

py::tuple foot(const TargetObject& self, const py::object& points)
{
    std::vector<Vec3> feet;
    std::vector<double> fractions;
    const double length = self.line.length();
    for (const Vec3& p : points_of(points, "the points")) {
        const CurveFoot found = self.line.foot(p);
        feet.push_back(found.point);
        fractions.push_back(self.line.arc_length(found.parameter) / length);
    }
    return py::make_tuple(copied(feet), copied(fractions));
}

void add_edits(py::class_<TargetObject>& target)
{
    target
        .def("with_control_points", &with_control_points, py::arg("points"),
             "The same knots and weights with control points (k, 3) [mm].")
        .def("move_control_point", &move_control_point, py::arg("index"), py::arg("point"), py::kw_only(),
             py::arg("relative") = false,
             "Control point `index` at `point` (3,) [mm], or moved by it when `relative`; a closed line stays "
             "closed and smooth.")
        .def(
            "slide",
            [](const TargetObject& self, const ModelObject& model, const LineObject& line, const py::object& law,
               py::object progress, py::object cancel, const py::object& threads, const py::kwargs& keywords) {
                return edit(self, model, line, "slide", law, std::move(progress), std::move(cancel), threads, keywords);
            },
            py::arg("model"), py::arg("line"), py::arg("law"), py::kw_only(), py::arg("progress") = py::none(),
            py::arg("cancel") = py::none(), py::arg("threads") = 0,
            "Slides the curve along the model's surface, to the left of the line if positive, by `law` [mm]: "
            "one distance, or several spread evenly over its length. Keywords: sections target and remesh.")
        .def(
            "on_surface",
            [](const TargetObject& self, const ModelObject& model, const LineObject& line, py::object progress,
               py::object cancel, const py::object& threads, const py::kwargs& keywords) {
                return edit(self, model, line, "on_surface", py::bool_(true), std::move(progress), std::move(cancel),
                            threads, keywords);
            },
            py::arg("model"), py::arg("line"), py::kw_only(), py::arg("progress") = py::none(),
            py::arg("cancel") = py::none(), py::arg("threads") = 0,
            "Drops the curve onto the model's surface around the line. Keywords: sections target and remesh.")
        .def("fair", &faired, py::arg("limit") = 0.0,
             "Evens out the curvature, moving no control point by more than `limit` [mm]; 0 = a thousandth of "
             "the length.");
}

void add_files(py::class_<TargetObject>& target)
{
    target
        .def_static(
            "read",
            [](const py::object& path) {
                const std::string name = path_text(path);
                return TargetObject{without_gil([&] { return read_target(name); })};
            },
            py::arg("path"), "Reads JSON, STEP, IGES or BREP curves or a CSV polyline, told apart by content.")
        .def(
            "write",
            [](const TargetObject& self, const py::object& path) {
                const std::string name = path_text(path);
                without_gil([&] { return write_target(name, self.line); });
            },
            py::arg("path"), "Writes .json, .step, .iges, .brep or .csv by the ending.")
        .def(
            "to_json", [](const TargetObject& self) { return target_to_json(self.line); },
            "The curve as the text of a JSON target file; every number survives.")
        .def_static(
            "from_json",
            [](const std::string& text) { return TargetObject{value(target_from_json("the text", text))}; },
            py::arg("text"), "The curve from such a text.")
        .def(py::pickle(
            [](const TargetObject& self) { return target_to_json(self.line); },
            [](const std::string& text) { return TargetObject{value(target_from_json("the text", text))}; }));
}

} // namespace

void add_targets(py::module_& module)
{
    py::class_<TargetObject> target(
        module, "TargetLine",
        "The line to reach: an exact B-spline curve in mm. Immutable; every change gives a new one.");
    target
        .def(py::init(&from_data), py::arg("control_points"), py::arg("knots"), py::kw_only(), py::arg("degree") = 3,
             py::arg("weights") = py::none(), py::arg("closed") = false,
             "A curve from control points (k, 3) [mm], knots (k + degree + 1, with repetition), degree and "
             "weights (k,), None = all 1.")
        .def_property_readonly(
            "control_points", [](const TargetObject& self) { return copied(self.line.data().control_points); },
            "(k, 3) float64 [mm]; of a closed line the last is the first.")
        .def_property_readonly(
            "knots", [](const TargetObject& self) { return copied(self.line.data().knots); },
            "(k + degree + 1,) float64, with repetition.")
        .def_property_readonly(
            "weights",
            [](const TargetObject& self) {
                BSplineData data = self.line.data();
                data.weights.resize(data.control_points.size(), data.weights.empty() ? 1.0 : data.weights.back());
                return copied(data.weights);
            },
            "(k,) float64, all 1 for a polynomial curve.")
        .def_property_readonly(
            "degree", [](const TargetObject& self) { return self.line.data().degree; }, "int.")
        .def_property_readonly(
            "closed", [](const TargetObject& self) { return self.line.closed(); }, "True for a loop.")
        .def_property_readonly(
            "length_mm", [](const TargetObject& self) { return self.line.length(); }, "float [mm].")
        .def_property_readonly(
            "fit_error_mm", [](const TargetObject& self) { return self.fit_error_mm; },
            "float [mm], largest distance of the feature line to the curve fitted to it; None when it was "
            "not fitted.")
        .def("sample", &sample, py::arg("count"),
             "(count, 3) float64 [mm], points at equal steps of arc length from end to end; of a closed line "
             "the last is the first.")
        .def("foot", &foot, py::arg("points"),
             "Nearest points (n, 3) [mm] of the curve to `points` (n, 3), and their fractions (n,) of its "
             "length.");
    add_edits(target);
    add_files(target);
    target.def_static(
        "through",
        [](const py::object& points, bool closed) {
            const auto list = points_of(points, "the points");
            return TargetObject{without_gil([&] { return interpolate_points(list, closed); })};
        },
        py::arg("points"), py::kw_only(), py::arg("closed") = false, "A cubic curve through points (n, 3) [mm].");
}

} // namespace tapeline::python
