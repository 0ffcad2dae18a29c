// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh_grading.h"
#include "kernel/parallel.h"
#include "kernel/remesh_renumber.h"
#include "kernel/remesh_stages.h"

#include <algorithm>

namespace tapeline {

namespace {

/// Vertices of the joined model: where each divided vertex and each vertex of the remeshed patch goes.
struct Numbering {
    std::vector<int> of_divided; ///< -1 = vanished
    std::vector<int> of_patch;
    int count = 0;
};

Numbering number_vertices(const Divided& divided, const Remeshed& remeshed)
{
    const int vertices = static_cast<int>(divided.model.mesh.V.rows());
    // Vertices stay unless only region triangles use them and remeshing moved or dropped them.
    std::vector<char> stays(vertices, 1);
    for (const int v : remeshed.patch.to_vertex) {
        stays[v] = 0;
    }
    for (const int old : remeshed.result.old_vertex) {
        if (old >= 0) {
            stays[remeshed.patch.to_vertex[old]] = 1;
        }
    }
    std::vector<int> member_of_divided(vertices, -1), old_place;
    for (int v = 0; v < vertices; ++v) {
        if (stays[v]) {
            member_of_divided[v] = static_cast<int>(old_place.size());
            old_place.push_back(v < divided.old_vertices ? v : -1);
        }
    }
    std::vector<int> member_of_patch;
    for (const int old : remeshed.result.old_vertex) {
        if (old >= 0) {
            member_of_patch.push_back(member_of_divided[remeshed.patch.to_vertex[old]]);
        } else {
            member_of_patch.push_back(static_cast<int>(old_place.size()));
            old_place.push_back(-1);
        }
    }
    const std::vector<int> number = stable_numbers(old_place, divided.old_vertices);
    Numbering out;
    out.count = static_cast<int>(number.size());
    for (const int member : member_of_divided) {
        out.of_divided.push_back(member < 0 ? -1 : number[member]);
    }
    for (const int member : member_of_patch) {
        out.of_patch.push_back(number[member]);
    }
    return out;
}

void fill_vertices(const Divided& divided, const Remeshed& remeshed, const Numbering& number, RemeshResult& out)
{
    Positions& V = out.model.mesh.V;
    V.resize(number.count, 3);
    out.old_vertex.assign(number.count, -1);
    for (int v = 0; v < static_cast<int>(number.of_divided.size()); ++v) {
        if (number.of_divided[v] >= 0) {
            V.row(number.of_divided[v]) = divided.model.mesh.V.row(v);
            out.old_vertex[number.of_divided[v]] = v < divided.old_vertices ? v : -1;
        }
    }
    for (int i = 0; i < static_cast<int>(number.of_patch.size()); ++i) {
        if (remeshed.result.old_vertex[i] < 0) {
            V.row(number.of_patch[i]) = remeshed.result.mesh.V.row(i);
        }
    }
}

double longest_edge(const Mesh& mesh, int t)
{
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (mesh.V.row(mesh.F(t, k)) - mesh.V.row(mesh.F(t, (k + 1) % 3))).norm());
    }
    return longest;
}

void fill_faces(const Divided& divided, const Remeshed& remeshed, const Numbering& number, const PartSurface* old,
                RemeshResult& out)
{
    const Mesh& before = divided.model.mesh;
    const Mesh& after = remeshed.result.mesh;
    const bool tagged = old != nullptr;
    std::vector<int> outside, old_place;
    for (int t = 0; t < before.F.rows(); ++t) {
        if (!divided.in_region[t]) {
            outside.push_back(t);
            old_place.push_back(t < divided.old_faces ? t : -1);
        }
    }
    const int first_inside = static_cast<int>(outside.size()), inside = static_cast<int>(after.F.rows());
    old_place.resize(first_inside + inside, -1);
    const std::vector<int> place = stable_numbers(old_place, divided.old_faces);
    out.model.mesh.F.resize(static_cast<int>(place.size()), 3);
    out.model.cad_face.assign(tagged ? place.size() : 0, -1);
    for (int i = 0; i < first_inside; ++i) {
        for (int k = 0; k < 3; ++k) {
            out.model.mesh.F(place[i], k) = number.of_divided[before.F(outside[i], k)];
        }
        if (tagged) {
            out.model.cad_face[place[i]] = divided.model.cad_face[outside[i]];
        }
    }
    parallel_for(inside, [&](int t) {
        const int row = place[first_inside + t];
        Vec3 centre = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            out.model.mesh.F(row, k) = number.of_patch[after.F(t, k)];
            centre += Vec3(after.V.row(after.F(t, k))) / 3;
        }
        const int nearest = tagged ? old->closest(remeshed.result.part[t], centre).face : -1;
        if (nearest >= 0) {
            out.model.cad_face[row] = divided.model.cad_face[remeshed.patch.to_face[nearest]];
        }
    });
    out.region_faces.assign(place.begin() + first_inside, place.end());
    std::sort(out.region_faces.begin(), out.region_faces.end());
}

/// Tags of edges outside the region and of kept edges; seams that the triangles now flow across lose theirs.
std::vector<CadEdgeTag> carried_tags(const Divided& divided, const Numbering& number)
{
    const Mesh& mesh = divided.model.mesh;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<CadEdgeTag> tags;
    for (const CadEdgeTag& tag : divided.model.cad_edges) {
        const int e = topology.find_edge(tag.a, tag.b);
        const MeshEdge edge = e < 0 ? MeshEdge{} : topology.edge(e);
        const bool inside =
            (edge.left >= 0 && divided.in_region[edge.left]) || (edge.right >= 0 && divided.in_region[edge.right]);
        if (inside && !std::binary_search(divided.kept.begin(), divided.kept.end(), VertexPair{tag.a, tag.b})) {
            continue;
        }
        const VertexPair ends = vertex_pair(number.of_divided[tag.a], number.of_divided[tag.b]);
        tags.push_back({ends[0], ends[1], tag.cad_edge});
    }
    std::sort(tags.begin(), tags.end());
    return tags;
}

/// The new vertices' places on the exact geometry: those put on kept edges are known, the others take the CAD face of
/// the nearest old triangle of their part.
std::vector<SurfaceSite> find_sites(const Divided& divided, const Remeshed& remeshed, const Numbering& number,
                                    const PartSurface& old, const RemeshOptions& options)
{
    std::vector<SurfaceSite> sites = divided.sites;
    for (SurfaceSite& site : sites) {
        site.vertex = number.of_divided[site.vertex];
    }
    const IsotropicResult& result = remeshed.result;
    std::vector<int> part(result.old_vertex.size(), -1), fresh;
    for (int t = 0; t < result.mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            part[result.mesh.F(t, k)] = result.part[t];
        }
    }
    for (int v = 0; v < static_cast<int>(part.size()); ++v) {
        if (result.old_vertex[v] < 0 && part[v] >= 0) {
            fresh.push_back(v);
        }
    }
    const size_t first = sites.size();
    sites.resize(first + fresh.size());
    parallel_for(static_cast<int>(fresh.size()), [&](int i) {
        const int v = fresh[i];
        SurfaceSite& site = sites[first + i];
        site.vertex = number.of_patch[v];
        if (const int nearest = old.closest(part[v], result.mesh.V.row(v)).face; nearest >= 0) {
            const int t = remeshed.patch.to_face[nearest];
            site.cad_face = divided.model.cad_face[t];
            site.reach = std::max(0.5 * options.max_edge_mm, 0.25 * longest_edge(divided.model.mesh, t));
        }
    });
    return sites;
}

} // namespace

RemeshResult join(const Divided& divided, const Remeshed& remeshed, const RemeshOptions& options,
                  std::vector<SurfaceSite>& sites)
{
    RemeshResult out;
    out.model.surface = divided.model.surface;
    const Numbering number = number_vertices(divided, remeshed);
    fill_vertices(divided, remeshed, number, out);
    if (divided.model.cad_face.empty()) {
        fill_faces(divided, remeshed, number, nullptr, out);
    } else {
        const PartSurface old(remeshed.patch.mesh, remeshed.part);
        fill_faces(divided, remeshed, number, &old, out);
        sites = find_sites(divided, remeshed, number, old, options);
    }
    out.model.cad_edges = carried_tags(divided, number);
    for (const std::vector<int>& line : divided.lines) {
        out.kept_lines.emplace_back();
        for (const int v : line) {
            out.kept_lines.back().push_back(number.of_divided[v]);
        }
    }
    return out;
}

} // namespace tapeline
