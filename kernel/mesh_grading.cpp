// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh_grading.h"

#include "kernel/edge_split.h"
#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <set>

namespace tapeline {

namespace {

constexpr double degree = std::numbers::pi / 180;

bool is_kept(const std::vector<VertexPair>& kept, const MeshEdge& e)
{
    return e.left < 0 || e.right < 0 || std::binary_search(kept.begin(), kept.end(), VertexPair{e.a, e.b});
}

double length(const Mesh& mesh, const MeshEdge& e) { return (mesh.V.row(e.a) - mesh.V.row(e.b)).norm(); }

/// Wanted edge length per vertex: `wanted`, less near kept edges that are shorter.
std::vector<double> graded_lengths(const Mesh& mesh, const Topology& topology, const std::vector<VertexPair>& kept,
                                   double wanted)
{
    constexpr double growth = 0.4, shortest = 0.005;
    std::vector<double> sum(mesh.V.rows(), 0), size(mesh.V.rows(), wanted);
    std::vector<int> count(mesh.V.rows(), 0);
    for (const MeshEdge& e : topology.edges()) {
        if (is_kept(kept, e)) {
            for (const int v : {e.a, e.b}) {
                sum[v] += length(mesh, e);
                ++count[v];
            }
        }
    }
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (count[v] > 0 && sum[v] < wanted * count[v]) {
            size[v] = std::max(sum[v] / count[v], shortest * wanted);
            queue.emplace(size[v], v);
        }
    }
    while (!queue.empty()) {
        const auto [own, v] = queue.top();
        queue.pop();
        if (own > size[v]) {
            continue;
        }
        for (const int e : topology.vertex_edges(v)) {
            const int next = topology.other_end(e, v);
            const double larger = own + growth * length(mesh, topology.edge(e));
            if (larger < size[next]) {
                size[next] = larger;
                queue.emplace(larger, next);
            }
        }
    }
    return size;
}

/// Splits edges too long for the graded length, worst first, no two at one triangle. Returns how many.
int split_long(GradedMesh& g, const std::vector<VertexPair>& kept, double wanted)
{
    constexpr double too_long = 4.0 / 3;
    const Topology topology(g.mesh.F, static_cast<int>(g.mesh.V.rows()));
    const std::vector<double> size = graded_lengths(g.mesh, topology, kept, wanted);
    std::vector<std::pair<double, int>> order;
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        const double fit = 0.5 * (size[edge.a] + size[edge.b]), ratio = length(g.mesh, edge) / fit;
        if (ratio > too_long && fit < wanted && !is_kept(kept, edge)) {
            order.emplace_back(-ratio, e);
        }
    }
    std::sort(order.begin(), order.end());
    std::vector<char> touched(g.mesh.F.rows(), 0);
    std::vector<EdgePoint> points;
    for (const auto& entry : order) {
        const MeshEdge& edge = topology.edge(entry.second);
        if (!touched[edge.left] && !touched[edge.right]) {
            touched[edge.left] = touched[edge.right] = 1;
            points.push_back({edge.a, edge.b, 0.5});
        }
    }
    if (!points.empty()) {
        Model model;
        model.mesh = std::move(g.mesh);
        EdgeSplit split = split_edges(model, points);
        g.mesh = std::move(split.model.mesh);
        g.movable.resize(g.mesh.V.rows(), 1);
        std::vector<int> part;
        for (const int t : split.parent) {
            part.push_back(g.part[t]);
        }
        g.part = std::move(part);
    }
    return static_cast<int>(points.size());
}

/// Smallest angle [rad]; negative where the triangle faces away from `normal`.
double signed_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal)
{
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const Vec3 area = ab.cross(-ca);
    const double twice = area.norm();
    const double smallest =
        std::min({std::atan2(twice, -ab.dot(ca)), std::atan2(twice, -bc.dot(ab)), std::atan2(twice, -ca.dot(bc))});
    return area.dot(normal) < 0 ? smallest - std::numbers::pi : smallest;
}

/// Flips inner edges where the smallest angle of the two triangles grows. Returns how many.
int flip_edges(GradedMesh& g, const std::vector<VertexPair>& kept, const PartSurface& surface)
{
    const Topology topology(g.mesh.F, static_cast<int>(g.mesh.V.rows()));
    std::vector<char> touched(g.mesh.F.rows(), 0);
    std::set<VertexPair> made;
    const auto across = [&](int t, const MeshEdge& e) {
        for (int k = 0; k < 3; ++k) {
            if (g.mesh.F(t, k) != e.a && g.mesh.F(t, k) != e.b) {
                return g.mesh.F(t, k);
            }
        }
        return -1;
    };
    for (const MeshEdge& e : topology.edges()) {
        if (is_kept(kept, e) || touched[e.left] || touched[e.right]) {
            continue;
        }
        const int vc = across(e.left, e), vd = across(e.right, e);
        const Vec3 a = g.mesh.V.row(e.a), b = g.mesh.V.row(e.b), c = g.mesh.V.row(vc), d = g.mesh.V.row(vd);
        const Vec3 own = (b - a).cross(c - a), beside = (d - a).cross(b - a);
        const Vec3 guess = own + beside;
        // Most edges are fine; only the others are worth a query.
        const bool folded = own.dot(beside) < 0;
        if (!folded && std::min(signed_angle(a, d, c, guess), signed_angle(d, b, c, guess)) <=
                           std::min(signed_angle(a, b, c, guess), signed_angle(b, a, d, guess)) + 1e-3) {
            continue;
        }
        const Vec3 normal = surface.normal(surface.closest(g.part[e.left], 0.5 * (a + b)));
        const double before = std::min(signed_angle(a, b, c, normal), signed_angle(b, a, d, normal));
        const double after = std::min(signed_angle(a, d, c, normal), signed_angle(d, b, c, normal));
        const bool joined = vc == vd || topology.find_edge(vc, vd) >= 0 || made.contains(vertex_pair(vc, vd));
        if (after <= before + 1e-3 || joined) {
            continue;
        }
        made.insert(vertex_pair(vc, vd));
        touched[e.left] = touched[e.right] = 1;
        g.mesh.F.row(e.left) << e.a, vd, vc;
        g.mesh.F.row(e.right) << vd, e.b, vc;
    }
    return static_cast<int>(made.size());
}

/// Smallest signed angle around v if it stood at p.
double star_angle(const Mesh& mesh, const Topology& topology, int v, const Vec3& p, const Vec3& normal)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const int t : topology.vertex_faces(v)) {
        int k = 0;
        while (mesh.F(t, k) != v) {
            ++k;
        }
        smallest = std::min(
            smallest, signed_angle(p, mesh.V.row(mesh.F(t, (k + 1) % 3)), mesh.V.row(mesh.F(t, (k + 2) % 3)), normal));
    }
    return smallest;
}

/// Moves movable vertices with a bad star towards the middle of their neighbours where that makes the star better.
/// Returns how many.
int relax(GradedMesh& g, const PartSurface& surface)
{
    constexpr double good_enough = 30 * degree;
    const Topology topology(g.mesh.F, static_cast<int>(g.mesh.V.rows()));
    int moved = 0;
    for (int v = 0; v < g.mesh.V.rows(); ++v) {
        const auto faces = topology.vertex_faces(v);
        if (!g.movable[v] || faces.empty()) {
            continue;
        }
        const Vec3 p = g.mesh.V.row(v);
        Vec3 guess = Vec3::Zero(), middle = Vec3::Zero();
        for (const int t : faces) {
            guess += triangle_area(g.mesh, t) * triangle_normal(g.mesh, t);
        }
        if (star_angle(g.mesh, topology, v, p, guess) > good_enough) {
            continue;
        }
        const auto edges = topology.vertex_edges(v);
        for (const int e : edges) {
            middle += Vec3(g.mesh.V.row(topology.other_end(e, v))) / static_cast<double>(edges.size());
        }
        const int part = g.part[faces[0]];
        const double before = star_angle(g.mesh, topology, v, p, surface.normal(surface.closest(part, p)));
        for (const double share : {1.0, 0.5, 0.25}) {
            const MeshFoot foot = surface.closest(part, p + share * (middle - p));
            if (star_angle(g.mesh, topology, v, foot.point, surface.normal(foot)) > before + 1e-3) {
                g.mesh.V.row(v) = foot.point;
                ++moved;
                break;
            }
        }
    }
    return moved;
}

/// Flips and relaxes in turn until nothing changes, at most `rounds` times.
void improve(GradedMesh& g, const std::vector<VertexPair>& kept, const PartSurface& surface, int rounds)
{
    for (int round = 0; round < rounds; ++round) {
        const int flipped = flip_edges(g, kept, surface);
        if (flipped + relax(g, surface) == 0) {
            return;
        }
    }
}

} // namespace

PartSurface::PartSurface(const Mesh& mesh, const std::vector<int>& part)
{
    std::vector<std::vector<int>> faces(part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1);
    for (int t = 0; t < static_cast<int>(part.size()); ++t) {
        faces[part[t]].push_back(t);
        normals_.push_back(triangle_normal(mesh, t));
    }
    for (const std::vector<int>& own : faces) {
        trees_.emplace_back(mesh, own);
    }
}

void grade_triangles(GradedMesh& graded, const std::vector<VertexPair>& kept, double wanted, const PartSurface& surface)
{
    constexpr int grading_rounds = 16, rounds_between = 2, rounds_at_end = 8;
    improve(graded, kept, surface, rounds_between);
    for (int round = 0; round < grading_rounds && split_long(graded, kept, wanted) > 0; ++round) {
        improve(graded, kept, surface, rounds_between);
    }
    improve(graded, kept, surface, rounds_at_end);
}

} // namespace tapeline
