// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/measures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace tapeline {

namespace {

using nlohmann::ordered_json;

ordered_json before_after(double before, double after) { return {{"before", before}, {"after", after}}; }

ordered_json sections_json(const SectionMeasure& m)
{
    return {{"inflections_before", m.inflections_before},
            {"inflections_after", m.inflections_after},
            {"turning_before", m.turning_before},
            {"turning_after", m.turning_after},
            {"turning_increase", m.turning_increase}};
}

int new_inflections(const SectionMeasure& m) { return std::max(0, m.inflections_after - m.inflections_before); }

std::string number(double x) { return x == 0 ? "0" : fmt::format("{:.4g}", x); }

using Rows = std::vector<std::vector<std::string>>;

void section_rows(Rows& rows, const char* side, const SectionMeasure& m)
{
    rows.push_back({fmt::format("inflections, {} side", side), std::to_string(m.inflections_before),
                    std::to_string(m.inflections_after)});
    rows.push_back({fmt::format("turning, {} side [deg]", side), number(m.turning_before), number(m.turning_after)});
    rows.push_back({fmt::format("largest turning increase, {} side [deg]", side), "", number(m.turning_increase)});
}

const char* reference_name(BulgeReference reference)
{
    return reference == BulgeReference::exact ? "exact" : "triangles";
}

void bulge_rows(Rows& rows, const QualityReport& q)
{
    rows.push_back({"bulge of the compressed side [mm]", "0", number(q.bulge_max_mm)});
    rows.push_back({"bulge RMS [mm]", "0", number(q.bulge_rms_mm)});
    rows.push_back(
        {"bulge measured from", q.bulge_reference == BulgeReference::exact ? "exact faces" : "triangles before", ""});
    rows.push_back({"bulge / largest slide", "0", number(q.bulge_fraction)});
    rows.push_back(
        {"bulge at [mm]", "", fmt::format("({:.4g}, {:.4g}, {:.4g})", q.bulge_at.x(), q.bulge_at.y(), q.bulge_at.z())});
}

void triangle_rows(Rows& rows, const QualityReport& q)
{
    rows.push_back({"smallest angle [deg]", number(q.min_angle_before), number(q.min_angle_after)});
    rows.push_back({"squash", "1", number(q.squash)});
    rows.push_back({"smallest area ratio", "1", number(q.min_area_ratio)});
    rows.push_back({"flipped triangles", "0", std::to_string(q.flipped)});
    rows.push_back({"crease change across the rim mean, max [deg]", "",
                    number(q.rim_crease_mean_change) + ", " + number(q.rim_crease_max_change)});
    if (q.extension_crease_mean_change) {
        rows.push_back({"crease change across the prolonged line mean, max [deg]", "",
                        number(*q.extension_crease_mean_change) + ", " + number(*q.extension_crease_max_change)});
    }
    rows.push_back({"self-intersections", "", std::to_string(q.self_intersections)});
    if (q.symmetry_residual_mm) {
        rows.push_back({"symmetry residual [mm]", "", number(*q.symmetry_residual_mm)});
    }
}

void solver_rows(Rows& rows, const SolverMeasures& s)
{
    rows.push_back({"method", "", s.method});
    rows.push_back({"solver iterations", "", std::to_string(s.iterations)});
    rows.push_back({"solver error estimate [mm]", "", number(s.error_estimate_mm)});
    if (s.uniqueness_mm) {
        rows.push_back({"uniqueness: distance from a second start [mm]", "", number(*s.uniqueness_mm)});
    }
}

} // namespace

SolverMeasures solver_measures(const MoveResult& move)
{
    SolverMeasures measures{
        std::string(method_info(move.method).name), move.iterations(), move.error_estimate_mm(), {}};
    if (move.uniqueness.checked) {
        measures.uniqueness_mm = move.uniqueness.distance_mm;
    }
    return measures;
}

std::string text_table(const Rows& rows)
{
    // Widths count characters, not bytes.
    const auto width = [](const std::string& s) {
        return std::ranges::count_if(s, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    };
    std::vector<std::ptrdiff_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t k = 0; k < row.size(); ++k) {
            widths[k] = std::max(widths[k], width(row[k]));
        }
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const std::string pad(static_cast<std::size_t>(widths[k] - width(row[k])), ' ');
            line += k == 0 ? row[k] + pad : "  " + pad + row[k];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

ordered_json measures_json(const Measures& m)
{
    const QualityReport& q = m.quality;
    const auto when = [](bool there, const ordered_json& value) { return there ? value : ordered_json(nullptr); };
    ordered_json json;
    json["line_error_max_mm"] = when(m.has_target, q.line_error_max_mm);
    json["chord_error_max_mm"] = when(m.has_target, q.chord_error_max_mm);
    const bool line = m.has_rest && m.has_line;
    json["slide_max_mm"] = when(line, q.slide_max_mm);
    json["bulge"] = when(m.has_compressed, {{"max_mm", q.bulge_max_mm},
                                            {"rms_mm", q.bulge_rms_mm},
                                            {"fraction", q.bulge_fraction},
                                            {"at", {q.bulge_at.x(), q.bulge_at.y(), q.bulge_at.z()}},
                                            {"reference", reference_name(q.bulge_reference)},
                                            {"fallback_vertices", q.bulge_fallbacks}});
    json["sections"] = when(line, {{"compressed", when(m.has_compressed, sections_json(q.compressed_sections))},
                                   {"tension", sections_json(q.tension_sections)}});
    json["curvature_sign_change"] =
        when(m.has_rest, {{"gauss", q.gauss_sign_change},
                          {"mean", q.mean_sign_change},
                          {"gauss_compressed", when(m.has_compressed, q.gauss_sign_change_compressed)}});
    ordered_json crease = before_after(q.crease_before, q.crease_after);
    crease["rms_difference"] = q.crease_rms_difference;
    crease["max_difference"] = q.crease_max_difference;
    json["crease"] = when(line, crease);
    json["min_angle"] = when(m.has_rest, before_after(q.min_angle_before, q.min_angle_after));
    json["squash"] = when(line, q.squash);
    json["min_area_ratio"] = when(m.has_rest, q.min_area_ratio);
    json["flipped"] = when(m.has_rest, q.flipped);
    json["self_intersections"] = when(m.has_rest, q.self_intersections);
    json["crown"] = m.has_rest && m.has_line && q.crown
                        ? ordered_json{{"change", q.crown->change}, {"local", q.crown->local}}
                        : ordered_json(nullptr);
    json["rim_crease"] =
        when(m.has_rest, {{"mean_change", q.rim_crease_mean_change}, {"max_change", q.rim_crease_max_change}});
    json["extension_crease"] =
        when(q.extension_crease_mean_change.has_value(), {{"mean_change", q.extension_crease_mean_change.value_or(0)},
                                                          {"max_change", q.extension_crease_max_change.value_or(0)}});
    json["symmetry_residual_mm"] =
        q.symmetry_residual_mm ? ordered_json(*q.symmetry_residual_mm) : ordered_json(nullptr);
    if (m.solver) {
        json["solver"] = {{"method", m.solver->method},
                          {"iterations", m.solver->iterations},
                          {"error_estimate_mm", m.solver->error_estimate_mm},
                          {"uniqueness_mm",
                           m.solver->uniqueness_mm ? ordered_json(*m.solver->uniqueness_mm) : ordered_json(nullptr)}};
    }
    if (m.surface_distance_max_mm) {
        json["surface_distance"] = {{"max_mm", *m.surface_distance_max_mm},
                                    {"rms_mm", *m.surface_distance_rms_mm},
                                    {"reference", reference_name(m.surface_distance_reference)}};
    }
    return json;
}

Rows measure_rows(const Measures& m)
{
    const QualityReport& q = m.quality;
    Rows rows = {{"measure", "before", "after"}};
    if (m.solver) {
        solver_rows(rows, *m.solver);
    }
    if (m.has_target) {
        rows.push_back({"line error [mm]", "", number(q.line_error_max_mm)});
        rows.push_back({"chord error [mm]", "", number(q.chord_error_max_mm)});
    }
    if (m.has_rest && m.has_line) {
        rows.push_back({"largest slide of the line [mm]", "", number(q.slide_max_mm)});
    }
    if (m.has_compressed) {
        bulge_rows(rows, q);
        section_rows(rows, "compressed", q.compressed_sections);
    }
    if (m.has_rest && m.has_line) {
        section_rows(rows, m.has_compressed ? "tension" : "either", q.tension_sections);
        rows.push_back({"crease angle [deg]", number(q.crease_before), number(q.crease_after)});
        rows.push_back({"crease change RMS, max [deg]", "",
                        number(q.crease_rms_difference) + ", " + number(q.crease_max_difference)});
    }
    if (m.has_rest) {
        rows.push_back({"area with changed Gauss curvature sign [%]", "", number(100 * q.gauss_sign_change)});
        if (m.has_compressed) {
            rows.push_back({"the same on the compressed side [%]", "", number(100 * q.gauss_sign_change_compressed)});
        }
        if (q.crown && m.has_line) {
            rows.push_back({"crown of the tension side, relative change", "", number(q.crown->change)});
            rows.push_back({"the same, vertex by vertex", "", number(q.crown->local)});
        }
        rows.push_back({"area with changed mean curvature sign [%]", "", number(100 * q.mean_sign_change)});
        triangle_rows(rows, q);
    }
    if (m.surface_distance_max_mm) {
        rows.push_back({"largest distance to the surface before [mm]", "", number(*m.surface_distance_max_mm)});
        rows.push_back({"RMS distance to the surface before [mm]", "", number(*m.surface_distance_rms_mm)});
    }
    return rows;
}

std::string measures_table(const Measures& m) { return text_table(measure_rows(m)); }

std::vector<GateResult> evaluate_gates(const GateSettings& s, const Measures& m)
{
    const QualityReport& q = m.quality;
    const bool line = m.has_rest && m.has_line;
    std::vector<GateResult> gates;
    const auto gate = [&](const char* name, std::optional<double> limit, bool there, double value, bool at_most) {
        if (limit) {
            const bool kept = there && (at_most ? value <= *limit : value >= *limit);
            gates.push_back({name, *limit, there ? std::optional<double>(value) : std::nullopt, kept});
        }
    };
    // The tension side is pulled straight by the method, so its sections are shown but not judged.
    const SectionMeasure& sections = m.has_compressed ? q.compressed_sections : q.tension_sections;
    gate("max_bulge", s.max_bulge, m.has_compressed, std::abs(q.bulge_max_mm), true);
    gate("max_inflections", s.max_inflections, line, new_inflections(sections), true);
    gate("max_turning_increase", s.max_turning_increase, line, sections.turning_increase, true);
    gate("min_squash", s.min_squash, line, q.squash, false);
    gate("max_flipped", s.max_flipped, m.has_rest, q.flipped, true);
    gate("max_line_error", s.max_line_error, m.has_target, q.line_error_max_mm, true);
    gate("max_crease_change", s.max_crease_change, line, q.crease_max_difference, true);
    return gates;
}

std::optional<Error> gate_failure(const std::vector<GateResult>& gates)
{
    std::vector<std::string> missed;
    for (const GateResult& gate : gates) {
        if (!gate.passed) {
            missed.push_back(gate.value ? fmt::format("{} is {:.6g}, limit {:.6g}", gate.name, *gate.value, gate.limit)
                                        : fmt::format("{} could not be measured", gate.name));
        }
    }
    if (missed.empty()) {
        return std::nullopt;
    }
    return Error{ErrorKind::quality_gate, fmt::format("quality gate failed: {}", fmt::join(missed, "; "))};
}

ordered_json gates_json(const std::vector<GateResult>& gates)
{
    ordered_json list = ordered_json::array();
    for (const GateResult& gate : gates) {
        list.push_back({{"name", gate.name},
                        {"limit", gate.limit},
                        {"value", gate.value ? ordered_json(*gate.value) : ordered_json(nullptr)},
                        {"passed", gate.passed}});
    }
    return list;
}

QualityInput quality_input(const MoveResult& move, const TargetCurve& target)
{
    QualityInput input{move.rest.mesh, move.V, {}, false, {}, {}, nullptr, 9};
    input.line = move.correspondence.line.vertices;
    input.closed = move.correspondence.line.closed;
    input.target = &target;
    input.extended_line = move.extended_line;
    input.cad = &move.rest;
    for (const StripReport& strip : move.strips) {
        input.carried.insert(input.carried.end(), strip.vertices.begin(), strip.vertices.end());
    }
    if (move.placement.verdict == Placement::off_surface) {
        input.tension_faces = move.region.faces;
        return input;
    }
    std::pair sides(move.left_faces, move.right_faces);
    if (sides.first.empty() || sides.second.empty()) {
        sides = sides_of_line(move.rest.mesh, move.region.faces, input.line, input.closed);
    }
    StrainedParts parts = strained_parts(move.rest.mesh, sides, input.line, input.closed,
                                         move.correspondence.displacements, move.placement.compressed);
    input.compressed_faces = std::move(parts.compressed);
    input.tension_faces = std::move(parts.tension);
    return input;
}

Result<Measures> measure_move(const MoveResult& move, const TargetCurve& target)
{
    const QualityInput input = quality_input(move, target);
    return measure_quality(input).map([&](QualityReport report) {
        Measures measures;
        measures.quality = std::move(report);
        measures.solver = solver_measures(move);
        measures.has_line = measures.has_target = measures.has_rest = true;
        measures.has_compressed = !input.compressed_faces.empty();
        return measures;
    });
}

} // namespace tapeline
