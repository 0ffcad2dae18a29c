// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension_space.h"

#include "kernel/line_tangents.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tapeline {

namespace {

/// Edges at least this sharp belong to feature lines [deg]; the default of FeatureLineOptions.
constexpr double feature_angle = 10;

Vec3 region_normal(const Mesh& mesh, const Topology& topology, const std::vector<char>& in_region, int v)
{
    Vec3 normal = Vec3::Zero();
    for (const int t : topology.vertex_faces(v)) {
        if (in_region[t]) {
            normal += triangle_area(mesh, t) * triangle_normal(mesh, t);
        }
    }
    return normal.normalized();
}

/// Unit direction in which the line arrives at its last vertex; edges much shorter than the line's mean say little, so
/// at least half a mean edge is looked back.
Vec3 end_direction(const Mesh& mesh, const std::vector<int>& line)
{
    const double least = 0.5 * line_length(mesh.V, line, false) / static_cast<double>(line.size() - 1);
    const Vec3 end = mesh.V.row(line.back());
    for (size_t i = line.size() - 1; i-- > 0;) {
        const Vec3 back = end - Vec3(mesh.V.row(line[i]));
        if (back.norm() >= least || i == 0) {
            return back.normalized();
        }
    }
    return Vec3::Zero();
}

} // namespace

ExtensionSpace::ExtensionSpace(const Mesh& mesh, const Region& region)
    : mesh_(mesh), region_(region), topology_(mesh.F, static_cast<int>(mesh.V.rows())), in_region_(mesh.F.rows(), 0),
      loop_(mesh.V.rows(), -1), feature_vertex_(mesh.V.rows(), 0)
{
    for (const int t : region.faces) {
        in_region_[t] = 1;
    }
    label_loops();
    find_features();
}

void ExtensionSpace::label_loops()
{
    const auto rim = [&](const MeshEdge& e) {
        const int sides = (e.left >= 0 && in_region_[e.left] ? 1 : 0) + (e.right >= 0 && in_region_[e.right] ? 1 : 0);
        return sides == 1 || (sides == 2 && e.face_count != 2);
    };
    double longest = -1;
    int count = 0;
    for (const MeshEdge& seed : topology_.edges()) {
        if (!rim(seed) || loop_[seed.a] >= 0) {
            continue;
        }
        double length = 0; // every edge is met from both its ends
        std::vector<int> stack{seed.a};
        loop_[seed.a] = count;
        while (!stack.empty()) {
            const int v = stack.back();
            stack.pop_back();
            for (const int e : topology_.vertex_edges(v)) {
                if (!rim(topology_.edge(e))) {
                    continue;
                }
                const int next = topology_.other_end(e, v);
                length += (mesh_.V.row(next) - mesh_.V.row(v)).norm();
                if (loop_[next] < 0) {
                    loop_[next] = count;
                    stack.push_back(next);
                }
            }
        }
        if (length > longest) {
            longest = length;
            longest_loop_ = count;
        }
        ++count;
    }
}

void ExtensionSpace::find_features()
{
    const double sharp = std::cos(feature_angle * std::numbers::pi / 180);
    for (const MeshEdge& e : topology_.edges()) {
        if (e.left >= 0 && e.right >= 0 && in_region_[e.left] && in_region_[e.right] &&
            triangle_normal(mesh_, e.left).dot(triangle_normal(mesh_, e.right)) < sharp) {
            features_.push_back({e.a, e.b});
        }
    }
}

bool ExtensionSpace::edge_inside(int a, int b) const
{
    const int e = topology_.find_edge(a, b);
    if (e < 0) {
        return false;
    }
    const MeshEdge& edge = topology_.edge(e);
    return edge.left >= 0 && edge.right >= 0 && in_region_[edge.left] && in_region_[edge.right];
}

Result<void> ExtensionSpace::set_line(std::vector<int> line)
{
    std::vector<int> sorted = line;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end()) {
        return fail(ErrorKind::rejected, fmt::format("the line passes vertex {} twice; choose a simple line", *twice));
    }
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec3 at = mesh_.V.row(line[i]);
        if (i > 0 && i + 1 < line.size() && on_rim(line[i])) {
            return fail(
                ErrorKind::rejected,
                fmt::format("the line runs on the region's rim at vertex {}, ({:.6g}, {:.6g}, {:.6g}) mm; enlarge "
                            "the region",
                            line[i], at.x(), at.y(), at.z()));
        }
        if (i > 0 && !edge_inside(line[i - 1], line[i])) {
            return fail(ErrorKind::rejected,
                        fmt::format("line vertices {} and {} at ({:.6g}, {:.6g}, {:.6g}) mm are not joined by an edge "
                                    "inside the region; choose a region that holds the line",
                                    line[i - 1], line[i], at.x(), at.y(), at.z()));
        }
        if (i > 0) {
            line_edges_.push_back(vertex_pair(line[i - 1], line[i]));
        }
    }
    std::sort(line_edges_.begin(), line_edges_.end());
    line_ = std::move(line);
    std::erase_if(features_,
                  [&](const VertexPair& e) { return std::binary_search(line_edges_.begin(), line_edges_.end(), e); });
    for (const VertexPair& e : features_) {
        feature_vertex_[e[0]] = feature_vertex_[e[1]] = 1;
    }
    return {};
}

RouteStart ExtensionSpace::start(bool at_back) const
{
    std::vector<int> line = line_;
    if (!at_back) {
        std::reverse(line.begin(), line.end());
    }
    RouteStart start;
    start.vertex = line.back();
    const Vec3 normal = region_normal(mesh_, topology_, in_region_, start.vertex);
    const Vec3 direction = end_direction(mesh_, line);
    start.forward = (direction - direction.dot(normal) * normal).normalized();
    start.side = normal.cross(start.forward) * (at_back ? 1 : -1);
    return start;
}

RouteSpace ExtensionSpace::routes(int from, const std::vector<PathPoint>& taken, bool clear_of_features) const
{
    RouteSpace space{mesh_, topology_, in_region_, std::vector<char>(mesh_.V.rows(), 0), line_edges_};
    for (int v = 0; v < static_cast<int>(loop_.size()); ++v) {
        space.blocked[v] = loop_[v] >= 0 || (clear_of_features && feature_vertex_[v]) ? 1 : 0;
    }
    for (const auto* list : {&line_, &region_.fixed_rim, &region_.inner_fixed}) {
        for (const int v : *list) {
            space.blocked[v] = 1;
        }
    }
    const auto& fixed = region_.inner_fixed;
    const auto holds = [](const std::vector<int>& list, int v) {
        return std::binary_search(list.begin(), list.end(), v);
    };
    for (const int v : fixed) {
        for (const int e : topology_.vertex_edges(v)) {
            const int other = topology_.other_end(e, v);
            if (other > v ? holds(fixed, other) : holds(region_.fixed_rim, other)) {
                space.walls.push_back(vertex_pair(v, other));
            }
        }
    }
    if (clear_of_features) {
        space.walls.insert(space.walls.end(), features_.begin(), features_.end());
    }
    std::sort(space.walls.begin(), space.walls.end());
    // The other way keeps the triangles that it cuts or follows for itself.
    for (size_t i = 0; i + 1 < taken.size(); ++i) {
        if (taken[i].is_vertex()) {
            space.blocked[taken[i].a] = 1;
        }
        const std::vector<int> here = space.faces_at(taken[i]), next = space.faces_at(taken[i + 1]);
        const bool along_edge = taken[i].is_vertex() && taken[i + 1].is_vertex();
        if (along_edge) {
            space.walls.push_back(vertex_pair(taken[i].a, taken[i + 1].a));
            continue;
        }
        for (const int t : here) {
            if (std::find(next.begin(), next.end(), t) != next.end()) {
                space.allowed[t] = 0;
            }
        }
    }
    std::sort(space.walls.begin(), space.walls.end());
    space.blocked[from] = 0;
    return space;
}

std::vector<int> ExtensionSpace::goal_loops(const std::vector<PathPoint>& taken) const
{
    std::vector<int> loops = loop_;
    for (const int v : line_) {
        loops[v] = -1;
    }
    if (!taken.empty()) {
        loops[taken.back().a] = -1;
    }
    return loops;
}

bool ExtensionSpace::meets_feature(const std::vector<PathPoint>& way) const
{
    for (size_t i = 1; i < way.size(); ++i) {
        const PathPoint& p = way[i];
        const bool met = p.is_vertex() ? feature_vertex_[p.a] && i + 1 < way.size()
                                       : std::binary_search(features_.begin(), features_.end(), VertexPair{p.a, p.b});
        if (met) {
            return true;
        }
    }
    return false;
}

} // namespace tapeline
