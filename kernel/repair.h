// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <span>
#include <string>
#include <vector>

namespace tapeline {

/// How near border vertices must be to be the same place, as a fraction of the median over them of their largest
/// coordinate: a few steps of float32, which STL cannot tell apart for sure.
inline constexpr double border_tolerance = 5e-7;

struct RepairOptions {
    /// Join border edges that lie on exactly one other border edge: many programs write a vertex once per normal or
    /// texture, which opens the mesh along every sharp edge.
    bool sew_borders = true;
};

/// What `repair_mesh` found; every count is 0 when there was nothing.
struct RepairReport {
    int degenerate_faces = 0;          ///< with a vertex twice: removed
    int duplicate_faces = 0;           ///< same three vertices as an earlier one, either way round: removed
    int sewn_edges = 0;                ///< pairs of border edges joined
    int flipped_faces = 0;             ///< turned round to agree with the majority of their component
    int components = 0;                ///< pieces that hang together across edges with two triangles
    int non_manifold_edges = 0;        ///< more than two triangles; split apart where unambiguous
    int non_manifold_edges_left = 0;   ///< of these, still in the mesh
    int non_manifold_vertices = 0;     ///< pieces of surface that touch in this point only: each got its own copy
    int non_orientable_components = 0; ///< one-sided like a Möbius strip; left as they came
    int zero_area_faces = 0;           ///< kept: taking one out would tear a hole
    int isolated_vertices = 0;         ///< in no triangle: kept, so that vertex indices stay
    int border_edges = 0;              ///< in the result
    std::vector<std::string> warnings; ///< one sentence each, with the place of the first case
};

struct RepairedMesh {
    Mesh mesh;
    std::vector<int> source_face;   ///< per triangle of the result its index in the input; ascending
    std::vector<int> source_vertex; ///< for the vertices appended by splitting: the vertex each is a copy of
    RepairReport report;
};

/// Makes a mesh edge-manifold and consistently oriented as far as that is unambiguous, and counts the rest.
///
/// Vertex i of the input is vertex i of the result, bit by bit; copies made by splitting come after the last one.
/// Triangles keep their order. In turn:
/// 1. triangles with a vertex twice go, then those with the same vertices as an earlier one;
/// 2. border edges whose ends lie where those of exactly one other border edge lie are joined: the triangles of both
///    then use the lower-numbered vertices, the others become isolated. "Where": within `border_tolerance`
///    on each axis, since programs write 0 on one side and -2.7e-16 on the other;
/// 3. each component (joined across edges with exactly two triangles) is oriented the way most of its triangles are,
///    ties go to the lowest-numbered triangle; one-sided components stay as they are and are reported;
/// 4. an edge with more than two triangles is split where each component at it has exactly two there, one on each
///    hand (two solids that touch along an edge); where a sheet ends on another one, who stays with whom is not for
///    us to say: the edge is kept and reported;
/// 5. a vertex where several fans of triangles meet without a common edge is split into one copy for each.
/// Triangles without area (twice the area at most 1e-10 of the longest side squared) are only counted: they fill a
/// gap between their neighbours, so that removal would tear a hole. `check_faces` refuses them where it matters.
///
/// mesh.F must be within the vertices, coordinates finite. Deterministic; O(n log n).
RepairedMesh repair_mesh(Mesh mesh, const RepairOptions& options = {});

/// Drops the vertices that no triangle uses and renumbers the rest in their order; for formats without vertex numbers.
Mesh without_isolated_vertices(const Mesh& mesh);

/// Refuses triangles that a deformation cannot work on: without area, or at an edge with more than two triangles or
/// two that disagree in orientation. ErrorKind::rejected with one sentence that names the place.
/// faces: indices into mesh.F, of which `topology` was built.
Result<void> check_faces(const Mesh& mesh, const Topology& topology, std::span<const int> faces);

/// True when twice the triangle's area is at most 1e-10 of its longest side squared.
bool has_zero_area(const Mesh& mesh, int t);

} // namespace tapeline
