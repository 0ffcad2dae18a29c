// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/feature_lines.h"

#include "kernel/crease_edges.h"
#include "kernel/line_chaining.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <set>

namespace tapeline {

namespace {

/// Number of edges of a line.
int edge_count(const FeatureLine& line) { return static_cast<int>(line.vertices.size()) - (line.closed ? 0 : 1); }

double edge_length(const Mesh& mesh, int a, int b) { return (mesh.V.row(a) - mesh.V.row(b)).norm(); }

/// Fills in what is measured along line.vertices.
void measure(const Mesh& mesh, const Topology& topology, const std::vector<int>& cad_edge, FeatureLine& line)
{
    double weighted = 0;
    line.length_mm = 0;
    line.crease_angle_min = 180;
    line.crease_angle_max = 0;
    std::set<int> cad_edges;
    for (int k = 0; k < edge_count(line); ++k) {
        const int a = line.vertices[k], b = line.vertices[(k + 1) % line.vertices.size()];
        const int e = topology.find_edge(a, b);
        const double length = edge_length(mesh, a, b), angle = crease_angle(mesh, topology, e);
        line.length_mm += length;
        weighted += length * angle;
        line.crease_angle_min = std::min(line.crease_angle_min, angle);
        line.crease_angle_max = std::max(line.crease_angle_max, angle);
        if (cad_edge[e] >= 0) {
            cad_edges.insert(cad_edge[e]);
        }
    }
    line.crease_angle_mean = line.length_mm > 0 ? weighted / line.length_mm : 0;
    line.cad_edges.assign(cad_edges.begin(), cad_edges.end());
}

/// Brings a line into its one direction and start, which do not depend on how it was found.
void normalise(FeatureLine& line)
{
    auto& v = line.vertices;
    if (line.closed) {
        std::rotate(v.begin(), std::ranges::min_element(v), v.end());
        if (v.back() < v[1]) {
            std::reverse(v.begin() + 1, v.end());
        }
    } else if (v.back() < v.front()) {
        std::ranges::reverse(v);
    }
}

bool follows_whole_cad_edge(const EdgeChain& chain, const std::vector<int>& cad_edge,
                            const std::vector<int>& edges_of_cad_edge)
{
    std::vector<int> ids;
    for (const int e : chain.edges) {
        if (cad_edge[e] >= 0) {
            ids.push_back(cad_edge[e]);
        }
    }
    return std::ranges::any_of(ids, [&](int id) { return std::ranges::count(ids, id) == edges_of_cad_edge[id]; });
}

/// Longest first. Lengths that agree to rounding count as equal, so that mirrored lines keep their order.
void number_lines(std::vector<FeatureLine>& lines)
{
    const auto smallest = [](const FeatureLine& line) { return std::ranges::min(line.vertices); };
    std::ranges::sort(lines, [&](const FeatureLine& l, const FeatureLine& r) {
        return l.length_mm != r.length_mm ? l.length_mm > r.length_mm : smallest(l) < smallest(r);
    });
    for (size_t from = 0; from < lines.size();) {
        size_t to = from + 1;
        while (to < lines.size() && lines[to - 1].length_mm - lines[to].length_mm <= 1e-9 * lines[from].length_mm) {
            ++to;
        }
        std::sort(lines.begin() + static_cast<long>(from), lines.begin() + static_cast<long>(to),
                  [&](const FeatureLine& l, const FeatureLine& r) {
                      return smallest(l) != smallest(r) ? smallest(l) < smallest(r) : l.vertices < r.vertices;
                  });
        from = to;
    }
    for (size_t i = 0; i < lines.size(); ++i) {
        lines[i].id = static_cast<int>(i);
    }
}

} // namespace

double crease_angle(const Mesh& mesh, const Topology& topology, int e)
{
    const MeshEdge& edge = topology.edge(e);
    if (edge.left < 0 || edge.right < 0) {
        return 0;
    }
    const Vec3 n1 = triangle_normal(mesh, edge.left), n2 = triangle_normal(mesh, edge.right);
    return std::atan2(n1.cross(n2).norm(), n1.dot(n2)) * 180 / std::numbers::pi;
}

std::vector<FeatureLine> find_feature_lines(const Model& model, const FeatureLineOptions& options)
{
    const Mesh& mesh = model.mesh;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const std::vector<int> cad_edge = cad_edge_of_edges(model, topology);
    std::vector<int> edges_of_cad_edge(1 + std::max(0, cad_edge.empty() ? 0 : std::ranges::max(cad_edge)), 0);
    for (const int id : cad_edge) {
        if (id >= 0) {
            ++edges_of_cad_edge[id];
        }
    }
    const auto level =
        crease_edges(model, topology, options.crease_angle, std::min(options.crease_angle, options.crease_angle_low));
    const auto chains = chain_edges(mesh, topology, level, cad_edge, {options.max_turn, options.min_edges});

    std::vector<FeatureLine> lines;
    for (const EdgeChain& chain : chains) {
        FeatureLine line;
        line.vertices = chain.vertices;
        line.closed = chain.closed;
        normalise(line);
        measure(mesh, topology, cad_edge, line);
        const bool long_enough =
            edge_count(line) >= options.min_edges || follows_whole_cad_edge(chain, cad_edge, edges_of_cad_edge);
        if (long_enough && line.length_mm >= options.min_length_mm) {
            lines.push_back(std::move(line));
        }
    }
    number_lines(lines);
    return lines;
}

Result<FeatureLine> line_through(const Model& model, std::vector<int> vertices)
{
    FeatureLine line;
    const int vertex_count = static_cast<int>(model.mesh.V.rows());
    for (const int v : vertices) {
        if (v < 0 || v >= vertex_count) {
            return fail(ErrorKind::rejected, fmt::format("the line names vertex {}, but the model has vertices 0 to {}",
                                                         v, vertex_count - 1));
        }
    }
    line.closed = vertices.size() > 3 && vertices.front() == vertices.back();
    if (line.closed) {
        vertices.pop_back();
    }
    if (vertices.size() < 2) {
        return fail(ErrorKind::rejected,
                    fmt::format("a line needs at least two vertices, the list has {}", vertices.size()));
    }
    std::set<int> seen;
    for (const int v : vertices) {
        if (!seen.insert(v).second) {
            return fail(ErrorKind::rejected,
                        fmt::format("the line passes vertex {} twice; give a list without repeats (a closed line ends "
                                    "on its first vertex)",
                                    v));
        }
    }
    const Topology topology(model.mesh.F, vertex_count);
    line.vertices = std::move(vertices);
    for (int k = 0; k < edge_count(line); ++k) {
        const int a = line.vertices[k], b = line.vertices[(k + 1) % line.vertices.size()];
        if (topology.find_edge(a, b) < 0) {
            return fail(
                ErrorKind::rejected,
                fmt::format("vertices {} and {} follow each other in the line but no mesh edge joins them; list "
                            "every vertex along the line in order",
                            a, b));
        }
    }
    measure(model.mesh, topology, cad_edge_of_edges(model, topology), line);
    return line;
}

std::vector<double> arc_lengths(const Mesh& mesh, const FeatureLine& line)
{
    std::vector<double> lengths{0};
    for (int k = 0; k < edge_count(line); ++k) {
        const int a = line.vertices[k], b = line.vertices[(k + 1) % line.vertices.size()];
        lengths.push_back(lengths.back() + edge_length(mesh, a, b));
    }
    return lengths;
}

FeatureLine part_of_line(const Model& model, const Topology& topology, const FeatureLine& line, int first, int last)
{
    const int n = static_cast<int>(line.vertices.size());
    FeatureLine part;
    part.id = line.id;
    const int edges = last > first ? last - first : last - first + n;
    for (int k = 0; k <= edges; ++k) {
        part.vertices.push_back(line.vertices[(first + k) % n]);
    }
    if (line.closed) {
        // The rest of the loop is shared out between both ends.
        const int rest = n - edges - 1;
        for (int k = 1; k <= rest; ++k) {
            if (k <= rest / 2) {
                part.before.push_back(line.vertices[(first - k + n) % n]);
            } else {
                part.after.push_back(line.vertices[(last + k - rest / 2) % n]);
            }
        }
    } else {
        part.before.assign(line.vertices.rend() - first, line.vertices.rend());
        part.after.assign(line.vertices.begin() + last + 1, line.vertices.end());
        part.before.insert(part.before.end(), line.before.begin(), line.before.end());
        part.after.insert(part.after.end(), line.after.begin(), line.after.end());
    }
    measure(model.mesh, topology, cad_edge_of_edges(model, topology), part);
    return part;
}

} // namespace tapeline
