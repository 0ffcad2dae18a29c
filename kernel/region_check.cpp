// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/region_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

std::string point_place(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

int edges_of(const FeatureLine& line) { return static_cast<int>(line.vertices.size()) - (line.closed ? 0 : 1); }

bool contains(const std::vector<int>& sorted, int value) { return std::ranges::binary_search(sorted, value); }

bool has_area(const Mesh& mesh, int t)
{
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (mesh.V.row(mesh.F(t, k)) - mesh.V.row(mesh.F(t, (k + 1) % 3))).squaredNorm());
    }
    return triangle_area(mesh, t) > 1e-12 * longest;
}

/// What the user can do when the region leaves out a piece of the line.
std::string remedy_for_missing(const RegionOptions& options)
{
    if (!options.cad_faces.empty()) {
        return "add the CAD faces on both sides of the line, or select a part of the line (ID@FROM..TO)";
    }
    if (options.box) {
        return "enlarge the box, or select a part of the line (ID@FROM..TO)";
    }
    return "the triangles there are longer than the region is wide: remesh it (a smaller max_edge) or enlarge the "
           "region's distance";
}

} // namespace

std::string vertex_place(const Mesh& mesh, int v)
{
    return fmt::format("vertex {} at {}", v, point_place(mesh.V.row(v)));
}

Result<void> check_request(const Model& model, const Topology& topology, const FeatureLine& line,
                           const std::vector<Vec3>& targets, const RegionOptions& options)
{
    const int ways = (options.cad_faces.empty() ? 0 : 1) + (options.bounding_lines.empty() ? 0 : 1) +
                     (options.box ? 1 : 0) + (options.distance_mm != 0 ? 1 : 0);
    if (ways > 1) {
        return fail(ErrorKind::usage,
                    "a region is chosen by distance, by CAD faces, by bounding lines or by a box: give "
                    "only one of them");
    }
    if (!(options.distance_mm >= 0) || !std::isfinite(options.distance_mm)) {
        return fail(ErrorKind::usage,
                    fmt::format("the region's distance must be a positive length, not {} mm", options.distance_mm));
    }
    if (options.box && (options.box->isEmpty() || !options.box->min().allFinite() || !options.box->max().allFinite())) {
        return fail(ErrorKind::usage, "the region's box is empty; give its lower corner first");
    }
    const int vertex_count = static_cast<int>(model.mesh.V.rows());
    for (const int v : options.fixed_vertices) {
        if (v < 0 || v >= vertex_count) {
            return fail(ErrorKind::rejected,
                        fmt::format("the fixed vertex {} does not exist: the model has vertices 0 to "
                                    "{}",
                                    v, vertex_count - 1));
        }
        if (std::ranges::count(line.vertices, v) > 0) {
            return fail(ErrorKind::rejected, fmt::format("{} is to stay fixed but lies on the line that moves",
                                                         vertex_place(model.mesh, v)));
        }
    }
    if (!targets.empty() && targets.size() != line.vertices.size()) {
        return fail(ErrorKind::usage,
                    fmt::format("{} targets were given for {} line vertices", targets.size(), line.vertices.size()));
    }
    for (const Vec3& target : targets) {
        if (!target.allFinite()) {
            return fail(ErrorKind::rejected, "a target position is not a finite number");
        }
    }
    if (edges_of(line) < 1) {
        return fail(ErrorKind::rejected, "the line has no edge");
    }
    for (int i = 0; i < edges_of(line); ++i) {
        const int a = line.vertices[i], b = line.vertices[(i + 1) % line.vertices.size()];
        if (a < 0 || b < 0 || a >= vertex_count || b >= vertex_count || topology.find_edge(a, b) < 0) {
            return fail(ErrorKind::rejected, fmt::format("no mesh edge joins the line's vertices {} and {}", a, b));
        }
        if (topology.edge(topology.find_edge(a, b)).border()) {
            return fail(ErrorKind::rejected,
                        fmt::format("the line runs on the model's open border from {}; only lines with surface on both "
                                    "sides can be moved",
                                    vertex_place(model.mesh, a)));
        }
    }
    return {};
}

Result<void> check_region(const Model& model, const Topology& topology, const FeatureLine& line, const Region& region,
                          const RegionOptions& options)
{
    const Mesh& mesh = model.mesh;
    for (int i = 0; i < edges_of(line); ++i) {
        const int a = line.vertices[i], b = line.vertices[(i + 1) % line.vertices.size()];
        const MeshEdge& edge = topology.edge(topology.find_edge(a, b));
        if (!contains(region.faces, edge.left) || !contains(region.faces, edge.right)) {
            return fail(ErrorKind::rejected,
                        fmt::format("the region does not hold the triangles beside the line at {}; {}",
                                    vertex_place(mesh, a), remedy_for_missing(options)));
        }
    }
    for (size_t i = 0; i < line.vertices.size(); ++i) {
        const bool end = !line.closed && (i == 0 || i + 1 == line.vertices.size());
        if (!end && contains(region.fixed_rim, line.vertices[i])) {
            return fail(
                ErrorKind::rejected,
                fmt::format("the line touches the region's fixed rim at {}; enlarge the region or select a part "
                            "of the line (ID@FROM..TO)",
                            vertex_place(mesh, line.vertices[i])));
        }
    }
    for (const int t : region.faces) {
        if (!has_area(mesh, t)) {
            return fail(ErrorKind::rejected,
                        fmt::format("triangle {} in the region has no area (its corners lie on one "
                                    "line near {}); remesh or repair the model",
                                    t, vertex_place(mesh, mesh.F(t, 0))));
        }
        for (const int e : topology.face_edges(t)) {
            const MeshEdge& edge = topology.edge(e);
            const bool turned = edge.face_count == 2 && (edge.left < 0 || edge.right < 0);
            if (edge.face_count > 2 || turned) {
                return fail(
                    ErrorKind::rejected,
                    fmt::format("{} at the edge from {} to vertex {} inside the region; repair the model or choose "
                                "a smaller region",
                                turned ? "two triangles face opposite ways"
                                       : fmt::format("{} triangles meet", edge.face_count),
                                vertex_place(mesh, edge.a), edge.b));
            }
        }
    }
    if (region.fixed_rim.empty()) {
        return fail(ErrorKind::rejected,
                    options.free_borders
                        ? "the region has no fixed rim: it holds the whole surface and its borders are free; choose a "
                          "smaller region"
                        : "the region has no fixed rim: it holds the whole closed surface; choose a smaller region");
    }
    return {};
}

namespace {

/// True when the foot lies on the fixed rim itself.
bool on_rim(const Mesh& mesh, const Region& region, const MeshFoot& foot)
{
    bool rim = true;
    int corners = 0;
    for (int k = 0; k < 3; ++k) {
        if (foot.barycentric[k] > 1e-9) {
            ++corners;
            rim = rim && contains(region.fixed_rim, mesh.F(foot.face, k));
        }
    }
    return rim && corners < 3;
}

Result<void> check_distance(const Mesh& mesh, const FeatureLine& line, const std::vector<Vec3>& targets,
                            const std::vector<MeshFoot>& feet, const Region& region)
{
    if (region.distance_mm <= 0 || targets.empty()) {
        return {};
    }
    const auto moved = [&](size_t i) { return (targets[i] - Vec3(mesh.V.row(line.vertices[i]))).norm(); };
    size_t nearest = 0, highest = 0;
    for (size_t i = 1; i < targets.size(); ++i) {
        nearest = moved(i) < moved(nearest) ? i : nearest;
        highest = feet[i].distance > feet[highest].distance ? i : highest;
    }
    std::vector<size_t> decisive{nearest};
    if (!line.closed) {
        decisive.insert(decisive.end(), {0, targets.size() - 1});
    }
    for (const size_t i : decisive) {
        if (moved(i) > region.distance_mm) {
            return fail(
                ErrorKind::rejected,
                fmt::format("the target starts {:.4g} mm away from the line ({}), more than the region's width of "
                            "{:.4g} mm; move the target nearer or enlarge the region's distance",
                            moved(i), vertex_place(mesh, line.vertices[i]), region.distance_mm));
        }
    }
    if (feet[highest].distance > region.distance_mm) {
        return fail(
            ErrorKind::rejected,
            fmt::format("the target lies {:.4g} mm off the surface near {}, more than the region's width of {:.4g} "
                        "mm; move the target nearer or enlarge the region's distance",
                        feet[highest].distance, point_place(targets[highest]), region.distance_mm));
    }
    return {};
}

} // namespace

Result<void> check_targets(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets,
                           const std::vector<MeshFoot>& feet, const Region& region)
{
    const Mesh& mesh = model.mesh;
    if (auto distance = check_distance(mesh, line, targets, feet, region); !distance) {
        return distance;
    }
    const auto outside = [&](const MeshFoot& foot) { return foot.face >= 0 && !contains(region.faces, foot.face); };
    if (!targets.empty() && std::ranges::all_of(feet, outside)) {
        return fail(
            ErrorKind::rejected,
            fmt::format("the target lies outside the region: it starts {:.4g} mm away from {}; enlarge the region "
                        "so that it holds both lines",
                        (targets.front() - Vec3(mesh.V.row(line.vertices.front()))).norm(),
                        vertex_place(mesh, line.vertices.front())));
    }
    for (size_t i = 0; i < targets.size(); ++i) {
        const int v = line.vertices[i];
        const bool end = !line.closed && (i == 0 || i + 1 == targets.size());
        const bool touches_anyway = end && contains(region.fixed_rim, v);
        if (outside(feet[i]) || (!touches_anyway && feet[i].face >= 0 && on_rim(mesh, region, feet[i]))) {
            return fail(ErrorKind::rejected,
                        fmt::format("the target crosses the region's fixed rim near {} (the goal of line vertex {}); "
                                    "enlarge the region or move the target inside it",
                                    point_place(targets[i]), v));
        }
    }
    return {};
}

} // namespace tapeline
