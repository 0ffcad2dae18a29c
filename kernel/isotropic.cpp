// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/isotropic.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <exception>
#include <fmt/format.h>

namespace tapeline {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = SurfaceMesh::Vertex_index;
using Face = SurfaceMesh::Face_index;
using Edge = SurfaceMesh::Edge_index;

/// The mesh with the maps that CGAL reads and updates.
struct Workspace {
    SurfaceMesh surface;
    SurfaceMesh::Property_map<Edge, bool> kept_edge;
    SurfaceMesh::Property_map<Vertex, bool> kept_vertex;
    SurfaceMesh::Property_map<Face, int> part;
};

Workspace workspace_of(const IsotropicInput& input)
{
    Workspace w;
    // Recycled slots would give new vertices the numbers of old ones.
    w.surface.set_recycle_garbage(false);
    w.kept_edge = w.surface.add_property_map<Edge, bool>("e:kept", false).first;
    w.kept_vertex = w.surface.add_property_map<Vertex, bool>("v:kept", false).first;
    w.part = w.surface.add_property_map<Face, int>("f:part", 0).first;
    const Mesh& mesh = input.mesh;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        w.surface.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Face f = w.surface.add_face(Vertex(mesh.F(t, 0)), Vertex(mesh.F(t, 1)), Vertex(mesh.F(t, 2)));
        if (f == SurfaceMesh::null_face()) {
            throw std::runtime_error(fmt::format("triangle {} does not join its neighbours", t));
        }
        w.part[f] = input.part[t];
    }
    for (const int v : input.kept_vertices) {
        w.kept_vertex[Vertex(v)] = true;
    }
    for (const Edge e : w.surface.edges()) {
        const auto h = w.surface.halfedge(e);
        const VertexPair ends = vertex_pair(w.surface.source(h), w.surface.target(h));
        w.kept_edge[e] =
            w.surface.is_border(e) || std::binary_search(input.kept_edges.begin(), input.kept_edges.end(), ends);
    }
    return w;
}

IsotropicResult result_of(const Workspace& w, const Mesh& input)
{
    const SurfaceMesh& surface = w.surface;
    IsotropicResult result;
    result.mesh.V.resize(surface.number_of_vertices(), 3);
    result.mesh.F.resize(surface.number_of_faces(), 3);
    std::vector<int> number(surface.num_vertices(), -1);
    int row = 0;
    for (const Vertex v : surface.vertices()) {
        const auto& p = surface.point(v);
        result.mesh.V.row(row) << p.x(), p.y(), p.z();
        const int old = static_cast<int>(v);
        const bool same = old < input.V.rows() && result.mesh.V.row(row) == input.V.row(old);
        result.old_vertex.push_back(same ? old : -1);
        number[v] = row++;
    }
    row = 0;
    for (const Face f : surface.faces()) {
        int k = 0;
        for (const Vertex v : surface.vertices_around_face(surface.halfedge(f))) {
            result.mesh.F(row, k++) = number[v];
        }
        result.part.push_back(w.part[f]);
        ++row;
    }
    return result;
}

} // namespace

Result<IsotropicResult> remesh_isotropic(const IsotropicInput& input)
{
    namespace pmp = CGAL::Polygon_mesh_processing;
    try {
        Workspace w = workspace_of(input);
        pmp::isotropic_remeshing(w.surface.faces(), input.edge_length, w.surface,
                                 CGAL::parameters::edge_is_constrained_map(w.kept_edge)
                                     .vertex_is_constrained_map(w.kept_vertex)
                                     .face_patch_map(w.part)
                                     .protect_constraints(true)
                                     .number_of_iterations(input.iterations)
                                     .number_of_relaxation_steps(3)
                                     .do_project(true));
        return result_of(w, input.mesh);
    } catch (const std::exception& e) {
        return fail(
            ErrorKind::rejected,
            fmt::format("the region could not be remeshed; try another edge length or repair the mesh ({})", e.what()));
    }
}

} // namespace tapeline
