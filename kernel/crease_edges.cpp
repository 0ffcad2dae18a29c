// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/crease_edges.h"

#include "kernel/curve.h"
#include "kernel/feature_lines.h"
#include "kernel/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace tapeline {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double degrees = 180 / std::numbers::pi;
constexpr double standing_out_share = 0.4;
constexpr double dip_share = 0.2;
constexpr double thin_share = 0.05;  ///< of the edge's length
constexpr double beside_share = 0.1; ///< of the way from an edge to a triangle's centre
constexpr double reach_share = 0.25; ///< of a triangle's or edge's length
constexpr int max_crossings = 12;
constexpr int max_facets = 4;

Vec3 position(const Mesh& mesh, int v) { return mesh.V.row(v); }

/// True for an ordinary interior edge with one triangle on either side.
bool two_sided(const MeshEdge& edge) { return edge.face_count == 2 && edge.left >= 0 && edge.right >= 0; }

} // namespace

double signed_bend(const Mesh& mesh, const MeshEdge& edge)
{
    const Vec3 n1 = triangle_normal(mesh, edge.left), n2 = triangle_normal(mesh, edge.right);
    const Vec3 cross = n1.cross(n2);
    const double angle = std::atan2(cross.norm(), n1.dot(n2)) * degrees;
    return cross.dot(position(mesh, edge.b) - position(mesh, edge.a)) >= 0 ? angle : -angle;
}

namespace {

int third_vertex(const Mesh& mesh, int t, int a, int b)
{
    for (int k = 0; k < 3; ++k) {
        const int v = mesh.F(t, k);
        if (v != a && v != b) {
            return v;
        }
    }
    return -1;
}

/// Position of the third corner beyond the segment p→q (to its left), from the triangle's shape in space.
Vec2 unfold(const Mesh& mesh, int third, int at_p, int at_q, const Vec2& p, const Vec2& q)
{
    const Vec3 origin = position(mesh, at_p);
    const Vec3 along = position(mesh, at_q) - origin, to = position(mesh, third) - origin;
    const double length = along.norm();
    if (length <= 0) {
        return p;
    }
    const double x = to.dot(along) / length, y = along.cross(to).norm() / length;
    const Vec2 direction = (q - p) / length;
    return p + x * direction + y * Vec2(-direction.y(), direction.x());
}

/// A stretch of nearly equal normals met by the walk: from `start` to `end` away from the edge, turned by `turned`.
struct Facet {
    double start = 0;
    double end = 0;
    double turned = 0;
};

/// Walks from the middle of `edge` into triangle t, square to the edge, and lists the facets met.
std::vector<Facet> facets_beside(const Mesh& mesh, const Topology& topology, const MeshEdge& edge, int t, double bend)
{
    const double half = 0.5 * (position(mesh, edge.b) - position(mesh, edge.a)).norm();
    // The walk goes along +y; the crossed segment runs from the left vertex (x < 0) to the right one (x ≥ 0).
    int left = edge.a, right = edge.b;
    Vec2 at_left(-half, 0), at_right(half, 0);
    std::vector<Facet> facets(1);
    double turned = 0;
    for (int crossing = 0; crossing < max_crossings; ++crossing) {
        const int apex = third_vertex(mesh, t, left, right);
        if (apex < 0) {
            break;
        }
        const Vec2 at_apex = unfold(mesh, apex, left, right, at_left, at_right);
        if (at_apex.x() >= 0) {
            right = apex;
            at_right = at_apex;
        } else {
            left = apex;
            at_left = at_apex;
        }
        const Vec2 segment = at_right - at_left;
        if (!(segment.norm() > 0)) {
            break;
        }
        const double y = at_left.y() - (segment.x() > 0 ? at_left.x() / segment.x() * segment.y() : 0);
        facets.back().end = std::max(facets.back().start, y);
        const int next = topology.find_edge(left, right);
        if (next < 0 || !two_sided(topology.edge(next))) {
            break;
        }
        const double turn = signed_bend(mesh, topology.edge(next)) * segment.x() / segment.norm();
        // Beyond another crease lies another surface; a fold beside a thin sliver is none.
        const bool other_crease =
            std::abs(turn) >= very_sharp_angle && facets.back().end - facets.back().start > 2 * half * thin_share;
        turned += turn;
        if (std::abs(turned - facets.back().turned) > 0.1 * std::abs(bend)) {
            if (other_crease || static_cast<int>(facets.size()) == max_facets) {
                break;
            }
            facets.push_back({facets.back().end, facets.back().end, turned});
        }
        t = topology.face_across(t, next);
    }
    return facets;
}

/// How much of the bend at the edge the facets on one side explain [deg]: half the first facet's width times the
/// fastest turning seen from it.
double explained_bend(const std::vector<Facet>& facets)
{
    const double width = facets.front().end;
    double rate = 0;
    for (size_t k = 1; k < facets.size(); ++k) {
        const double reach = std::min(facets[k].end - facets[k].start, width);
        const double distance = facets[k].start + 0.5 * reach - 0.5 * width;
        if (distance > 0) {
            rate = std::max(rate, std::abs(facets[k].turned) / distance);
        }
    }
    return 0.5 * width * rate;
}

/// What the walks on both sides of an edge met.
struct Beside {
    double bend = 0;
    std::vector<Facet> left, right;

    double standing_out() const { return std::max(0.0, std::abs(bend) - explained_bend(left) - explained_bend(right)); }
};

Beside facets_on_both_sides(const Mesh& mesh, const Topology& topology, const MeshEdge& edge)
{
    const double bend = signed_bend(mesh, edge);
    MeshEdge turned = edge;
    std::swap(turned.a, turned.b);
    return {bend, facets_beside(mesh, topology, edge, edge.left, bend),
            facets_beside(mesh, topology, turned, edge.right, bend)};
}

double longest_side(const Mesh& mesh, int t)
{
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (position(mesh, mesh.F(t, k)) - position(mesh, mesh.F(t, (k + 1) % 3))).norm());
    }
    return longest;
}

/// Angle between the exact CAD faces on both sides of a mesh edge [deg]; empty where they are not known. Between two
/// faces both normals are taken at one point, the exact CAD edge's nearest to the mesh edge's middle: chords of a curved
/// edge lie beside it, where a tightly bent face has another normal already. Inside one face the normals are those a
/// tenth of the way from the edge to the triangles' centres: across a tight bend they differ by a tenth of the angle
/// only, across a kink by all of it.
std::optional<double> exact_crease_angle(const Model& model, const MeshEdge& edge, int cad_edge)
{
    const int face1 = model.cad_face[edge.left], face2 = model.cad_face[edge.right];
    if (!model.surface || face1 < 0 || face2 < 0) {
        return {};
    }
    const Vec3 a = position(model.mesh, edge.a), b = position(model.mesh, edge.b);
    const Vec3 middle = 0.5 * (a + b);
    const auto beside = [&](int t) -> Vec3 {
        const Vec3 centre = (a + b + position(model.mesh, third_vertex(model.mesh, t, edge.a, edge.b))) / 3;
        return middle + beside_share * (centre - middle);
    };
    const Vec3 p1 = face1 == face2 ? beside(edge.left) : middle, p2 = face1 == face2 ? beside(edge.right) : middle;
    Vec3 at1 = p1, at2 = p2;
    if (face1 != face2 && cad_edge >= 0) {
        at1 = at2 = model.surface->closest_on_edge(cad_edge, middle).value_or(middle);
    }
    const auto foot1 = model.surface->closest(face1, at1);
    const auto foot2 = model.surface->closest(face2, at2);
    // A mesh that has left its CAD faces (it was moved) is judged by itself. A triangle's inside is as far from the
    // face as its longest side's chord height, however short the edge.
    const double reach1 = reach_share * (face1 == face2 ? longest_side(model.mesh, edge.left) : (b - a).norm());
    const double reach2 = reach_share * (face1 == face2 ? longest_side(model.mesh, edge.right) : (b - a).norm());
    if (!foot1 || !foot2 || (foot1->point - p1).norm() > reach1 || (foot2->point - p2).norm() > reach2) {
        return {};
    }
    return std::atan2(foot1->normal.cross(foot2->normal).norm(), foot1->normal.dot(foot2->normal)) * degrees;
}

/// The angle by which the edge is judged [deg]: 0 when it is no crease whatever the threshold.
double decisive_angle(const Model& model, const Topology& topology, int e, int cad_edge, double low)
{
    const MeshEdge& edge = topology.edge(e);
    const double angle = crease_angle(model.mesh, topology, e);
    if (angle < low || !two_sided(edge)) {
        return 0;
    }
    if (!model.cad_face.empty()) {
        if (cad_edge < 0 && angle < very_sharp_angle) {
            return 0;
        }
        if (const auto exact = exact_crease_angle(model, edge, cad_edge)) {
            if (model.cad_face[edge.left] != model.cad_face[edge.right]) {
                // Faces folded back onto each other have one tangent plane: a cusp of a smooth seam, no crease.
                return 180 - *exact < low ? 0 : *exact;
            }
            if (*exact < 0.5 * angle) {
                return 0;
            }
        }
        if (cad_edge < 0) {
            return standing_out_angle(model.mesh, topology, e) >= standing_out_share * angle ? angle : 0;
        }
    }
    const double thin = thin_share * (position(model.mesh, edge.a) - position(model.mesh, edge.b)).norm();
    const Beside beside = facets_on_both_sides(model.mesh, topology, edge);
    if (angle >= very_sharp_angle && beside.left.front().end > thin && beside.right.front().end > thin) {
        return angle;
    }
    return beside.standing_out() >= standing_out_share * angle ? angle : 0;
}

/// The mesh edges of one CAD edge in order; a branching or broken one comes out in several parts.
std::vector<std::vector<int>> runs_of(const Topology& topology, const std::vector<int>& edges)
{
    std::map<int, std::vector<int>> at;
    for (const int e : edges) {
        at[topology.edge(e).a].push_back(e);
        at[topology.edge(e).b].push_back(e);
    }
    std::map<int, bool> used;
    std::vector<std::vector<int>> runs;
    const auto follow = [&](int v) {
        std::vector<int> run;
        for (bool more = true; more;) {
            more = false;
            for (const int e : at[v]) {
                if (!used[e]) {
                    used[e] = true;
                    run.push_back(e);
                    v = topology.other_end(e, v);
                    more = at[v].size() == 2;
                    break;
                }
            }
        }
        if (!run.empty()) {
            runs.push_back(std::move(run));
        }
    };
    for (const bool ends_first : {true, false}) {
        for (const auto& [v, list] : at) {
            for (size_t k = 0; k < list.size() && (list.size() != 2) == ends_first; ++k) {
                follow(v);
            }
        }
    }
    return runs;
}

/// Raises short dips of a mostly sharp CAD edge to `weak`.
void fill_dips(const Mesh& mesh, const Topology& topology, const std::vector<int>& run, std::vector<CreaseLevel>& level)
{
    const auto length = [&](int e) {
        return (position(mesh, topology.edge(e).a) - position(mesh, topology.edge(e).b)).norm();
    };
    double total = 0, sharp = 0;
    bool strong = false;
    for (const int e : run) {
        total += length(e);
        sharp += level[e] != CreaseLevel::none ? length(e) : 0;
        strong = strong || level[e] == CreaseLevel::strong;
    }
    if (!strong || sharp < 0.5 * total) {
        return;
    }
    for (size_t i = 0; i < run.size();) {
        double dip = 0;
        size_t j = i;
        for (; j < run.size() && level[run[j]] == CreaseLevel::none; ++j) {
            dip += length(run[j]);
        }
        for (; i < j; ++i) {
            if (dip <= dip_share * total && two_sided(topology.edge(run[i]))) {
                level[run[i]] = CreaseLevel::weak;
            }
        }
        ++i;
    }
}

} // namespace

double standing_out_angle(const Mesh& mesh, const Topology& topology, int e)
{
    const MeshEdge& edge = topology.edge(e);
    return two_sided(edge) ? facets_on_both_sides(mesh, topology, edge).standing_out() : 0;
}

std::vector<int> cad_edge_of_edges(const Model& model, const Topology& topology)
{
    std::vector<int> cad_edge(topology.edge_count(), -1);
    for (const CadEdgeTag& tag : model.cad_edges) {
        const int e = topology.find_edge(tag.a, tag.b);
        if (e >= 0) {
            cad_edge[e] = tag.cad_edge;
        }
    }
    return cad_edge;
}

std::vector<CreaseLevel> crease_edges(const Model& model, const Topology& topology, double high, double low)
{
    const std::vector<int> cad_edge = cad_edge_of_edges(model, topology);
    std::vector<CreaseLevel> level(topology.edge_count(), CreaseLevel::none);
    parallel_for(topology.edge_count(), [&](int e) {
        const double angle = decisive_angle(model, topology, e, cad_edge[e], low);
        level[e] = angle >= high ? CreaseLevel::strong : angle >= low ? CreaseLevel::weak : CreaseLevel::none;
    });
    std::map<int, std::vector<int>> by_cad_edge;
    for (int e = 0; e < topology.edge_count(); ++e) {
        if (cad_edge[e] >= 0) {
            by_cad_edge[cad_edge[e]].push_back(e);
        }
    }
    for (const auto& [id, edges] : by_cad_edge) {
        for (const auto& run : runs_of(topology, edges)) {
            fill_dips(model.mesh, topology, run, level);
        }
    }
    return level;
}

} // namespace tapeline
