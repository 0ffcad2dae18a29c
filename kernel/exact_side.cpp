// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/exact_side.h"

#include "kernel/cad_edge.h"
#include "kernel/curve.h"
#include "kernel/parallel.h"
#include "kernel/remesh_surface.h"
#include "kernel/segment.h"

#include <algorithm>
#include <limits>

namespace tapeline {

ExactSide::ExactSide(const Model& model, const SideMesh& side, bool on_rails)
    : model_(model), side_(side), ground_(model, side.own_faces()), on_edge_(side.to_global.size(), 0),
      still_(side.to_global.size(), 0)
{
    for (const std::vector<int>* list : {&side.fixed, &side.line}) {
        for (const int v : *list) {
            still_[v] = 1;
        }
    }
    std::vector<VertexPair> lines = on_rails ? side.features : std::vector<VertexPair>{};
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    for (int t = 0; t < side.inner_faces; ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = side.mesh.F(t, k), b = side.mesh.F(t, (k + 1) % 3);
            const int e = topology.find_edge(side.to_global[a], side.to_global[b]);
            if (topology.edge(e).face_count == 1) {
                lines.push_back(vertex_pair(a, b));
            }
        }
    }
    std::ranges::sort(lines);
    for (const VertexPair& line : lines) {
        if (const int e = cad_edge_at(model, vertex_pair(side.to_global[line[0]], side.to_global[line[1]])); e >= 0) {
            edges_.emplace_back(line, e);
            on_edge_[line[0]] = on_edge_[line[1]] = 1;
        }
    }
}

std::optional<Vec3> ExactSide::place(int v, const Vec3& p) const
{
    if (!on_edge_[v]) {
        return ground_.closest(p);
    }
    double least = std::numeric_limits<double>::infinity();
    int edge = -1;
    for (const auto& [ends, cad_edge] : edges_) {
        const double d = distance_to_segment(p, side_.mesh.V.row(ends[0]), side_.mesh.V.row(ends[1]));
        if (d < least) {
            least = d;
            edge = cad_edge;
        }
    }
    const auto on_edge = model_.surface->closest_on_edge(edge, p);
    return on_edge && on_edge->allFinite() ? on_edge : ground_.closest(p);
}

std::vector<std::optional<Vec3>> ExactSide::places(const std::vector<int>& vertices, const Positions& V) const
{
    std::vector<std::optional<Vec3>> places(vertices.size());
    parallel_for(
        static_cast<int>(vertices.size()), [&](int i) { places[i] = place(vertices[i], V.row(vertices[i])); }, 64);
    return places;
}

ExactPlacement ExactSide::lay(const std::vector<int>& vertices, double share, Positions& V) const
{
    ExactPlacement result;
    const auto goals = places(vertices, V);
    const Positions before = V;
    std::vector<char> moved(V.rows(), 0);
    for (size_t i = 0; i < vertices.size(); ++i) {
        if (goals[i]) {
            const Vec3 from = before.row(vertices[i]);
            result.before_mm = std::max(result.before_mm, (*goals[i] - from).norm());
            // All of the way is the place itself, to the bit.
            V.row(vertices[i]) = share == 1 ? *goals[i] : Vec3(from + share * (*goals[i] - from));
            moved[vertices[i]] = 1;
        }
    }
    take_back_folds(side_.mesh.F.topRows(side_.inner_faces), before, V, moved);
    for (const int v : vertices) {
        ++(moved[v] ? result.placed : result.left);
    }
    return result;
}

double ExactSide::distance(const std::vector<int>& vertices, const Positions& V) const
{
    double largest = 0;
    const auto feet = places(vertices, V);
    for (size_t i = 0; i < vertices.size(); ++i) {
        const Vec3 p = V.row(vertices[i]);
        largest = std::max(largest, feet[i] ? (*feet[i] - p).norm() : std::numeric_limits<double>::infinity());
    }
    return largest;
}

std::vector<int> ExactSide::moved_vertices(const Positions& V) const
{
    std::vector<int> moved;
    for (int v = 0; v < static_cast<int>(still_.size()); ++v) {
        if (!still_[v] && V.row(v) != side_.mesh.V.row(v)) {
            moved.push_back(v);
        }
    }
    return moved;
}

} // namespace tapeline
