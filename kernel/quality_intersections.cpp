// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/quality_detail.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace tapeline::quality {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FacePair = std::pair<int, int>;

/// Pairs of region triangles that meet anywhere but at their shared corners and edges, ascending.
std::vector<FacePair> intersecting_pairs(const Context& context, const Mesh& mesh)
{
    SurfaceMesh surface;
    std::vector<SurfaceMesh::Vertex_index> vertex(mesh.V.rows());
    const auto add_vertex = [&](int v) { return surface.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)}); };
    for (const int v : context.vertices) {
        vertex[v] = add_vertex(v);
    }
    std::vector<int> face_of; // triangle of the mesh per face of `surface`
    for (const int t : context.faces) {
        if (mesh.F(t, 0) == mesh.F(t, 1) || mesh.F(t, 1) == mesh.F(t, 2) || mesh.F(t, 2) == mesh.F(t, 0)) {
            continue;
        }
        const auto face = surface.add_face(vertex[mesh.F(t, 0)], vertex[mesh.F(t, 1)], vertex[mesh.F(t, 2)]);
        if (face == SurfaceMesh::null_face()) {
            continue; // a triangle on a non-manifold edge has no place in the half-edge structure
        }
        face_of.push_back(t);
    }
    using Found = std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>;
    std::vector<Found> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(faces(surface), surface,
                                                                            std::back_inserter(found));
    std::vector<FacePair> pairs;
    for (const auto& [f, g] : found) {
        pairs.push_back(std::minmax(face_of[f.idx()], face_of[g.idx()]));
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace

void measure_intersections(const Context& context, QualityReport& report)
{
    const std::vector<FacePair> after = intersecting_pairs(context, context.moved);
    if (after.empty()) {
        return;
    }
    const std::vector<FacePair> before = intersecting_pairs(context, context.rest);
    std::vector<FacePair> created;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(created));
    report.self_intersections = static_cast<int>(created.size());
    if (!created.empty()) {
        const int t = created.front().first;
        report.self_intersection_at = context.moved.V(context.moved.F.row(t), Eigen::all).colwise().mean();
    }
}

} // namespace tapeline::quality
