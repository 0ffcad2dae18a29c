// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why own readers: assimp and tinyobjloader round coordinates to float or parse them inexactly and reorder or join
// vertices; CGAL's soup readers keep both but read through streams, reserve what the header claims before they look
// at the file's size, and name no line when something is wrong. Vertex order, exact doubles and hostile files are
// what this program promises, so the few hundred lines are ours; numbers are parsed by std::from_chars.
#include "io/file_content.h"
#include "io/mesh_readers.h"
#include "io/text_scanner.h"
#include "kernel/polygon.h"
#include "kernel/repair.h"

#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <limits>
#include <new>

namespace tapeline {

namespace {

/// Squares and cubes of lengths must stay finite.
constexpr double largest_coordinate = 1e60;

PolygonSoup read_polygons(FileFormat format, std::string_view content, ImportReport& report)
{
    switch (format) {
    case FileFormat::stl_ascii:
        return read_stl_ascii(content, report);
    case FileFormat::stl_binary:
        return read_stl_binary(content, report);
    case FileFormat::obj:
        return read_obj(content, report);
    case FileFormat::off:
        return read_off(content, report);
    default:
        return read_ply(content, report);
    }
}

/// Triangles of all polygons; those that cannot be triangulated are left out and counted.
Triangles triangulate(const PolygonSoup& soup, ImportReport& report)
{
    std::vector<int> corners;
    corners.reserve(soup.corners.size());
    std::size_t first_lost = soup.size(), lost = 0;
    for (std::size_t i = 0; i < soup.size(); ++i) {
        const auto polygon = soup.polygon(i);
        if (polygon.size() == 3) {
            corners.insert(corners.end(), polygon.begin(), polygon.end());
            continue;
        }
        const auto triangles = triangulate_polygon(soup.points, polygon);
        if (!triangles) {
            first_lost = std::min(first_lost, i);
            ++lost;
            continue;
        }
        (triangles->empty() ? report.degenerate_faces : report.triangulated_polygons) += 1;
        for (const auto& triangle : *triangles) {
            corners.insert(corners.end(), triangle.begin(), triangle.end());
        }
    }
    if (lost > 0) {
        report.degenerate_faces += static_cast<int>(lost);
        const Vec3& p = soup.points[soup.polygon(first_lost)[0]];
        report.warnings.push_back(fmt::format("{} polygons cross or touch themselves and were left out, the first is "
                                              "polygon {} (counted from 0) at ({:.6g}, {:.6g}, {:.6g})",
                                              lost, first_lost, p.x(), p.y(), p.z()));
    }
    if (corners.size() > std::numeric_limits<int>::max()) {
        throw std::length_error("more than 715827882 triangles");
    }
    return Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
}

Mesh to_mesh(const PolygonSoup& soup, double units_mm, ImportReport& report)
{
    Mesh mesh;
    mesh.F = triangulate(soup, report);
    mesh.V.resize(static_cast<Eigen::Index>(soup.points.size()), 3);
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        mesh.V.row(static_cast<Eigen::Index>(v)) = soup.points[v];
    }
    if (units_mm != 1) {
        mesh.V *= units_mm;
    }
    return mesh;
}

/// Sentence about the first thing that makes a mesh useless as a whole; empty when there is none.
std::string useless(const Mesh& mesh)
{
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (!(mesh.V.row(v).cwiseAbs().maxCoeff() <= largest_coordinate)) {
            return fmt::format("vertex {} (counted from 0) lies more than {:g} mm from the origin: check --units or "
                               "correct it",
                               v, largest_coordinate);
        }
    }
    return mesh.F.rows() == 0
               ? "there are no triangles in it (points and lines make no surface): export the model as a "
                 "surface mesh"
               : "";
}

void note_repairs(const RepairedMesh& repaired, ImportReport& report)
{
    const RepairReport& found = repaired.report;
    report.vertices = static_cast<int>(repaired.mesh.V.rows());
    report.faces = static_cast<int>(repaired.mesh.F.rows());
    report.degenerate_faces += found.degenerate_faces;
    report.duplicate_faces = found.duplicate_faces;
    report.zero_area_faces = found.zero_area_faces;
    report.isolated_vertices = found.isolated_vertices;
    report.sewn_edges = found.sewn_edges;
    report.flipped_faces = found.flipped_faces;
    report.non_manifold_edges = found.non_manifold_edges;
    report.non_manifold_edges_left = found.non_manifold_edges_left;
    report.non_manifold_vertices = found.non_manifold_vertices;
    report.non_orientable_pieces = found.non_orientable_components;
    report.border_edges = found.border_edges;
    for (int t = 0; t < report.faces; ++t) {
        report.area_mm2 += triangle_area(repaired.mesh, t);
    }
    report.warnings.insert(report.warnings.end(), found.warnings.begin(), found.warnings.end());
}

std::string unit_text(double units_mm) { return units_mm == 1 ? "mm" : fmt::format("{} mm", units_mm); }

/// The model of a mesh in mm, repaired; `keeps_isolated`: vertices in no triangle stay, so that numbers do.
Result<Model> usable_model(std::string_view name, ErrorKind kind, Mesh mesh, bool keeps_isolated, ImportReport& report)
{
    const auto refused = [&](const std::string& reason) {
        return fail(kind, fmt::format("cannot use {}: {}", name, reason));
    };
    if (const std::string reason = useless(mesh); !reason.empty()) {
        return refused(reason);
    }
    RepairedMesh repaired = repair_mesh(std::move(mesh));
    if (!keeps_isolated) {
        repaired.mesh = without_isolated_vertices(repaired.mesh);
        repaired.report.isolated_vertices = 0;
    }
    note_repairs(repaired, report);
    if (report.faces == 0) {
        return refused("all its triangles are degenerate: export the model again");
    }
    Model model;
    model.mesh = std::move(repaired.mesh);
    return model;
}

/// Everything of `read_mesh` after the bytes are there; throws what the readers throw.
Result<ImportedModel> build_model(std::string_view name, FileFormat format, std::string_view content,
                                  const ImportOptions& options)
{
    ImportedModel result;
    ImportReport& report = result.report;
    report.format = format_name(format);
    report.units = unit_text(options.units_mm);
    Mesh mesh = to_mesh(read_polygons(format, content, report), options.units_mm, report);
    const bool stl = format == FileFormat::stl_ascii || format == FileFormat::stl_binary; // has no vertex numbers
    return usable_model(name, ErrorKind::unreadable, std::move(mesh), !stl, report).map([&](Model model) {
        result.model = std::move(model);
        return std::move(result);
    });
}

Result<void> check_unit(double units_mm)
{
    if (!(units_mm > 0) || !std::isfinite(units_mm)) {
        return fail(ErrorKind::usage, fmt::format("the length of a file unit is {} mm, it must be above 0", units_mm));
    }
    return {};
}

} // namespace

Result<ImportedModel> read_mesh_content(std::string_view name, std::string_view content, const ImportOptions& options)
{
    if (const auto fine = check_unit(options.units_mm); !fine) {
        return tl::unexpected(fine.error());
    }
    const std::string ending = std::filesystem::path(name).extension().string();
    const auto format = require_readable(name, sniff_format(content.substr(0, sniffed_bytes), content.size(), ending));
    if (!format) {
        return tl::unexpected(format.error());
    }
    if (is_cad_format(*format)) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{} is a {} file, not a mesh: read it as a CAD model", name, format_name(*format)));
    }
    if (content.starts_with("\xEF\xBB\xBF") && *format != FileFormat::stl_binary) {
        content.remove_prefix(3);
    }
    try {
        return build_model(name, *format, content, options);
    } catch (const ParseError& error) {
        const std::string place = error.place_is_line ? fmt::format("line {}", line_number(content, error.at))
                                                      : fmt::format("byte {}", error.at);
        return fail(ErrorKind::unreadable,
                    fmt::format("cannot read {} ({}), {}: {}", name, format_name(*format), place, error.message));
    } catch (const std::bad_alloc&) {
        return fail(ErrorKind::unreadable,
                    fmt::format("cannot read {}: the mesh does not fit into memory, reduce it first", name));
    } catch (const std::exception& error) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: {}", name, error.what()));
    }
}

Result<ImportedModel> read_mesh(const std::filesystem::path& path, const ImportOptions& options)
{
    const auto content = read_file_content(path);
    if (!content) {
        return tl::unexpected(content.error());
    }
    return read_mesh_content(path.string(), content->view(), options);
}

Result<ImportedModel> take_mesh(std::string_view name, Mesh mesh, const ImportOptions& options)
{
    if (const auto fine = check_unit(options.units_mm); !fine) {
        return tl::unexpected(fine.error());
    }
    const auto count = static_cast<int>(mesh.V.rows());
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (const int v : mesh.F.row(t)) {
            if (v < 0 || v >= count) {
                return fail(
                    ErrorKind::rejected,
                    fmt::format("cannot use {}: triangle {} names vertex {}, but there are {} vertices, counted "
                                "from 0",
                                name, t, v, count));
            }
        }
    }
    ImportedModel result;
    result.report.format = "arrays";
    result.report.units = unit_text(options.units_mm);
    if (options.units_mm != 1) {
        mesh.V *= options.units_mm;
    }
    return usable_model(name, ErrorKind::rejected, std::move(mesh), true, result.report).map([&](Model model) {
        result.model = std::move(model);
        return std::move(result);
    });
}

} // namespace tapeline
