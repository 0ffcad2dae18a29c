// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/rim_cut.h"

#include "kernel/closest_point.h"
#include "kernel/edge_split.h"
#include "kernel/feature_rails.h"
#include "kernel/geodesic_distance.h"
#include "kernel/region_shape.h"

#include <algorithm>
#include <iterator>

namespace tapeline {

namespace {

/// Cuts come no nearer to an edge's ends than this share of its length: smaller pieces would be slivers.
constexpr double least_piece = 0.1;

std::vector<VertexPair> lines_of(const Model& model, const FeatureLine& line)
{
    std::vector<int> whole(line.before.rbegin(), line.before.rend());
    whole.insert(whole.end(), line.vertices.begin(), line.vertices.end());
    whole.insert(whole.end(), line.after.begin(), line.after.end());
    std::vector<VertexPair> edges = other_feature_edges(model, whole, line.closed);
    for (size_t i = 0; i + (line.closed ? 0 : 1) < whole.size(); ++i) {
        const auto [a, b] = std::minmax(whole[i], whole[(i + 1) % whole.size()]);
        edges.push_back({a, b});
    }
    std::ranges::sort(edges);
    return edges;
}

/// The distance field of a band, and the cut along its width.
class Cutter {
public:
    Cutter(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets, const Region& region)
        : model_(model), region_(region), topology_(model.mesh.F, static_cast<int>(model.mesh.V.rows())),
          lines_(lines_of(model, line)), width_(region.distance_mm)
    {
        const ClosestPoint surface(model.mesh);
        std::vector<MeshFoot> feet;
        std::ranges::transform(targets, std::back_inserter(feet), [&](const Vec3& p) { return surface.closest(p); });
        distance_ = band_distance(model.mesh, topology_, line, feet);
        touched_.assign(model.mesh.F.rows(), 0);
        for (int t = 0; t < model.mesh.F.rows(); ++t) {
            const auto d = [&](int k) { return distance_[model.mesh.F(t, k)]; };
            touched_[t] = std::min({d(0), d(1), d(2)}) <= width_ && std::max({d(0), d(1), d(2)}) > width_;
        }
        near_.assign(model.mesh.V.rows(), 0);
        for (const int v : region.vertices) {
            near_[v] = 1;
            for (const int e : topology_.vertex_edges(v)) {
                near_[topology_.other_end(e, v)] = 1;
            }
        }
    }

    std::vector<EdgePoint> points()
    {
        for (const auto& [in, out] : crossings()) {
            if (share(in, out) > 1 - least_piece) {
                distance_[out] = width_;
            }
        }
        std::vector<EdgePoint> points;
        for (const auto& [in, out] : crossings()) {
            if (share(in, out) >= least_piece) {
                points.push_back({in, out, std::min(share(in, out), 1 - least_piece)});
            }
        }
        return points;
    }

    /// The triangles of the split model that lie within the width, from the region outwards as far as the cut goes.
    std::vector<int> faces(const EdgeSplit& split)
    {
        const Mesh& mesh = split.model.mesh;
        distance_.resize(mesh.V.rows(), width_);
        std::vector<char> own(model_.mesh.F.rows(), 0), inside(mesh.F.rows(), 0), may(mesh.F.rows(), 0);
        for (const int t : region_.faces) {
            own[t] = 1;
        }
        std::vector<int> front;
        for (int t = 0; t < mesh.F.rows(); ++t) {
            const auto within = [&](int k) { return distance_[mesh.F(t, k)] <= width_; };
            const bool all = within(0) && within(1) && within(2);
            inside[t] = all && own[split.parent[t]];
            may[t] = all && touched_[split.parent[t]];
            if (inside[t]) {
                front.push_back(t);
            }
        }
        const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
        while (!front.empty()) {
            const int t = front.back();
            front.pop_back();
            for (const int e : topology.face_edges(t)) {
                const MeshEdge& edge = topology.edge(e);
                const int next = edge.face_count == 2 ? topology.face_across(t, e) : -1;
                if (next >= 0 && may[next] && !inside[next] && !on_line(edge.a, edge.b)) {
                    inside[next] = 1;
                    front.push_back(next);
                }
            }
        }
        std::vector<int> faces;
        for (int t = 0; t < mesh.F.rows(); ++t) {
            if (inside[t]) {
                faces.push_back(t);
            }
        }
        return faces;
    }

private:
    bool on_line(int a, int b) const
    {
        return std::ranges::binary_search(lines_, VertexPair{std::min(a, b), std::max(a, b)});
    }
    /// How far the line of equal distance is along the edge from `in` to `out`.
    double share(int in, int out) const { return (width_ - distance_[in]) / (distance_[out] - distance_[in]); }

    /// Edges of which one end, named first, lies within the width and one beyond.
    std::vector<VertexPair> crossings() const
    {
        std::vector<VertexPair> list;
        for (const MeshEdge& edge : topology_.edges()) {
            const bool first = distance_[edge.a] <= width_, second = distance_[edge.b] <= width_;
            const bool seen = (edge.left >= 0 && touched_[edge.left]) || (edge.right >= 0 && touched_[edge.right]);
            if (first != second && seen && near_[first ? edge.a : edge.b] && !on_line(edge.a, edge.b)) {
                list.push_back(first ? VertexPair{edge.a, edge.b} : VertexPair{edge.b, edge.a});
            }
        }
        return list;
    }

    const Model& model_;
    const Region& region_;
    Topology topology_;
    std::vector<VertexPair> lines_;
    double width_;
    std::vector<double> distance_;
    std::vector<char> touched_; ///< triangles that the line of equal distance runs through
    std::vector<char> near_;    ///< vertices of the region and their neighbours
};

} // namespace

RimCut cut_rim(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets, const Region& region,
               const RegionOptions& options)
{
    if (region.distance_mm <= 0) {
        return {model, region, {}};
    }
    Cutter cutter(model, line, targets, region);
    const std::vector<EdgePoint> points = cutter.points();
    EdgeSplit split = split_edges(model, points);
    FaceSet inside(split.model.mesh.F.rows(), 0);
    for (const int t : cutter.faces(split)) {
        inside[t] = 1;
    }
    const Topology topology(split.model.mesh.F, static_cast<int>(split.model.mesh.V.rows()));
    inside = tidy(split.model.mesh, topology, std::move(inside), faces_along(topology, line));
    std::vector<int> faces;
    for (int t = 0; t < static_cast<int>(inside.size()); ++t) {
        if (inside[t]) {
            faces.push_back(t);
        }
    }
    RimCut cut{std::move(split.model), {}, {}};
    std::ranges::transform(points, std::back_inserter(cut.appended), [](const EdgePoint& p) {
        return AppendedVertex{p.a, p.b, p.t};
    });
    cut.region = region_of_faces(cut.model, std::move(faces), options.free_borders, options.fixed_vertices);
    cut.region.distance_mm = region.distance_mm;
    cut.region.warnings = region.warnings;
    return cut;
}

} // namespace tapeline
