// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cad_shape.h"
#include "io/cap_flip.h"
#include "io/exact_surface.h"
#include "io/face_weld.h"
#include "io/file_format.h"
#include "io/model_file.h"
#include "io/model_repair.h"
#include "io/tessellation.h"

#include <Standard_Failure.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

constexpr int max_triangles = 20'000'000;

struct Deflections {
    double linear_mm, angular;
};

/// The deflections to use, or why those asked for make no mesh.
Result<Deflections> choose_deflections(const std::string& path, const ImportOptions& options, double diagonal)
{
    Deflections chosen{options.linear_deflection_mm, options.angular_deflection};
    if (!(chosen.linear_mm >= 0) || !std::isfinite(chosen.linear_mm)) {
        return fail(ErrorKind::usage,
                    fmt::format("the linear deflection must be a positive length in mm, or 0 for 1e-4 "
                                "of the model's diagonal; it is {}",
                                chosen.linear_mm));
    }
    if (!(chosen.angular >= 0.1 && chosen.angular <= 90)) {
        return fail(
            ErrorKind::usage,
            fmt::format("the angular deflection must lie between 0.1 and 90 degrees; it is {}", chosen.angular));
    }
    if (chosen.linear_mm == 0) {
        chosen.linear_mm = 1e-4 * diagonal;
    } else if (chosen.linear_mm < 1e-7 * diagonal) {
        return fail(ErrorKind::usage,
                    fmt::format("a linear deflection of {} mm would make too many triangles on {}, whose diagonal is "
                                "{:.6g} mm; ask for {:.3g} mm or more",
                                chosen.linear_mm, path, diagonal, 1e-7 * diagonal));
    }
    return chosen;
}

/// A short list for a message: "3, 7, 12 and 20 more".
std::string listing(const std::vector<int>& numbers)
{
    constexpr size_t shown = 10;
    const size_t count = std::min(numbers.size(), shown);
    std::string text = fmt::format("{}", fmt::join(numbers.begin(), numbers.begin() + static_cast<long>(count), ", "));
    return numbers.size() > shown ? fmt::format("{} and {} more", text, numbers.size() - shown) : text;
}

/// The area of the triangles against the exact shape, in all and face by face.
void check_areas(const Model& model, const CadFaces& faces, ImportReport& report)
{
    const std::vector<double> exact = exact_areas(faces);
    std::vector<double> found(exact.size(), 0);
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        found[model.cad_face[t]] += triangle_area(model.mesh, t);
    }
    report.area_mm2 = std::accumulate(found.begin(), found.end(), 0.0);
    report.exact_area_mm2 = std::accumulate(exact.begin(), exact.end(), 0.0);
    std::vector<int> off;
    for (size_t f = 0; f < exact.size(); ++f) {
        const bool counts = exact[f] > 1e-6 * report.exact_area_mm2;
        if (counts && found[f] > 0 && std::abs(found[f] - exact[f]) > 0.05 * exact[f]) {
            off.push_back(static_cast<int>(f));
        }
    }
    if (!(std::abs(report.area_mm2 - report.exact_area_mm2) <= 0.01 * report.exact_area_mm2)) {
        report.warnings.push_back(fmt::format("the triangles' area is {:.6g} mm2, that of the exact faces {:.6g} mm2; "
                                              "ask for a smaller linear deflection or heal the model",
                                              report.area_mm2, report.exact_area_mm2));
    }
    if (!off.empty()) {
        report.warnings.push_back(
            fmt::format("{} CAD faces are covered to less than 95 % or more than 105 %: {}", off.size(), listing(off)));
    }
}

void warn_of_findings(const WeldedFaces& welded, const RepairCounts& counts, const CadFaces& faces,
                      ImportReport& report)
{
    const auto warn = [&report](int count, const char* text) {
        if (count > 0) {
            report.warnings.push_back(fmt::format("{} {}", count, text));
        }
    };
    if (!welded.unmeshed.empty()) {
        report.warnings.push_back(
            fmt::format("{} CAD faces have no triangles: {}; heal or delete them in the CAD program",
                        welded.unmeshed.size(), listing(welded.unmeshed)));
    }
    if (faces.sew_tolerance_mm > 1.001e-3) {
        report.warnings.push_back(fmt::format("CAD edges up to {:.3g} mm apart were sewn", faces.sew_tolerance_mm));
    }
    warn(faces.dropped_faces, "CAD faces smaller than the sewing tolerance were left out");
    warn(welded.unmatched_edges, "CAD edges are subdivided differently by their two faces and were left open");
    warn(welded.folded_triangles, "triangles lie folded over against the exact surface; ask for a smaller linear "
                                  "deflection or heal the model");
    warn(counts.degenerate_faces, "triangles without three different corners were removed");
    warn(counts.duplicate_faces, "triangles that came twice were removed");
    warn(counts.flipped_faces, "triangles were turned round to agree with their neighbours");
    warn(counts.one_sided_edges, "mesh edges of a one-sided surface were cut open");
    warn(counts.non_manifold_edges, "mesh edges with more than two triangles were cut apart");
}

Result<ImportedModel> import_faces(const std::string& path, CadFaces& faces, const Deflections& deflections,
                                   ImportReport report)
{
    const auto unfolded = triangulate_faces(faces, deflections.linear_mm, deflections.angular);
    if (!unfolded) {
        return fail(unfolded.error().kind, fmt::format("{}: {}", path, unfolded.error().message));
    }
    WeldedFaces welded = weld_faces(faces);
    if (welded.non_finite_nodes > 0) {
        return fail(ErrorKind::rejected,
                    fmt::format("{} gives {} mesh nodes that are not finite numbers; heal the model "
                                "in the CAD program",
                                path, welded.non_finite_nodes));
    }
    if (welded.model.mesh.F.rows() == 0) {
        return fail(ErrorKind::rejected,
                    fmt::format("none of the {} faces of {} could be triangulated; heal the model in the CAD program",
                                faces.faces.size(), path));
    }
    if (welded.model.mesh.F.rows() > max_triangles) {
        return fail(ErrorKind::rejected, fmt::format("{} gives {} triangles, more than {}; ask for larger deflections",
                                                     path, welded.model.mesh.F.rows(), max_triangles));
    }
    ImportedModel result{std::move(welded.model), std::move(report)};
    const RepairCounts counts = repair_model(result.model);
    const int caps = flip_caps(result.model);
    std::vector<int> solid;
    for (const int f : result.model.cad_face) {
        solid.push_back(faces.solid[f]);
    }
    const int turned = turn_outward(result.model, solid);
    ImportReport& out = result.report;
    out.vertices = static_cast<int>(result.model.mesh.V.rows());
    out.faces = static_cast<int>(result.model.mesh.F.rows());
    out.degenerate_faces = counts.degenerate_faces;
    out.duplicate_faces = counts.duplicate_faces;
    out.isolated_vertices = counts.isolated_vertices;
    out.flipped_faces = counts.flipped_faces + turned;
    out.non_manifold_edges = counts.non_manifold_edges + counts.one_sided_edges;
    out.non_manifold_vertices = counts.non_manifold_vertices;
    out.border_edges = counts.border_edges;
    out.cad_faces = static_cast<int>(faces.faces.size());
    out.cad_edges = static_cast<int>(faces.edges.size());
    out.sewn_edges = faces.sewn_edges;
    out.folded_triangles = unfolded->found;
    out.folded_triangles_left = welded.folded_triangles;
    out.faces_without_triangles = static_cast<int>(welded.unmeshed.size());
    check_areas(result.model, faces, out);
    warn_of_findings(welded, counts, faces, out);
    if (caps > 0) {
        out.warnings.push_back(fmt::format("{} triangles without area were merged into their neighbours", caps));
    }
    result.model.surface = std::make_shared<ExactSurface>(faces, result.model);
    return result;
}

} // namespace

Result<ImportedModel> read_cad(const std::filesystem::path& path, const ImportOptions& options)
{
    const auto format = readable_file_format(path);
    if (!format) {
        return tl::unexpected(format.error());
    }
    try {
        auto file = read_cad_shape(path, *format);
        if (!file) {
            return tl::unexpected(file.error());
        }
        if (!(options.sew_tolerance_mm >= 0) || !std::isfinite(options.sew_tolerance_mm)) {
            return fail(ErrorKind::usage,
                        fmt::format("the sewing tolerance must be a length in mm; it is {}", options.sew_tolerance_mm));
        }
        auto faces = collect_faces(*file->shape, options.sew_tolerance_mm);
        if (!faces) {
            return fail(faces.error().kind, fmt::format("{}: {}", path.string(), faces.error().message));
        }
        const auto deflections = choose_deflections(path.string(), options, faces_diagonal(*faces));
        if (!deflections) {
            return tl::unexpected(deflections.error());
        }
        ImportReport report;
        report.format = format_name(*format);
        report.units = file->units;
        report.warnings = std::move(file->warnings);
        return import_faces(path.string(), *faces, *deflections, std::move(report));
    } catch (const Standard_Failure& failure) {
        return fail(ErrorKind::rejected,
                    fmt::format("{} cannot be read: OpenCASCADE reports {} {}; heal the model in the CAD program",
                                path.string(), failure.DynamicType()->Name(), failure.GetMessageString()));
    } catch (const std::exception& failure) {
        return fail(ErrorKind::rejected, fmt::format("{} cannot be read: {}", path.string(), failure.what()));
    }
}

} // namespace tapeline
