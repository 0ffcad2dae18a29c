// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/edge_split.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tapeline {

namespace {

using Triangle = std::array<int, 3>;
using Chain = std::vector<int>;

/// A triangle with the new vertices on its sides; on[k] lies between corners k and k + 1, in that order.
struct Polygon {
    Triangle corner{};
    std::array<Chain, 3> on;
};

double angle_score(const Positions& V, const Triangle& t)
{
    double smallest = 4;
    for (int k = 0; k < 3; ++k) {
        const Vec3 p = V.row(t[k]);
        const Vec3 e1 = Vec3(V.row(t[(k + 1) % 3])) - p, e2 = Vec3(V.row(t[(k + 2) % 3])) - p;
        smallest = std::min(smallest, std::atan2(e1.cross(e2).norm(), e1.dot(e2)));
    }
    return smallest;
}

/// One new vertex on side k and one on side k + 1: the corner between them is cut off, the quad that remains is
/// divided by the diagonal with the larger smallest angle.
void split_at_corner(const Positions& V, const Polygon& polygon, int k, std::vector<Triangle>& out)
{
    const int a = polygon.corner[k], b = polygon.corner[(k + 1) % 3], c = polygon.corner[(k + 2) % 3];
    const int p = polygon.on[k][0], q = polygon.on[(k + 1) % 3][0];
    const std::array<Triangle, 2> from_a{{{a, p, q}, {a, q, c}}}, from_p{{{a, p, c}, {p, q, c}}};
    const auto score = [&](const auto& pair) { return std::min(angle_score(V, pair[0]), angle_score(V, pair[1])); };
    const auto& better = score(from_a) >= score(from_p) ? from_a : from_p;
    out.push_back({p, b, q});
    out.insert(out.end(), better.begin(), better.end());
}

void triangulate(const Positions& V, const Polygon& polygon, std::vector<Triangle>& out)
{
    int sides = 0, points = 0, longest = -1;
    double length = -1;
    for (int k = 0; k < 3; ++k) {
        points += static_cast<int>(polygon.on[k].size());
        sides += polygon.on[k].empty() ? 0 : 1;
        const double l = (V.row(polygon.corner[k]) - V.row(polygon.corner[(k + 1) % 3])).norm();
        if (!polygon.on[k].empty() && l > length) {
            length = l;
            longest = k;
        }
    }
    if (longest < 0) {
        out.push_back(polygon.corner);
        return;
    }
    if (points == 2 && sides == 2) {
        for (int k = 0; k < 3; ++k) {
            if (!polygon.on[k].empty() && !polygon.on[(k + 1) % 3].empty()) {
                split_at_corner(V, polygon, k, out);
                return;
            }
        }
    }
    // Bisect from the middle new vertex of the longest side that has any.
    const int k = longest;
    const int a = polygon.corner[k], b = polygon.corner[(k + 1) % 3], c = polygon.corner[(k + 2) % 3];
    const Chain& side = polygon.on[k];
    const auto middle = side.begin() + static_cast<std::ptrdiff_t>(side.size() / 2);
    triangulate(V, {{a, *middle, c}, {Chain(side.begin(), middle), Chain(), polygon.on[(k + 2) % 3]}}, out);
    triangulate(V, {{*middle, b, c}, {Chain(middle + 1, side.end()), polygon.on[(k + 1) % 3], Chain()}}, out);
}

/// New vertices per split edge (a < b), in the order from a to b.
using EdgeChains = std::map<std::array<int, 2>, Chain>;

EdgeChains chains_of(const std::vector<EdgePoint>& points, int first_vertex)
{
    std::map<std::array<int, 2>, std::vector<std::pair<double, int>>> sorted;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        const EdgePoint& p = points[i];
        const bool forward = p.a < p.b;
        sorted[{std::min(p.a, p.b), std::max(p.a, p.b)}].emplace_back(forward ? p.t : 1 - p.t, first_vertex + i);
    }
    EdgeChains chains;
    for (auto& [edge, list] : sorted) {
        std::sort(list.begin(), list.end());
        for (const auto& entry : list) {
            chains[edge].push_back(entry.second);
        }
    }
    return chains;
}

std::vector<CadEdgeTag> split_tags(const std::vector<CadEdgeTag>& tags, const EdgeChains& chains)
{
    std::vector<CadEdgeTag> out;
    for (const CadEdgeTag& tag : tags) {
        const auto it = chains.find({tag.a, tag.b});
        int previous = tag.a;
        if (it != chains.end()) {
            for (const int v : it->second) {
                out.push_back({std::min(previous, v), std::max(previous, v), tag.cad_edge});
                previous = v;
            }
        }
        out.push_back({std::min(previous, tag.b), std::max(previous, tag.b), tag.cad_edge});
    }
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

EdgeSplit split_edges(const Model& model, const std::vector<EdgePoint>& points)
{
    const int vertices = static_cast<int>(model.mesh.V.rows()), faces = static_cast<int>(model.mesh.F.rows());
    EdgeSplit split;
    split.model.surface = model.surface;
    Positions& V = split.model.mesh.V;
    V.resize(vertices + static_cast<int>(points.size()), 3);
    V.topRows(vertices) = model.mesh.V;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        const EdgePoint& p = points[i];
        V.row(vertices + i) = (1 - p.t) * model.mesh.V.row(p.a) + p.t * model.mesh.V.row(p.b);
    }
    const EdgeChains chains = chains_of(points, vertices);

    std::vector<Triangle> all(faces);
    split.parent.resize(faces);
    for (int t = 0; t < faces; ++t) {
        Polygon polygon;
        for (int k = 0; k < 3; ++k) {
            polygon.corner[k] = model.mesh.F(t, k);
        }
        for (int k = 0; k < 3 && !chains.empty(); ++k) {
            const int a = polygon.corner[k], b = polygon.corner[(k + 1) % 3];
            const auto it = chains.find({std::min(a, b), std::max(a, b)});
            if (it != chains.end()) {
                polygon.on[k] = it->second;
                if (a > b) {
                    std::reverse(polygon.on[k].begin(), polygon.on[k].end());
                }
            }
        }
        std::vector<Triangle> parts;
        triangulate(V, polygon, parts);
        all[t] = parts.front();
        split.parent[t] = t;
        all.insert(all.end(), parts.begin() + 1, parts.end());
        split.parent.resize(all.size(), t);
    }
    split.model.mesh.F.resize(static_cast<int>(all.size()), 3);
    for (int t = 0; t < static_cast<int>(all.size()); ++t) {
        split.model.mesh.F.row(t) << all[t][0], all[t][1], all[t][2];
    }
    if (!model.cad_face.empty()) {
        for (const int t : split.parent) {
            split.model.cad_face.push_back(model.cad_face[t]);
        }
    }
    split.model.cad_edges = split_tags(model.cad_edges, chains);
    return split;
}

} // namespace tapeline
