// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cad_edge.h"
#include "kernel/edge_split.h"
#include "kernel/remesh_features.h"
#include "kernel/remesh_stages.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tapeline {

namespace {

/// CAD face on which both triangles at an edge lie; -1 when there is none or they differ.
int face_beside(const Model& model, const Topology& topology, const VertexPair& pair)
{
    if (model.cad_face.empty()) {
        return -1;
    }
    const MeshEdge& e = topology.edge(topology.find_edge(pair[0], pair[1]));
    const int left = e.left >= 0 ? model.cad_face[e.left] : model.cad_face[e.right];
    const int right = e.right >= 0 ? model.cad_face[e.right] : left;
    return left == right ? left : -1;
}

} // namespace

Divided divide(const Model& model, const Topology& topology, const std::vector<int>& faces,
               const RemeshOptions& options)
{
    std::vector<char> in_region(model.mesh.F.rows(), 0);
    for (const int t : faces) {
        in_region[t] = 1;
    }
    const std::vector<VertexPair> kept = kept_edges(model, topology, in_region, options);
    Divided out;
    out.old_vertices = static_cast<int>(model.mesh.V.rows());
    out.old_faces = static_cast<int>(model.mesh.F.rows());
    out.tips = kept_tips(model.mesh, topology, in_region, kept);
    std::vector<EdgePoint> points;
    std::map<VertexPair, std::vector<int>> between;
    const int vertices = static_cast<int>(model.mesh.V.rows());
    for (const VertexPair& e : kept) {
        const double length = (model.mesh.V.row(e[0]) - model.mesh.V.row(e[1])).norm();
        const int parts = static_cast<int>(std::ceil(length / options.max_edge_mm - 1e-9));
        int previous = e[0];
        for (int i = 1; i < parts; ++i) {
            const int v = vertices + static_cast<int>(points.size());
            points.push_back({e[0], e[1], static_cast<double>(i) / parts});
            between[e].push_back(v);
            const int cad_edge = cad_edge_at(model, e);
            out.sites.push_back({v, cad_edge, cad_edge < 0 ? face_beside(model, topology, e) : -1,
                                 std::max(0.5 * options.max_edge_mm, 0.25 * length)});
            out.kept.push_back(vertex_pair(previous, v));
            previous = v;
        }
        out.kept.push_back(vertex_pair(previous, e[1]));
    }
    std::sort(out.kept.begin(), out.kept.end());
    for (const std::vector<int>& line : options.keep_lines) {
        std::vector<int> divided;
        for (size_t i = 0; i < line.size(); ++i) {
            if (const auto it = i == 0 ? between.end() : between.find(vertex_pair(line[i - 1], line[i]));
                it != between.end()) {
                std::vector<int> inner = it->second;
                if (line[i - 1] > line[i]) {
                    std::reverse(inner.begin(), inner.end());
                }
                divided.insert(divided.end(), inner.begin(), inner.end());
            }
            divided.push_back(line[i]);
        }
        out.lines.push_back(std::move(divided));
    }
    EdgeSplit split = split_edges(model, points);
    out.in_region.resize(split.parent.size());
    for (int t = 0; t < static_cast<int>(split.parent.size()); ++t) {
        out.in_region[t] = in_region[split.parent[t]];
        if (out.in_region[t]) {
            out.faces.push_back(t);
        }
    }
    out.model = std::move(split.model);
    return out;
}

} // namespace tapeline
