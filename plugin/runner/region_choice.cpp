// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/region_choice.h"

#include "kernel/parallel.h"
#include "kernel/segment.h"
#include "plugin/runner/vertex_list.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <set>

namespace tapeline {

namespace {

/// Distance of p to a triangle with corners a, b, c (Ericson, Real-Time Collision Detection, 5.1.5).
double triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    const double area2 = normal.squaredNorm();
    const bool inside = area2 > 0 && normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                        normal.dot((a - c).cross(p - c)) >= 0;
    if (inside) {
        return std::abs(normal.dot(p - a)) / std::sqrt(area2);
    }
    return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// Connected part (across edges) of the marked triangles that holds the line's triangles.
std::vector<int> part_with_line(const Mesh& mesh, const FeatureLine& line, const std::vector<char>& marked)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<char> reached(marked.size(), 0);
    std::vector<int> faces;
    const auto reach = [&](int t) {
        if (t >= 0 && !reached[t] && marked[t]) {
            reached[t] = 1;
            faces.push_back(t);
        }
    };
    for (const int v : line.vertices) {
        std::ranges::for_each(topology.vertex_faces(v), reach);
    }
    for (std::size_t k = 0; k < faces.size(); ++k) {
        for (const int e : topology.face_edges(faces[k])) {
            reach(topology.face_across(faces[k], e));
        }
    }
    std::ranges::sort(faces);
    return faces;
}

/// Vertices of a line, the first one repeated where it is closed.
std::vector<int> chain_of(const FeatureLine& line)
{
    std::vector<int> chain = line.vertices;
    if (line.closed) {
        chain.push_back(line.vertices.front());
    }
    return chain;
}

std::set<VertexPair> edges_of(const std::vector<int>& chain)
{
    std::set<VertexPair> edges;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        edges.insert(vertex_pair(chain[i - 1], chain[i]));
    }
    return edges;
}

/// The chosen lines as chains. Rejected when one shares edges with the line `apart`, its continuation included.
Result<std::vector<std::vector<int>>> chosen_chains(const Model& model, const std::vector<FeatureLine>& lines,
                                                    const std::vector<LineSelector>& selectors, const char* flag,
                                                    const FeatureLine* apart)
{
    std::set<VertexPair> taken;
    if (apart) {
        std::vector<int> whole(apart->before.rbegin(), apart->before.rend());
        const std::vector<int> own = chain_of(*apart);
        whole.insert(whole.end(), own.begin(), own.end());
        whole.insert(whole.end(), apart->after.begin(), apart->after.end());
        taken = edges_of(whole);
    }
    std::vector<std::vector<int>> chains;
    for (const LineSelector& selector : selectors) {
        const Result<FeatureLine> line = choose_line(model, lines, selector);
        if (!line) {
            return tl::unexpected(line.error());
        }
        chains.push_back(chain_of(*line));
        const std::set<VertexPair> edges = edges_of(chains.back());
        if (std::ranges::any_of(edges, [&](const VertexPair& edge) { return taken.contains(edge); })) {
            return fail(ErrorKind::usage,
                        fmt::format("{} names line {}, which is the line that moves: name other lines "
                                    "(tapeline lines shows them)",
                                    flag, selector.text));
        }
    }
    return chains;
}

} // namespace

Result<RegionOptions> region_options(const Model& model, const std::vector<FeatureLine>& lines,
                                     const FeatureLine& moving, const RegionSettings& settings)
{
    const int ways = (settings.roi_faces.empty() ? 0 : 1) + (settings.roi_lines.empty() ? 0 : 1) +
                     (settings.roi_box.empty() ? 0 : 1) + (settings.roi_distance > 0 ? 1 : 0);
    if (ways > 1) {
        return fail(ErrorKind::usage, "the region is given in more than one way; keep one of --roi-distance, "
                                      "--roi-faces, --roi-lines and --roi-box");
    }
    const auto unknown = std::ranges::find_if(settings.fixed_vertices, [&](int v) { return v >= model.mesh.V.rows(); });
    if (unknown != settings.fixed_vertices.end()) {
        return fail(ErrorKind::rejected, fmt::format("vertex {} of --fixed-vertices does not exist; the model has {}",
                                                     *unknown, model.mesh.V.rows()));
    }
    RegionOptions options;
    options.distance_mm = settings.roi_distance;
    options.cad_faces = settings.roi_faces;
    options.free_borders = settings.free_borders;
    options.fixed_vertices = settings.fixed_vertices;
    options.fixed_cad_faces = settings.fixed_faces;
    if (!settings.roi_box.empty()) {
        const auto& b = settings.roi_box;
        options.box = Eigen::AlignedBox3d(Vec3(b[0], b[1], b[2]), Vec3(b[3], b[4], b[5]));
        if (options.box->isEmpty()) {
            return fail(ErrorKind::usage, "the region's box (--roi-box) is empty; give xmin, ymin, zmin, then xmax, "
                                          "ymax, zmax");
        }
    }
    const auto chains = [&](const std::vector<LineSelector>& selectors, const char* flag, const FeatureLine* apart) {
        return chosen_chains(model, lines, selectors, flag, apart);
    };
    return chains(settings.roi_lines, "--roi-lines", nullptr)
        .and_then([&](auto bounding) {
            options.bounding_lines = std::move(bounding);
            return chains(settings.hold, "--hold", &moving);
        })
        .and_then([&](auto held) {
            options.held_lines = std::move(held);
            return chains(settings.keep, "--keep", &moving);
        })
        .map([&](auto kept) {
            options.kept_lines = std::move(kept);
            return std::move(options);
        });
}

double automatic_roi_distance(const FeatureLine& line, const std::vector<Vec3>& displacements)
{
    double longest = 0;
    for (const Vec3& u : displacements) {
        longest = std::max(longest, u.norm());
    }
    // A loop spans its length / π.
    return std::max(0.35 * line.length_mm / (line.closed ? std::numbers::pi : 1), 3 * longest);
}

std::vector<int> faces_near(const Mesh& mesh, const FeatureLine& line, const std::vector<Vec3>& points, double distance)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) {
        box.extend(p);
    }
    box.extend(box.min() - Vec3::Constant(distance));
    box.extend(box.max() + Vec3::Constant(distance));
    std::vector<char> marked(mesh.F.rows(), 0);
    parallel_for(static_cast<int>(mesh.F.rows()), [&](int t) {
        const Vec3 a = mesh.V.row(mesh.F(t, 0)), b = mesh.V.row(mesh.F(t, 1)), c = mesh.V.row(mesh.F(t, 2));
        Eigen::AlignedBox3d own(a);
        own.extend(b).extend(c);
        marked[t] = own.intersects(box) && std::ranges::any_of(points, [&](const Vec3& p) {
                        return own.squaredExteriorDistance(p) <= distance * distance &&
                               triangle_distance(p, a, b, c) <= distance;
                    });
    });
    return part_with_line(mesh, line, marked);
}

} // namespace tapeline
