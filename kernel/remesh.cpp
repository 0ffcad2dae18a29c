// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/remesh.h"

#include "kernel/remesh_stages.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>

namespace tapeline {

namespace {

Result<void> check_input(const Model& model, const Topology& topology, const std::vector<int>& faces,
                         const RemeshOptions& options)
{
    constexpr double most_triangles = 5e6;
    if (!(options.max_edge_mm > 0) || !std::isfinite(options.max_edge_mm) || options.iterations < 1 ||
        !(options.crease_angle > 0)) {
        return fail(ErrorKind::usage, fmt::format("remeshing needs a positive edge length, crease angle and number of "
                                                  "iterations, not {} mm, {} deg and {}",
                                                  options.max_edge_mm, options.crease_angle, options.iterations));
    }
    for (const std::vector<int>& line : options.keep_lines) {
        for (size_t i = 0; i < line.size(); ++i) {
            // A single vertex has no edge to keep: what goes on behind a line that ends there.
            if (line.size() > 1 && topology.find_edge(line[i], line[i > 0 ? i - 1 : 1]) < 0) {
                return fail(ErrorKind::usage, fmt::format("vertex {} of a line to be kept is not joined to its "
                                                          "neighbour in the line by a mesh edge",
                                                          line[i]));
            }
        }
    }
    double area = 0;
    for (const int t : faces) {
        const double own = triangle_area(model.mesh, t);
        const Vec3 at = model.mesh.V.row(model.mesh.F(t, 0));
        if (!(own > 0) || !std::isfinite(own)) {
            return fail(ErrorKind::rejected,
                        fmt::format("triangle {} at ({:.6g}, {:.6g}, {:.6g}) mm has no area; repair "
                                    "the mesh or choose a region without it",
                                    t, at.x(), at.y(), at.z()));
        }
        for (const int e : topology.face_edges(t)) {
            const MeshEdge& edge = topology.edge(e);
            if (edge.face_count > 2 || (edge.face_count == 2 && (edge.left < 0 || edge.right < 0))) {
                return fail(ErrorKind::rejected,
                            fmt::format("the edge between vertices {} and {} at ({:.6g}, {:.6g}, {:.6g}) mm does not "
                                        "join two triangles of the same orientation; repair the mesh or choose a "
                                        "region without it",
                                        edge.a, edge.b, at.x(), at.y(), at.z()));
            }
        }
        area += own;
    }
    // An equilateral triangle of edge h has the area √3/4 h².
    if (area / (0.433 * options.max_edge_mm * options.max_edge_mm) > most_triangles) {
        return fail(
            ErrorKind::rejected,
            fmt::format("an edge length of {:.4g} mm would give more than five million triangles on {:.4g} mm²; "
                        "ask for longer edges or a smaller region",
                        options.max_edge_mm, area));
    }
    return {};
}

/// Names the worst place where thin triangles remain.
void warn_of_thin(RemeshResult& result)
{
    constexpr double thin = 5;
    int count = 0, worst = -1;
    double smallest = thin;
    for (const int t : result.region_faces) {
        const double angle = triangle_min_angle(result.model.mesh, t);
        count += angle < thin ? 1 : 0;
        if (angle < smallest) {
            smallest = angle;
            worst = t;
        }
    }
    if (worst >= 0) {
        const Vec3 at = result.model.mesh.V.row(result.model.mesh.F(worst, 0));
        result.warnings.push_back(fmt::format("{} triangles below {} deg remain in the remeshed region, the worst with "
                                              "{:.3g} deg at ({:.6g}, {:.6g}, {:.6g}) mm, where feature edges or the "
                                              "input's triangles leave no better",
                                              count, thin, smallest, at.x(), at.y(), at.z()));
    }
}

Result<RemeshResult> remeshed(const Model& model, const std::vector<int>& faces, const RemeshOptions& options)
{
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    if (auto ok = check_input(model, topology, faces, options); !ok) {
        return tl::unexpected(ok.error());
    }
    const Divided divided = divide(model, topology, faces, options);
    const auto patch = remesh_patch(divided, options);
    if (!patch) {
        return tl::unexpected(patch.error());
    }
    std::vector<SurfaceSite> sites;
    RemeshResult result = join(divided, *patch, options, sites);
    const SurfacePlacement placement = place_on_surface(result.model, sites);
    result.projected = placement.placed;
    if (placement.left > 0) {
        result.warnings.push_back(fmt::format("{} of {} new vertices stay off the exact surface, by no more than the "
                                              "tessellation did",
                                              placement.left, placement.left + placement.placed));
    }
    result.min_angle_before = min_angle(model.mesh, faces);
    result.min_angle_after = min_angle(result.model.mesh, result.region_faces);
    warn_of_thin(result);
    return result;
}

} // namespace

double min_angle(const Mesh& mesh, const std::vector<int>& faces)
{
    double smallest = 60;
    for (const int t : faces) {
        smallest = std::min(smallest, triangle_min_angle(mesh, t));
    }
    return smallest;
}

Result<RemeshResult> remesh_region(const Model& model, const std::vector<int>& faces, const RemeshOptions& options)
{
    if (faces.empty()) {
        return fail(ErrorKind::usage, "remeshing was asked for no triangle; choose a region first");
    }
    std::vector<int> region = faces;
    std::sort(region.begin(), region.end());
    region.erase(std::unique(region.begin(), region.end()), region.end());
    if (region.front() < 0 || region.back() >= model.mesh.F.rows()) {
        return fail(ErrorKind::usage,
                    fmt::format("triangle {} is not in the model, which has {}",
                                region.front() < 0 ? region.front() : region.back(), model.mesh.F.rows()));
    }
    try {
        return remeshed(model, region, options);
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("the region could not be remeshed: {}", e.what()));
    }
}

} // namespace tapeline
