// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geodesic_path.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;

SurfaceMesh to_surface_mesh(const Mesh& mesh)
{
    SurfaceMesh surface;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        surface.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        surface.add_face(SurfaceMesh::Vertex_index(mesh.F(t, 0)), SurfaceMesh::Vertex_index(mesh.F(t, 1)),
                         SurfaceMesh::Vertex_index(mesh.F(t, 2)));
    }
    return surface;
}

/// Receives what the path runs through, from its end back to the source.
struct Collector {
    const SurfaceMesh& surface;
    const FacePatch& patch;
    std::vector<PathPoint> points;

    void operator()(SurfaceMesh::Halfedge_index h, double t)
    {
        const int from = patch.to_vertex[surface.source(h)], to = patch.to_vertex[surface.target(h)];
        points.push_back(from < to ? PathPoint{from, to, t} : PathPoint{to, from, 1 - t});
    }
    void operator()(SurfaceMesh::Vertex_index v) { points.push_back({patch.to_vertex[v], -1, 0}); }
    // Sources and ends are vertices, so a face is never the place of a path point.
    void operator()(SurfaceMesh::Face_index, const Traits::Barycentric_coordinates&) {}
};

std::vector<PathPoint> shortest_path(const FacePatch& patch, int from, int to)
{
    const SurfaceMesh surface = to_surface_mesh(patch.mesh);
    ShortestPath solver(surface);
    for (int v = 0; v < static_cast<int>(patch.to_vertex.size()); ++v) {
        if (patch.to_vertex[v] == from) {
            solver.add_source_point(SurfaceMesh::Vertex_index(v));
        }
    }
    double best = std::numeric_limits<double>::infinity();
    std::vector<PathPoint> path;
    for (int v = 0; v < static_cast<int>(patch.to_vertex.size()); ++v) {
        if (patch.to_vertex[v] != to) {
            continue;
        }
        Collector collector{surface, patch, {}};
        const double length =
            solver.shortest_path_sequence_to_source_points(SurfaceMesh::Vertex_index(v), collector).first;
        if (length >= 0 && length < best) {
            best = length;
            path = std::move(collector.points);
        }
    }
    std::reverse(path.begin(), path.end());
    return path;
}

bool same(const PathPoint& p, const PathPoint& q) { return p.is_vertex() && q.is_vertex() && p.a == q.a; }

} // namespace

double path_length(const Mesh& mesh, const std::vector<PathPoint>& path)
{
    double length = 0;
    for (size_t i = 1; i < path.size(); ++i) {
        length += (path[i].position(mesh) - path[i - 1].position(mesh)).norm();
    }
    return length;
}

Result<std::vector<PathPoint>> geodesic_path(const Mesh& mesh, std::span<const int> faces, int from, int to,
                                             const std::vector<VertexPair>& walls)
{
    const FacePatch patch = patch_of_faces(mesh, faces, walls);
    for (const int v : {from, to}) {
        if (std::find(patch.to_vertex.begin(), patch.to_vertex.end(), v) == patch.to_vertex.end()) {
            return fail(ErrorKind::rejected, fmt::format("vertex {} is not in the triangles of the geodesic", v));
        }
    }
    std::vector<PathPoint> path;
    try {
        path = shortest_path(patch, from, to);
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("the geodesic from vertex {} to vertex {} failed on degenerate "
                                                     "triangles; remesh the region ({})",
                                                     from, to, e.what()));
    }
    path.erase(std::unique(path.begin(), path.end(), same), path.end());
    if (path.size() < 2 || path.front().a != from || !path.front().is_vertex()) {
        return fail(ErrorKind::rejected, fmt::format("the triangles do not connect vertex {} to vertex {}", from, to));
    }
    return path;
}

} // namespace tapeline
