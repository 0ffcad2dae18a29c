// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/remesh_features.h"

#include "kernel/crease_edges.h"
#include "kernel/curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double standing_out_share = 0.4; ///< as for feature lines

struct Features {
    const Model& model;
    const Topology& topology;
    const std::vector<char>& in_region;
    double angle;           ///< [deg]
    std::vector<char> kept; ///< per edge

    bool inside(const MeshEdge& e) const
    {
        return e.left >= 0 && e.right >= 0 && in_region[e.left] && in_region[e.right];
    }
    double crease(const MeshEdge& e) const
    {
        const Vec3 l = triangle_normal(model.mesh, e.left), r = triangle_normal(model.mesh, e.right);
        return std::atan2(l.cross(r).norm(), l.dot(r)) / degree;
    }
    /// How sharp the edge is as a feature [deg]: of a mesh without CAD faces what stands out, since the facets of a
    /// tessellated cylinder are none.
    double sharpness(int e) const
    {
        return model.cad_face.empty() && crease(topology.edge(e)) < very_sharp_angle
                   ? standing_out_angle(model.mesh, topology, e)
                   : crease(topology.edge(e));
    }
    int cad_face(int t) const { return model.cad_face.empty() ? -1 : model.cad_face[t]; }
};

/// CAD edge per mesh edge; -1 = none.
std::vector<int> tags_of(const Model& model, const Topology& topology)
{
    std::vector<int> tags(topology.edge_count(), -1);
    for (const CadEdgeTag& tag : model.cad_edges) {
        if (const int e = topology.find_edge(tag.a, tag.b); e >= 0) {
            tags[e] = tag.cad_edge;
        }
    }
    return tags;
}

/// For an edge inside a CAD face: do the exact normals close beside it differ by half the angle that the triangles
/// show? True where there is no exact surface to ask.
bool truly_sharp(const Features& f, const MeshEdge& e)
{
    const int face = f.cad_face(e.left);
    if (!f.model.surface || face < 0 || face != f.cad_face(e.right)) {
        return true;
    }
    const Positions& V = f.model.mesh.V;
    const Vec3 middle = 0.5 * (V.row(e.a) + V.row(e.b));
    std::array<Vec3, 2> normals;
    for (int side = 0; side < 2; ++side) {
        const int t = side == 0 ? e.left : e.right;
        Vec3 centre = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            centre += Vec3(V.row(f.model.mesh.F(t, k))) / 3;
        }
        const auto foot = f.model.surface->closest(face, middle + 0.02 * (centre - middle));
        if (!foot) {
            return true;
        }
        normals[side] = foot->normal;
    }
    const double angle = std::atan2(normals[0].cross(normals[1]).norm(), normals[0].dot(normals[1])) / degree;
    return angle >= 0.5 * f.angle;
}

void keep_border(Features& f)
{
    for (int e = 0; e < f.topology.edge_count(); ++e) {
        const MeshEdge& edge = f.topology.edge(e);
        const int sides =
            (edge.left >= 0 && f.in_region[edge.left] ? 1 : 0) + (edge.right >= 0 && f.in_region[edge.right] ? 1 : 0);
        f.kept[e] = sides == 1;
    }
}

void keep_lines(Features& f, const std::vector<std::vector<int>>& lines)
{
    for (const std::vector<int>& line : lines) {
        for (size_t i = 1; i < line.size(); ++i) {
            const int e = f.topology.find_edge(line[i - 1], line[i]);
            if (e >= 0 && f.inside(f.topology.edge(e))) {
                f.kept[e] = 1;
            }
        }
    }
}

void keep_sharp(Features& f, const std::vector<int>& tags)
{
    std::vector<int> sharp_cad_edges;
    for (int e = 0; e < f.topology.edge_count(); ++e) {
        const MeshEdge& edge = f.topology.edge(e);
        if (!f.inside(edge) || f.crease(edge) < f.angle || f.sharpness(e) < standing_out_share * f.angle) {
            continue;
        }
        if (tags[e] >= 0) {
            sharp_cad_edges.push_back(tags[e]);
        } else if (truly_sharp(f, edge)) {
            f.kept[e] = 1;
        }
    }
    std::sort(sharp_cad_edges.begin(), sharp_cad_edges.end());
    for (int e = 0; e < f.topology.edge_count(); ++e) {
        if (tags[e] >= 0 && f.inside(f.topology.edge(e)) &&
            std::binary_search(sharp_cad_edges.begin(), sharp_cad_edges.end(), tags[e])) {
            f.kept[e] = 1;
        }
    }
}

/// The edge at v that goes on straightest from kept edge `from` and is at least half as sharp as asked; -1 = none.
int continuation(const Features& f, int v, int from)
{
    constexpr double max_turn = 45 * degree;
    const Positions& V = f.model.mesh.V;
    const Vec3 arrive = (V.row(v) - V.row(f.topology.other_end(from, v))).normalized();
    int best = -1;
    double straightest = std::cos(max_turn);
    for (const int e : f.topology.vertex_edges(v)) {
        const MeshEdge& edge = f.topology.edge(e);
        if (e == from || !f.inside(edge)) {
            continue;
        }
        const double straight = arrive.dot((V.row(f.topology.other_end(e, v)) - V.row(v)).normalized());
        if (straight > straightest && f.sharpness(e) >= 0.5 * f.angle && truly_sharp(f, edge)) {
            straightest = straight;
            best = e;
        }
    }
    return best;
}

/// Follows chains from their open ends.
void grow_ends(Features& f)
{
    std::vector<int> count(f.topology.vertex_count(), 0);
    std::vector<int> ends;
    for (int e = 0; e < f.topology.edge_count(); ++e) {
        if (f.kept[e]) {
            ++count[f.topology.edge(e).a];
            ++count[f.topology.edge(e).b];
        }
    }
    for (int v = 0; v < f.topology.vertex_count(); ++v) {
        if (count[v] == 1) {
            ends.push_back(v);
        }
    }
    for (int v : ends) {
        while (count[v] == 1) {
            const auto around = f.topology.vertex_edges(v);
            const int from = *std::find_if(around.begin(), around.end(), [&](int e) { return f.kept[e] != 0; });
            const int next = continuation(f, v, from);
            if (next < 0) {
                break;
            }
            f.kept[next] = 1;
            ++count[v];
            v = f.topology.other_end(next, v);
            ++count[v];
        }
    }
}

} // namespace

std::vector<VertexPair> kept_edges(const Model& model, const Topology& topology, const std::vector<char>& in_region,
                                   const RemeshOptions& options)
{
    Features f{model, topology, in_region, options.crease_angle, std::vector<char>(topology.edge_count(), 0)};
    keep_border(f);
    keep_lines(f, options.keep_lines);
    keep_sharp(f, tags_of(model, topology));
    grow_ends(f);
    std::vector<VertexPair> edges;
    for (int e = 0; e < topology.edge_count(); ++e) {
        if (f.kept[e]) {
            edges.push_back({topology.edge(e).a, topology.edge(e).b});
        }
    }
    return edges;
}

std::vector<int> kept_tips(const Mesh& mesh, const Topology& topology, const std::vector<char>& in_region,
                           const std::vector<VertexPair>& kept)
{
    constexpr double tip = 45 * degree, flat_share = 0.25;
    std::vector<double> defect(mesh.V.rows(), 0);
    std::vector<char> inner(mesh.V.rows(), 0);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3 && in_region[t]; ++k) {
            const Vec3 p = mesh.V.row(mesh.F(t, k));
            const Vec3 e1 = Vec3(mesh.V.row(mesh.F(t, (k + 1) % 3))) - p;
            const Vec3 e2 = Vec3(mesh.V.row(mesh.F(t, (k + 2) % 3))) - p;
            defect[mesh.F(t, k)] -= std::atan2(e1.cross(e2).norm(), e1.dot(e2));
            inner[mesh.F(t, k)] = 1;
        }
    }
    for (const VertexPair& e : kept) {
        inner[e[0]] = inner[e[1]] = 0;
    }
    std::vector<int> tips;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const auto around = topology.vertex_edges(v);
        const double own = std::abs(defect[v] + 2 * std::numbers::pi);
        if (inner[v] && own >= tip && std::all_of(around.begin(), around.end(), [&](int e) {
                const int other = topology.other_end(e, v);
                return !inner[other] || std::abs(defect[other] + 2 * std::numbers::pi) < flat_share * own;
            })) {
            tips.push_back(v);
        }
    }
    return tips;
}

} // namespace tapeline
