// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/region.h"

#include "kernel/closest_point.h"
#include "kernel/feature_rails.h"
#include "kernel/parallel.h"
#include "kernel/region_check.h"
#include "kernel/region_shape.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <iterator>
#include <numbers>

namespace tapeline {

namespace {

constexpr double room_for_slide = 3;     ///< automatic width per largest displacement
constexpr double room_for_length = 0.35; ///< automatic width per line length (closed: per its length / π)
constexpr double narrowest = 1.5;        ///< automatic width is never narrowed below this many displacements
constexpr double room_before_line =
    2;                           ///< displacements between the target and another feature line that ends the region
constexpr double squeezed = 1.5; ///< given widths below this many displacements are warned about

/// The triangles that a way of choosing picked, not yet checked.
struct Choice {
    FaceSet inside;
    double distance_mm = 0;
    std::vector<std::string> warnings;
};

struct Request {
    const Model& model;
    const Topology& topology;
    const FeatureLine& line;
    const std::vector<Vec3>& targets;
    const std::vector<MeshFoot>& feet;
    const RegionOptions& options;
    std::vector<int> beside_line;
    double largest_move = 0;
};

/// Edges of other feature lines that leave room enough before them: an automatic region ends there, so that those
/// lines stay as they are. One flag per edge; empty when there are none.
std::vector<char> lines_that_bound(const Request& r, const std::vector<double>& distance, double room)
{
    std::vector<int> own(r.line.before.rbegin(), r.line.before.rend());
    own.insert(own.end(), r.line.vertices.begin(), r.line.vertices.end());
    own.insert(own.end(), r.line.after.begin(), r.line.after.end());
    std::vector<char> bounds;
    for (const VertexPair& edge : other_feature_edges(r.model, own, r.line.closed)) {
        if (std::min(distance[edge[0]], distance[edge[1]]) >= room) {
            bounds.resize(r.topology.edge_count(), 0);
            bounds[r.topology.find_edge(edge[0], edge[1])] = 1;
        }
    }
    return bounds;
}

FaceSet within(const Request& r, const std::vector<double>& distance, double width,
               const std::vector<char>& bounds = {})
{
    FaceSet inside(r.topology.face_count(), 0);
    for (int t = 0; t < r.topology.face_count(); ++t) {
        const auto corner = [&](int k) { return distance[r.model.mesh.F(t, k)] <= width; };
        inside[t] = corner(0) && corner(1) && corner(2);
    }
    if (!bounds.empty()) {
        inside = connected_part(r.topology, inside, r.beside_line, bounds);
    }
    return tidy(r.model.mesh, r.topology, std::move(inside), r.beside_line);
}

Choice choose_by_distance(const Request& r)
{
    const std::vector<double> distance = band_distance(r.model.mesh, r.topology, r.line, r.feet);
    Choice choice;
    const double length = r.line.length_mm / (r.line.closed ? std::numbers::pi : 1);
    const double edges = static_cast<double>(r.line.vertices.size()) - (r.line.closed ? 0 : 1);
    const double least = std::max(narrowest * r.largest_move, 3 * r.line.length_mm / edges);
    choice.distance_mm = r.options.distance_mm > 0
                             ? r.options.distance_mm
                             : std::max({room_for_slide * r.largest_move, room_for_length * length, least});
    choice.inside = within(r, distance, choice.distance_mm);
    const auto simple = [&](const FaceSet& inside) {
        return shape_of(r.model.mesh, r.topology, inside).simple_around(r.line);
    };
    if (r.options.distance_mm > 0) {
        if (choice.distance_mm < squeezed * r.largest_move) {
            choice.warnings.push_back(fmt::format(
                "the region's width of {:.4g} mm is small for a move of {:.4g} mm: triangles may be squeezed "
                "to {:.0f} % of their width",
                choice.distance_mm, r.largest_move, 100 * choice.distance_mm / (choice.distance_mm + r.largest_move)));
        }
        return choice;
    }
    const std::vector<char> bounds =
        lines_that_bound(r, distance, std::max(room_before_line * r.largest_move, 3 * r.line.length_mm / edges));
    if (FaceSet bounded = bounds.empty() ? FaceSet{} : within(r, distance, choice.distance_mm, bounds);
        !bounded.empty() && simple(bounded)) {
        choice.inside = std::move(bounded);
        return choice;
    }
    // A band that closes round the model or takes in holes cannot be cut into two sides: try narrower ones.
    for (double width = choice.distance_mm; !simple(choice.inside) && width >= least; width *= 0.85) {
        FaceSet narrower = within(r, distance, width);
        if (simple(narrower)) {
            choice.warnings.push_back(fmt::format("the region was narrowed from {:.4g} to {:.4g} mm so that it stays a "
                                                  "disk around the line",
                                                  choice.distance_mm, width));
            choice.inside = std::move(narrower);
            choice.distance_mm = width;
            break;
        }
    }
    return choice;
}

Result<Choice> choose_by_cad_faces(const Request& r)
{
    if (r.model.cad_face.empty()) {
        return fail(ErrorKind::rejected, "the region cannot be chosen by CAD faces: the model is a mesh without them");
    }
    const int known = *std::ranges::max_element(r.model.cad_face);
    for (const int face : r.options.cad_faces) {
        if (face < 0 || std::ranges::count(r.model.cad_face, face) == 0) {
            return fail(ErrorKind::rejected, fmt::format("no CAD face {}: the model has faces 0 to {}", face, known));
        }
    }
    Choice choice;
    choice.inside.assign(r.topology.face_count(), 0);
    for (int t = 0; t < r.topology.face_count(); ++t) {
        choice.inside[t] = std::ranges::count(r.options.cad_faces, r.model.cad_face[t]) > 0;
    }
    choice.inside = connected_part(r.topology, choice.inside, r.beside_line);
    return choice;
}

Result<Choice> choose_by_bounding_lines(const Request& r)
{
    std::vector<char> barrier(r.topology.edge_count(), 0);
    for (const auto& chain : r.options.bounding_lines) {
        for (size_t i = 0; i + 1 < chain.size(); ++i) {
            const int a = chain[i], b = chain[i + 1], n = r.topology.vertex_count();
            const int e = a < 0 || b < 0 || a >= n || b >= n ? -1 : r.topology.find_edge(a, b);
            if (e < 0) {
                return fail(ErrorKind::rejected,
                            fmt::format("no mesh edge joins the bounding line's vertices {} and {}", a, b));
            }
            barrier[e] = 1;
        }
    }
    for (size_t i = 0; i + 1 < r.line.vertices.size() + (r.line.closed ? 1 : 0); ++i) {
        const int a = r.line.vertices[i], b = r.line.vertices[(i + 1) % r.line.vertices.size()];
        if (barrier[r.topology.find_edge(a, b)]) {
            return fail(ErrorKind::rejected,
                        fmt::format("the line to move is also a bounding line at {}", vertex_place(r.model.mesh, a)));
        }
    }
    Choice choice;
    choice.inside = connected_part(r.topology, FaceSet(r.topology.face_count(), 1), r.beside_line, barrier);
    for (int e = 0; e < r.topology.edge_count(); ++e) {
        const MeshEdge& edge = r.topology.edge(e);
        if (barrier[e] && edge.left >= 0 && edge.right >= 0 && choice.inside[edge.left] && choice.inside[edge.right]) {
            choice.warnings.push_back(
                fmt::format("the bounding lines do not close the region off: it reaches both sides "
                            "of them at {}",
                            vertex_place(r.model.mesh, edge.a)));
            break;
        }
    }
    return choice;
}

Choice choose_by_box(const Request& r)
{
    Choice choice;
    choice.inside.assign(r.topology.face_count(), 0);
    for (int t = 0; t < r.topology.face_count(); ++t) {
        const auto corner = [&](int k) {
            return r.options.box->contains(Vec3(r.model.mesh.V.row(r.model.mesh.F(t, k))));
        };
        choice.inside[t] = corner(0) && corner(1) && corner(2);
    }
    choice.inside = tidy(r.model.mesh, r.topology, std::move(choice.inside), r.beside_line);
    return choice;
}

Result<Choice> choose(const Request& r)
{
    if (!r.options.cad_faces.empty()) {
        return choose_by_cad_faces(r);
    }
    if (!r.options.bounding_lines.empty()) {
        return choose_by_bounding_lines(r);
    }
    return r.options.box ? choose_by_box(r) : choose_by_distance(r);
}

/// Tells where the region is more than a disk around the line; the steps after may still manage.
void warn_of_shape(const Request& r, const FaceSet& inside, std::vector<std::string>& warnings)
{
    const RegionShape shape = shape_of(r.model.mesh, r.topology, inside);
    if (shape.openings.empty() || shape.simple_around(r.line)) {
        return;
    }
    if (shape.openings.size() > 1) {
        const int v = shape.openings[1].front();
        warnings.push_back(fmt::format("the region is not a disk around the line: it has {} openings, one at {}{}; a "
                                       "smaller region may leave it out",
                                       shape.openings.size(), vertex_place(r.model.mesh, v),
                                       r.topology.border_vertex(v) ? " (an open border of the model)" : ""));
    } else {
        warnings.push_back("the region is not a disk around the line: it has a handle; choose a smaller region");
    }
}

Region complete(const Topology& topology, std::vector<int> faces, bool free_borders,
                const std::vector<int>& fixed_vertices)
{
    Region region;
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::vector<char> inside(topology.face_count(), 0), seen(topology.vertex_count(), 0);
    std::vector<char> held(topology.vertex_count(), 0);
    for (const int v : fixed_vertices) {
        if (v >= 0 && v < topology.vertex_count()) {
            held[v] = 1;
        }
    }
    for (const int t : faces) {
        inside[t] = 1;
        for (const int e : topology.face_edges(t)) {
            seen[topology.edge(e).a] = seen[topology.edge(e).b] = 1;
        }
    }
    for (int v = 0; v < topology.vertex_count(); ++v) {
        if (!seen[v]) {
            continue;
        }
        region.vertices.push_back(v);
        const bool beside_outside = std::ranges::any_of(topology.vertex_faces(v), [&](int t) { return !inside[t]; });
        if (beside_outside || (!free_borders && topology.border_vertex(v))) {
            region.fixed_rim.push_back(v);
        } else if (held[v]) {
            region.inner_fixed.push_back(v);
        }
    }
    region.faces = std::move(faces);
    return region;
}

/// The chains' edges between two triangles of the region, ascending; a warning for each chain without any.
std::vector<VertexPair> edges_inside(const Topology& topology, const std::vector<std::vector<int>>& chains,
                                     const std::vector<char>& inside, std::vector<std::string>& warnings,
                                     const char* what)
{
    std::vector<VertexPair> edges;
    for (const std::vector<int>& chain : chains) {
        const size_t before = edges.size();
        for (size_t i = 1; i < chain.size(); ++i) {
            const int e = topology.find_edge(chain[i - 1], chain[i]);
            if (e >= 0 && topology.edge(e).face_count == 2 && inside[topology.edge(e).left] &&
                inside[topology.edge(e).right]) {
                edges.push_back(vertex_pair(chain[i - 1], chain[i]));
            }
        }
        if (edges.size() == before) {
            warnings.push_back(fmt::format("the line to be {} from vertex {} to vertex {} lies outside the region: it "
                                           "does not move anyway",
                                           what, chain.empty() ? -1 : chain.front(),
                                           chain.empty() ? -1 : chain.back()));
        }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

Result<Region> make_checked(const Request& r)
{
    auto choice = choose(r);
    if (!choice) {
        return tl::unexpected(choice.error());
    }
    std::vector<int> faces;
    for (int t = 0; t < r.topology.face_count(); ++t) {
        if (choice->inside[t]) {
            faces.push_back(t);
        }
    }
    std::vector<int> fixed = r.options.fixed_vertices;
    for (const std::vector<int>& chain : r.options.held_lines) {
        std::ranges::copy_if(chain, std::back_inserter(fixed),
                             [&](int v) { return std::ranges::count(r.line.vertices, v) == 0; });
    }
    Region region = complete(r.topology, std::move(faces), r.options.free_borders, fixed);
    // What is held is no less a line than what is kept.
    std::ranges::set_union(edges_inside(r.topology, r.options.kept_lines, choice->inside, choice->warnings, "kept"),
                           edges_inside(r.topology, r.options.held_lines, choice->inside, choice->warnings, "held"),
                           std::back_inserter(region.kept_edges));
    region.distance_mm = choice->distance_mm;
    region.warnings = std::move(choice->warnings);
    if (auto checked = check_region(r.model, r.topology, r.line, region, r.options); !checked) {
        return tl::unexpected(checked.error());
    }
    if (auto checked = check_targets(r.model, r.line, r.targets, r.feet, region); !checked) {
        return tl::unexpected(checked.error());
    }
    warn_of_shape(r, choice->inside, region.warnings);
    return region;
}

/// The options with the vertices of the fixed CAD faces among the fixed vertices.
Result<RegionOptions> with_fixed_faces(const Model& model, const RegionOptions& options)
{
    RegionOptions all = options;
    for (const int face : options.fixed_cad_faces) {
        if (std::ranges::find(model.cad_face, face) == model.cad_face.end()) {
            return fail(ErrorKind::rejected,
                        fmt::format("CAD face {}, which is to stay fixed, does not exist in this model", face));
        }
    }
    for (std::size_t t = 0; t < model.cad_face.size() && !options.fixed_cad_faces.empty(); ++t) {
        if (std::ranges::find(options.fixed_cad_faces, model.cad_face[t]) != options.fixed_cad_faces.end()) {
            for (int corner = 0; corner < 3; ++corner) {
                all.fixed_vertices.push_back(model.mesh.F(static_cast<Eigen::Index>(t), corner));
            }
        }
    }
    std::ranges::sort(all.fixed_vertices);
    all.fixed_vertices.erase(std::unique(all.fixed_vertices.begin(), all.fixed_vertices.end()),
                             all.fixed_vertices.end());
    return all;
}

} // namespace

Region region_of_faces(const Model& model, std::vector<int> faces, bool free_borders,
                       const std::vector<int>& fixed_vertices)
{
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    return complete(topology, std::move(faces), free_borders, fixed_vertices);
}

Result<Region> make_region(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets,
                           const RegionOptions& given)
try {
    const Result<RegionOptions> expanded = with_fixed_faces(model, given);
    if (!expanded) {
        return tl::unexpected(expanded.error());
    }
    const RegionOptions& options = *expanded;
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    if (auto checked = check_request(model, topology, line, targets, options); !checked) {
        return tl::unexpected(checked.error());
    }
    std::vector<MeshFoot> feet(targets.size());
    double largest_move = 0;
    if (!targets.empty()) {
        const ClosestPoint surface(model.mesh);
        parallel_for(
            static_cast<int>(targets.size()), [&](int i) { feet[i] = surface.closest(targets[i]); }, 16);
        for (size_t i = 0; i < targets.size(); ++i) {
            largest_move = std::max(largest_move, (targets[i] - Vec3(model.mesh.V.row(line.vertices[i]))).norm());
        }
    }
    return make_checked({model, topology, line, targets, feet, options, faces_along(topology, line), largest_move});
} catch (const std::exception& problem) {
    return fail(ErrorKind::rejected, fmt::format("the region cannot be made: {}", problem.what()));
}

} // namespace tapeline
