// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh_grading.h"
#include "kernel/mesh_parts.h"
#include "kernel/remesh_stages.h"

#include <algorithm>

namespace tapeline {

namespace {

/// Improves the remeshed triangles on the input's surface; vertices that move are no longer old ones.
void grade(IsotropicResult& result, const IsotropicInput& input)
{
    // Kept edges in the result's numbers: their ends are input vertices that stayed.
    std::vector<int> number(input.mesh.V.rows(), -1);
    for (int v = 0; v < static_cast<int>(result.old_vertex.size()); ++v) {
        if (result.old_vertex[v] >= 0) {
            number[result.old_vertex[v]] = v;
        }
    }
    GradedMesh graded{result.mesh, result.part, std::vector<char>(result.mesh.V.rows(), 1)};
    std::vector<VertexPair> kept;
    for (const VertexPair& e : input.kept_edges) {
        kept.push_back(vertex_pair(number[e[0]], number[e[1]]));
        graded.movable[number[e[0]]] = graded.movable[number[e[1]]] = 0;
    }
    for (const int v : input.kept_vertices) {
        graded.movable[number[v]] = 0;
    }
    std::sort(kept.begin(), kept.end());
    grade_triangles(graded, kept, input.edge_length, PartSurface(input.mesh, input.part));
    for (int v = 0; v < result.mesh.V.rows(); ++v) {
        if (graded.mesh.V.row(v) != result.mesh.V.row(v)) {
            result.old_vertex[v] = -1;
        }
    }
    result.mesh = std::move(graded.mesh);
    result.part = std::move(graded.part);
    result.old_vertex.resize(result.mesh.V.rows(), -1);
}

} // namespace

Result<Remeshed> remesh_patch(const Divided& divided, const RemeshOptions& options)
{
    Remeshed out;
    out.patch = patch_of_faces(divided.model.mesh, divided.faces);
    IsotropicInput input;
    input.mesh = out.patch.mesh;
    std::vector<char> tip(divided.model.mesh.V.rows(), 0);
    for (const int v : divided.tips) {
        tip[v] = 1;
    }
    for (int v = 0; v < static_cast<int>(out.patch.to_vertex.size()); ++v) {
        if (tip[out.patch.to_vertex[v]]) {
            input.kept_vertices.push_back(v);
        }
    }
    for (int t = 0; t < input.mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = input.mesh.F(t, k), b = input.mesh.F(t, (k + 1) % 3);
            if (std::binary_search(divided.kept.begin(), divided.kept.end(),
                                   vertex_pair(out.patch.to_vertex[a], out.patch.to_vertex[b]))) {
                input.kept_edges.push_back(vertex_pair(a, b));
            }
        }
    }
    std::sort(input.kept_edges.begin(), input.kept_edges.end());
    const Topology topology(input.mesh.F, static_cast<int>(input.mesh.V.rows()));
    out.part = mesh_parts(topology, input.kept_edges);
    input.part = out.part;
    input.edge_length = options.max_edge_mm;
    input.iterations = options.iterations;
    auto result = remesh_isotropic(input);
    if (!result) {
        return tl::unexpected(result.error());
    }
    out.result = std::move(*result);
    grade(out.result, input);
    return out;
}

} // namespace tapeline
