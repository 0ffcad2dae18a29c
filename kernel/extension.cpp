// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension.h"

#include "kernel/edge_split.h"
#include "kernel/extension_route.h"
#include "kernel/extension_space.h"
#include "kernel/extension_target.h"
#include "kernel/feature_rails.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <iterator>

namespace tapeline {

namespace {

using Path = std::vector<PathPoint>;

std::string place(const Mesh& mesh, int v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
}

Result<void> check_input(const Model& model, const Region& region, const Correspondence& c)
{
    const auto vertices = model.mesh.V.rows();
    const auto& line = c.line.vertices;
    if (line.size() < 2 || c.targets.size() != line.size() || c.displacements.size() != line.size()) {
        return fail(ErrorKind::rejected, fmt::format("the line has {} vertices, {} targets and {} displacements; it "
                                                     "needs at least two, each with both",
                                                     line.size(), c.targets.size(), c.displacements.size()));
    }
    for (const auto* list : {&line, &c.before, &c.after}) {
        for (const int v : *list) {
            if (v < 0 || v >= vertices) {
                return fail(ErrorKind::rejected,
                            fmt::format("line vertex {} is not a vertex of the model, which has {}", v, vertices));
            }
        }
    }
    for (const int t : region.faces) {
        if (t < 0 || t >= model.mesh.F.rows()) {
            return fail(ErrorKind::rejected, fmt::format("region triangle {} is not in the model", t));
        }
    }
    for (size_t i = 0; i < line.size(); ++i) {
        if (!c.displacements[i].allFinite() || !c.targets[i].allFinite()) {
            return fail(ErrorKind::rejected, fmt::format("the target of line vertex {} is not finite", line[i]));
        }
    }
    return {};
}

/// Part of `rest` (L0 beyond an end, nearest first) that the extension follows: up to the rim, or to where L0 ends.
Result<std::vector<int>> follow(const ExtensionSpace& space, int end, const std::vector<int>& rest)
{
    std::vector<int> followed;
    int at = end;
    for (const int v : rest) {
        if (space.on_rim(at)) {
            break;
        }
        if (!space.edge_inside(at, v)) {
            return fail(ErrorKind::rejected,
                        fmt::format("line vertices {} and {} at {} are not joined by an edge inside the region; choose "
                                    "a region that holds the line",
                                    at, v, place(space.mesh(), at)));
        }
        followed.push_back(v);
        at = v;
    }
    return followed;
}

/// The way from one end of the line to the rim. `taken` is the other end's way, which must not be met.
Result<Path> way_to_rim(const ExtensionSpace& space, const RouteStart& start, int wanted_loop, const Path& taken,
                        ExtensionPath kind, std::vector<std::string>& warnings)
{
    constexpr size_t most_tries = 12;
    constexpr double detour = 20; // a feature line in front is crossed rather than go round at this much the cost
    struct Option {
        RouteSpace routes;
        Corridor corridor;
        std::vector<RouteGoal> goals;
    };
    std::vector<Option> options;
    for (const bool clear_of_features : {true, false}) {
        RouteSpace routes = space.routes(start.vertex, taken, clear_of_features);
        Corridor corridor(routes, start.vertex);
        auto goals = rank_goals(routes, corridor, start, space.goal_loops(taken), wanted_loop);
        options.push_back({std::move(routes), std::move(corridor), std::move(goals)});
    }
    const bool clear = !options[0].goals.empty() && !options[1].goals.empty() &&
                       options[0].goals[0].cost <= detour * options[1].goals[0].cost;
    std::string reason = "the rim cannot be reached";
    for (const size_t level : clear ? std::vector<size_t>{0, 1} : std::vector<size_t>{1}) {
        const Option& option = options[level];
        for (size_t i = 0; i < std::min(most_tries, option.goals.size()); ++i) {
            const int to = option.goals[i].vertex;
            Result<Path> path = kind == ExtensionPath::edges
                                    ? route_along_edges(option.routes, start, to)
                                    : route_across(option.routes, option.corridor, start.vertex, to);
            if (path) {
                if (level == 1 && space.meets_feature(*path)) {
                    warnings.push_back(fmt::format("the extension of the line from {} to {} crosses another feature "
                                                   "line",
                                                   place(space.mesh(), start.vertex), place(space.mesh(), to)));
                }
                return path;
            }
            reason = path.error().message;
        }
    }
    return fail(
        ErrorKind::rejected,
        fmt::format("the line's end at {} cannot be prolonged to the region's rim clear of the line ({}); choose "
                    "another region or a longer target",
                    place(space.mesh(), start.vertex), reason));
}

/// Cuts the model along both ways and puts L̂0 together.
void assemble(ExtendedLine& out, const Model& model, const Region& region, const std::vector<int>& before,
              const Correspondence& c, const std::vector<int>& after, const std::array<Path, 2>& ways)
{
    std::vector<EdgePoint> points;
    std::array<std::vector<int>, 2> outer;
    const int old_vertices = static_cast<int>(model.mesh.V.rows());
    for (int side = 0; side < 2; ++side) {
        for (size_t i = 1; i < ways[side].size(); ++i) {
            const PathPoint& p = ways[side][i];
            outer[side].push_back(p.is_vertex() ? p.a : old_vertices + static_cast<int>(points.size()));
            if (!p.is_vertex()) {
                points.push_back({p.a, p.b, p.t});
                out.appended.push_back({p.a, p.b, p.t});
            }
        }
    }
    out.region = region;
    if (points.empty()) {
        out.model = model;
    } else {
        EdgeSplit split = split_edges(model, points);
        const int old_faces = static_cast<int>(model.mesh.F.rows());
        for (int t = old_faces; t < static_cast<int>(split.parent.size()); ++t) {
            if (std::binary_search(region.faces.begin(), region.faces.end(), split.parent[t])) {
                out.region.faces.push_back(t);
            }
        }
        for (int v = old_vertices; v < split.model.mesh.V.rows(); ++v) {
            out.region.vertices.push_back(v);
        }
        out.model = std::move(split.model);
    }
    auto& vertices = out.vertices;
    vertices.assign(outer[0].rbegin(), outer[0].rend());
    vertices.insert(vertices.end(), before.rbegin(), before.rend());
    out.first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), c.line.vertices.begin(), c.line.vertices.end());
    out.last = static_cast<int>(vertices.size()) - 1;
    vertices.insert(vertices.end(), after.begin(), after.end());
    vertices.insert(vertices.end(), outer[1].begin(), outer[1].end());
}

/// L0 is a loop of which a part is used: the unused part of the loop in the line's order; empty when it is no loop.
std::vector<int> rest_of_loop(const Correspondence& c)
{
    if (c.after.empty() || c.before.empty() || c.after.back() != c.before.front()) {
        return {};
    }
    return std::is_permutation(c.after.begin(), c.after.end(), c.before.begin(), c.before.end()) ? c.after
                                                                                                 : std::vector<int>{};
}

/// Replaces kept edges on which the cut put a vertex by their two parts; between held vertices that one is held, too.
void follow_cut(ExtendedLine& cut, int old_vertices)
{
    std::vector<VertexPair>& edges = cut.region.kept_edges;
    std::vector<int>& held = cut.region.inner_fixed;
    const std::vector<int> held_before = held;
    const auto is_held = [&](int v) { return std::ranges::binary_search(held_before, v); };
    for (size_t i = 0; i < cut.appended.size(); ++i) {
        const VertexPair whole = vertex_pair(cut.appended[i].a, cut.appended[i].b);
        const int v = old_vertices + static_cast<int>(i);
        if (std::erase(edges, whole) > 0) {
            edges.push_back(vertex_pair(whole[0], v));
            edges.push_back(vertex_pair(whole[1], v));
            if (is_held(whole[0]) && is_held(whole[1])) {
                held.push_back(v); // numbered after all others
            }
        }
    }
    std::ranges::sort(edges);
}

void keep_loop(ExtendedLine& out, const Model& model, const Region& region, const Correspondence& c,
               const std::vector<int>& rest)
{
    out.model = model;
    out.region = region;
    out.closed = true;
    out.vertices = c.line.vertices;
    out.first = 0;
    out.last = static_cast<int>(out.vertices.size()) - 1;
    out.vertices.insert(out.vertices.end(), rest.begin(), rest.end());
}

Result<void> prolong(ExtendedLine& out, const Model& model, const Region& region, const Correspondence& c,
                     const ExtensionOptions& options)
{
    const auto& line = c.line.vertices;
    ExtensionSpace space(model.mesh, region);
    const auto before = follow(space, line.front(), c.before);
    const auto after = follow(space, line.back(), c.after);
    if (!before || !after) {
        return tl::unexpected(before ? after.error() : before.error());
    }
    std::vector<int> whole(before->rbegin(), before->rend());
    whole.insert(whole.end(), line.begin(), line.end());
    whole.insert(whole.end(), after->begin(), after->end());
    if (auto set = space.set_line(whole); !set) {
        return set;
    }
    // An end that is on the rim already tells the border loop that the other end must reach, too.
    std::array<Path, 2> ways;
    const std::array<int, 2> ends{whole.front(), whole.back()};
    int loop = space.on_rim(ends[0]) ? space.loop_of(ends[0]) : space.loop_of(ends[1]);
    loop = loop >= 0 ? loop : space.longest_loop();
    for (int side = 0; side < 2; ++side) {
        if (space.on_rim(ends[side])) {
            continue;
        }
        auto way = way_to_rim(space, space.start(side == 1), loop, ways[0], options.path, out.warnings);
        if (!way) {
            return tl::unexpected(way.error());
        }
        ways[side] = std::move(*way);
        loop = space.loop_of(ways[side].back().a);
    }
    assemble(out, model, region, *before, c, *after, ways);
    return {};
}

} // namespace

Result<ExtendedLine> extend_line(const Model& model, const Region& region, const Correspondence& correspondence,
                                 const ExtensionOptions& options)
{
    try {
        if (auto ok = check_input(model, region, correspondence); !ok) {
            return tl::unexpected(ok.error());
        }
        ExtendedLine out;
        const std::vector<int> rest = rest_of_loop(correspondence);
        if (correspondence.line.closed || !rest.empty()) {
            keep_loop(out, model, region, correspondence, rest);
        } else if (auto done = prolong(out, model, region, correspondence, options); !done) {
            return tl::unexpected(done.error());
        }
        follow_cut(out, static_cast<int>(model.mesh.V.rows()));
        std::ranges::set_union(other_feature_edges(out.model, out.vertices, out.closed), out.region.kept_edges,
                               std::back_inserter(out.features));
        if (auto ok = set_targets(out, model, region.faces, correspondence, options); !ok) {
            return tl::unexpected(ok.error());
        }
        return out;
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("the line could not be prolonged to the rim: {}", e.what()));
    }
}

ExtendedLine unextended(const Model& model, const Region& region, const Correspondence& correspondence)
{
    ExtendedLine line;
    line.model = model;
    line.region = region;
    line.vertices = correspondence.line.vertices;
    line.closed = correspondence.line.closed;
    line.last = static_cast<int>(line.vertices.size()) - 1;
    line.targets = correspondence.targets;
    return line;
}

} // namespace tapeline
