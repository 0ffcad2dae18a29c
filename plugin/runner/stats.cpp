// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/stats.h"

#include "plugin/runner/json_text.h"
#include "plugin/runner/strips.h"

#include <fmt/format.h>

namespace tapeline {

namespace {

using nlohmann::ordered_json;

const char* side_name(LineSide side) { return side == LineSide::left ? "left" : "right"; }

const char* retraction_name(RetractionMode mode)
{
    switch (mode) {
    case RetractionMode::planes:
        return "planes";
    case RetractionMode::sequential:
        return "sequential";
    case RetractionMode::harmonic:
        break;
    }
    return "harmonic";
}

ordered_json line_json(const FeatureLine& line)
{
    return {{"id", line.id},
            {"vertices", line.vertices},
            {"closed", line.closed},
            {"length_mm", line.length_mm},
            {"crease_angle_mean", line.crease_angle_mean},
            {"cad_edges", line.cad_edges}};
}

ordered_json target_json(const TargetChoice& target)
{
    const BSplineData data = target.line.data();
    return {{"source", target.source},
            {"degree", data.degree},
            {"control_points", data.control_points.size()},
            {"closed", data.closed},
            {"length_mm", target.line.length()},
            {"fit_error_mm", target.fit_error_mm}};
}

ordered_json region_json(const Region& region)
{
    std::vector<int> fixed;
    std::ranges::set_union(region.fixed_rim, region.inner_fixed, std::back_inserter(fixed));
    return {{"vertices", region.vertices.size()},
            {"faces", region.faces.size()},
            {"distance_mm", region.distance_mm},
            {"fixed", fixed}};
}

ordered_json extension_json(const MoveResult& move)
{
    ordered_json appended = ordered_json::array();
    for (const AppendedVertex& vertex : move.appended) {
        appended.push_back({vertex.a, vertex.b, vertex.t});
    }
    return {{"mode", move.extension_path == ExtensionPath::geodesic ? "geodesic" : "edges"},
            {"target", move.extension_target == ExtensionTarget::tapered ? "tapered" : "free"},
            {"added_vertices", move.appended.size()},
            {"appended", appended},
            {"end_slide_mm", {move.end_slide[0], move.end_slide[1]}},
            {"line", move.extended_line}};
}

ordered_json remesh_json(const RemeshInfo& remesh)
{
    return {{"applied", remesh.applied},
            {"max_edge_mm", remesh.max_edge_mm},
            {"min_angle_before", remesh.min_angle_before},
            {"min_angle_after", remesh.min_angle_after},
            {"added_vertices", remesh.added_vertices},
            {"projected", remesh.projected}};
}

/// The numbers of an import that are counts of findings, with what they count.
std::vector<std::pair<const char*, int>> findings(const ImportReport& r)
{
    return {{"welded corners", r.welded_corners},
            {"triangulated polygons", r.triangulated_polygons},
            {"degenerate faces removed", r.degenerate_faces},
            {"duplicate faces removed", r.duplicate_faces},
            {"isolated vertices removed", r.isolated_vertices},
            {"faces turned round", r.flipped_faces},
            {"non-manifold edges split", r.non_manifold_edges},
            {"non-manifold vertices split", r.non_manifold_vertices},
            {"border edges", r.border_edges},
            {"CAD faces", r.cad_faces},
            {"CAD edges", r.cad_edges},
            {"sewn edges", r.sewn_edges},
            {"CAD faces without triangles", r.faces_without_triangles},
            {"folded triangles put right", r.folded_triangles},
            {"folded triangles left", r.folded_triangles_left}};
}

} // namespace

ordered_json placement_json(const PlacementResult& p)
{
    const bool on = p.verdict == Placement::on_surface;
    return {{"verdict", on ? "on_surface" : "off_surface"},
            {"off_fraction", p.off_fraction},
            {"normal_fraction", p.normal_fraction},
            {"whole_share", p.whole_share},
            {"compressed_side", on ? ordered_json(side_name(p.compressed)) : ordered_json(nullptr)},
            {"c_left", p.c_left},
            {"c_right", p.c_right},
            {"s_alpha", p.s_alpha},
            {"s_beta", p.s_beta},
            {"u_max_mm", p.u_max_mm}};
}

ordered_json solve_json(const std::vector<SolveReport>& solves)
{
    ordered_json list = ordered_json::array();
    for (const SolveReport& solve : solves) {
        list.push_back({{"side", solve.side},
                        {"iterations", solve.iterations},
                        {"error_estimate_mm", solve.error_estimate_mm},
                        {"tolerance_mm", solve.tolerance_mm},
                        {"converged", solve.converged},
                        {"seconds", solve.seconds},
                        {"energy", solve.energy}});
    }
    return list;
}

ordered_json uniqueness_json(const MoveResult& move)
{
    const UniquenessReport& u = move.uniqueness;
    if (!u.checked) {
        return nullptr;
    }
    ordered_json energies = ordered_json::array();
    for (const UniquenessReport::Energies& e : u.energies) {
        energies.push_back({{"side", e.side}, {"from_harmonic", e.harmonic}, {"from_rest", e.rest}});
    }
    return {{"distance_mm", u.distance_mm}, {"limit_mm", u.limit_mm}, {"ambiguous", move.ambiguous()},
            {"converged", u.converged},     {"energies", energies},   {"iterations", u.iterations},
            {"seconds", u.seconds}};
}

ordered_json retraction_json(const RetractionReport& r)
{
    return {{"applied", r.applied},
            {"mode", retraction_name(r.mode)},
            {"min_area_ratio", r.min_area_ratio},
            {"flipped", r.flipped},
            {"crossings", r.crossings}};
}

const char* role_word(InnerLineRole role)
{
    return role == InnerLineRole::held ? "held" : (role == InnerLineRole::slides ? "slides" : "follows");
}

ordered_json inner_lines_json(const std::vector<InnerLine>& lines)
{
    ordered_json list = ordered_json::array();
    for (const InnerLine& line : lines) {
        list.push_back({{"id", line.id},
                        {"role", role_word(line.role)},
                        {"length_mm", line.length_mm},
                        {"crease_before", line.crease_before},
                        {"crease_after", line.crease_after},
                        {"crease_change_max", line.crease_change_max},
                        {"off_line_mm", line.off_line_mm}});
    }
    return list;
}

ordered_json exact_surface_json(const ExactSurfaceReport& r)
{
    return {{"applied", r.applied},
            {"vertices", r.vertices},
            {"left", r.left},
            {"distance_before_mm", r.distance_before_mm},
            {"distance_after_mm", r.distance_after_mm},
            {"line_distance_mm", r.line_distance_mm},
            {"line_gap_mm", r.line_gap_mm}};
}

ordered_json stats_json(const Job& job, const JobOutcome& o)
{
    ordered_json stats;
    stats["tool_version"] = version();
    stats["input"] = {{"path", job.input.string()},
                      {"sha256", o.input_sha256},
                      {"units", o.preparation.import.units},
                      {"vertices", o.preparation.import.vertices},
                      {"faces", o.preparation.import.faces}};
    stats["import"] = import_json(o.preparation.import);
    stats["remesh"] = remesh_json(o.preparation.remesh);
    stats["method"] = method_info(o.move.method).name;
    stats["line"] = line_json(o.move.correspondence.line);
    stats["target"] = target_json(*o.preparation.target);
    stats["region"] = region_json(o.move.region);
    stats["placement"] = placement_json(o.move.placement);
    stats["extension"] = extension_json(o.move);
    stats["retraction"] = retraction_json(o.move.retraction);
    stats["strip"] = strips_json(o.move);
    stats["inner_lines"] = inner_lines_json(o.inner_lines);
    stats["exact_surface"] = exact_surface_json(o.move.exact_surface);
    stats["solve"] = solve_json(o.move.solves);
    stats["uniqueness"] = uniqueness_json(o.move);
    const CreaseReport& c = o.move.crease;
    stats["crease"] = {{"applied", c.applied},
                       {"before", c.before},
                       {"after", c.after},
                       {"lost_before_restoration", c.lost_before_restoration}};
    stats["quality"] = measures_json(o.measures);
    stats["gates"] = gates_json(o.gates);
    stats["warnings"] = o.warnings;
    for (const auto& [stage, seconds] : o.seconds) {
        stats["seconds"][stage] = seconds;
    }
    return stats;
}

std::string stats_text(const Job& job, const JobOutcome& outcome) { return json_text(stats_json(job, outcome)); }

ordered_json import_json(const ImportReport& r)
{
    return {{"format", r.format},
            {"units", r.units},
            {"vertices", r.vertices},
            {"faces", r.faces},
            {"welded_corners", r.welded_corners},
            {"triangulated_polygons", r.triangulated_polygons},
            {"degenerate_faces", r.degenerate_faces},
            {"duplicate_faces", r.duplicate_faces},
            {"isolated_vertices", r.isolated_vertices},
            {"flipped_faces", r.flipped_faces},
            {"non_manifold_edges", r.non_manifold_edges},
            {"non_manifold_vertices", r.non_manifold_vertices},
            {"border_edges", r.border_edges},
            {"cad_faces", r.cad_faces},
            {"cad_edges", r.cad_edges},
            {"sewn_edges", r.sewn_edges},
            {"faces_without_triangles", r.faces_without_triangles},
            {"folded_triangles", r.folded_triangles},
            {"folded_triangles_left", r.folded_triangles_left},
            {"area_mm2", r.area_mm2},
            {"exact_area_mm2", r.exact_area_mm2},
            {"warnings", r.warnings}};
}

std::string import_table(const ImportReport& r)
{
    std::vector<std::vector<std::string>> rows = {{"format", r.format},
                                                  {"units", r.units},
                                                  {"vertices", std::to_string(r.vertices)},
                                                  {"triangles", std::to_string(r.faces)}};
    for (const auto& [what, count] : findings(r)) {
        if (count > 0) {
            rows.push_back({what, std::to_string(count)});
        }
    }
    rows.push_back({"area [mm2]", fmt::format("{:.8g}", r.area_mm2)});
    if (r.cad_faces > 0) {
        rows.push_back({"exact area [mm2]", fmt::format("{:.8g}", r.exact_area_mm2)});
    }
    return text_table(rows);
}

} // namespace tapeline
