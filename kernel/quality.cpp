// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/quality.h"

#include "kernel/parallel.h"
#include "kernel/quality_detail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>

namespace tapeline {

namespace quality {

namespace {

/// Unit normals and areas of all triangles.
void measure_faces(const Mesh& mesh, Positions& normals, std::vector<double>& areas)
{
    const int count = static_cast<int>(mesh.F.rows());
    normals.resize(count, 3);
    areas.resize(count);
    parallel_for(count, [&](int t) {
        normals.row(t) = triangle_normal(mesh, t);
        areas[t] = triangle_area(mesh, t);
    });
}

std::string face_complaint(const std::vector<int>& faces, int count)
{
    for (const int t : faces) {
        if (t < 0 || t >= count) {
            return fmt::format("Cannot measure: triangle {} is not in the mesh of {} triangles.", t, count);
        }
    }
    return {};
}

} // namespace

RestShape::RestShape(const Mesh& rest) : topology(rest.F, static_cast<int>(rest.V.rows()))
{
    measure_faces(rest, normals, areas);
}

Context::Context(const QualityInput& quality_input, std::shared_ptr<const RestShape> rest_shape)
    : input(quality_input), rest(quality_input.rest), moved{quality_input.moved, quality_input.rest.F},
      shape(rest_shape ? std::move(rest_shape) : std::make_shared<RestShape>(rest)), topology(shape->topology),
      side(rest.F.rows(), SideOf::none), on_line(rest.V.rows(), 0), rest_normals(shape->normals),
      rest_areas(shape->areas)
{
    for (const int t : input.tension_faces) {
        side[t] = SideOf::tension;
    }
    for (const int t : input.compressed_faces) {
        side[t] = SideOf::compressed;
    }
    std::vector<char> seen(rest.V.rows(), 0);
    for (int t = 0; t < rest.F.rows(); ++t) {
        if (side[t] != SideOf::none) {
            faces.push_back(t);
            seen[rest.F(t, 0)] = seen[rest.F(t, 1)] = seen[rest.F(t, 2)] = 1;
        }
    }
    for (int v = 0; v < rest.V.rows(); ++v) {
        if (seen[v]) {
            vertices.push_back(v);
        }
    }
    for (const int v : input.line) {
        on_line[v] = 1;
    }
    measure_faces(moved, moved_normals, moved_areas);
}

int Context::line_edges() const
{
    const int count = static_cast<int>(input.line.size());
    return input.closed ? count : count - 1;
}

double dihedral(const Mesh& mesh, const Topology& topology, const Positions& normals, int e)
{
    const MeshEdge& edge = topology.edge(e);
    if (edge.left < 0 || edge.right < 0) {
        return 0;
    }
    const Vec3 left = normals.row(edge.left), right = normals.row(edge.right);
    const Vec3 along = (mesh.V.row(edge.b) - mesh.V.row(edge.a)).normalized();
    return std::atan2(left.cross(right).dot(along), left.dot(right));
}

std::string complaint(const QualityInput& input)
{
    const auto vertices = input.rest.V.rows(), faces = input.rest.F.rows();
    if (input.moved.rows() != vertices) {
        return fmt::format("Cannot measure: the moved mesh has {} vertices, the original {}; compare a result with "
                           "the model that it was made from.",
                           input.moved.rows(), vertices);
    }
    if (vertices == 0 || faces == 0) {
        return "Cannot measure: the mesh has no triangles.";
    }
    if (input.rest.F.minCoeff() < 0 || input.rest.F.maxCoeff() >= vertices) {
        return "Cannot measure: a triangle names a vertex that the mesh does not have.";
    }
    for (int v = 0; v < vertices; ++v) {
        if (!input.rest.V.row(v).allFinite() || !input.moved.row(v).allFinite()) {
            return fmt::format("Cannot measure: vertex {} has a coordinate that is not a finite number.", v);
        }
    }
    if (input.line.size() < (input.closed ? 3U : 2U)) {
        return fmt::format("Cannot measure: a line needs at least {} vertices, not {}.", input.closed ? 3 : 2,
                           input.line.size());
    }
    for (const int v : input.line) {
        if (v < 0 || v >= vertices) {
            return fmt::format("Cannot measure: line vertex {} is not in the mesh of {} vertices.", v, vertices);
        }
    }
    if (input.stations < 0) {
        return fmt::format("Cannot measure: the number of sections must not be negative, but it is {}.",
                           input.stations);
    }
    std::string wrong = face_complaint(input.compressed_faces, static_cast<int>(faces));
    return wrong.empty() ? face_complaint(input.tension_faces, static_cast<int>(faces)) : wrong;
}

void measure_strip(const Context& context, QualityReport& report)
{
    measure_line(context, report);
    measure_bulge(context, report);
    measure_sections(context, report);
    measure_creases(context, report);
}

Result<QualityReport> measured(const QualityInput& input, void (*measure)(const Context&, QualityReport&),
                               std::shared_ptr<const RestShape> rest_shape)
{
    const std::string wrong = complaint(input);
    if (!wrong.empty()) {
        return fail(ErrorKind::rejected, wrong);
    }
    try {
        QualityReport report;
        measure(Context(input, std::move(rest_shape)), report);
        return report;
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("Cannot measure the result: {}.", e.what()));
    }
}

} // namespace quality

Result<QualityReport> measure_quality(const QualityInput& input)
{
    return quality::measured(input, [](const quality::Context& context, QualityReport& report) {
        quality::measure_strip(context, report);
        quality::measure_curvature(context, report);
        quality::measure_triangles(context, report);
        quality::measure_intersections(context, report);
        report.symmetry_residual_mm = quality::symmetry_residual(context);
        quality::measure_rim(context, report);
        quality::measure_extension(context, report);
    });
}

Result<QualityReport> measure_strip(const QualityInput& input)
{
    return quality::measured(input, &quality::measure_strip);
}

QualityMaps quality_maps(const QualityInput& input)
{
    QualityMaps maps;
    if (!quality::complaint(input).empty()) {
        return maps;
    }
    const quality::Context context(input);
    maps.bulge_mm = quality::bulge_map(context, context.vertices).mm;
    quality::curvature_maps(context, maps);
    return maps;
}

std::vector<Section> cross_sections(const QualityInput& input)
{
    if (!quality::complaint(input).empty()) {
        return {};
    }
    return quality::cut_sections(quality::Context(input));
}

} // namespace tapeline
