// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"
#include "kernel/topology.h"

namespace tapeline {

/// A point on a mesh given by a triangle and barycentric weights.
struct MeshPoint {
    int face = -1;
    Vec3 barycentric = Vec3::Zero();
};

/// The point in space [mm]; point.face must be a triangle of the mesh.
Vec3 position_of(const Mesh& mesh, const MeshPoint& point);

/// Slides vertex v along the surface by the tangential part of u [mm]: the discrete straightest path from v in that
/// direction over the length of the tangential part (Section 4.1; method.md F; Polthier and Schmies 1998). The tangent
/// plane is that of the area-weighted vertex normal; directions are carried into the triangles around v by polar
/// angles scaled to their angle sum. Where the path meets a vertex it goes on with equal angles to both sides.
///
/// Stops at a border or non-manifold edge; a direction that leaves the mesh at v itself, a zero or a non-finite u give
/// v. Crosses each triangle in constant time, and at most 100 times as many triangles as the mesh has. `face` is -1
/// only when v belongs to no triangle. At a border vertex the angles are scaled by the fan's opening as seen along the
/// normal, not to π as in method.md F: a corner of a flat side must not bend the path.
MeshPoint slide(const Mesh& mesh, const Topology& topology, int v, const Vec3& u);

/// The same from any point of the surface. `normal` is the surface's there: u's part across it is walked, turned into
/// the triangle's plane. At a vertex this is the function above.
MeshPoint slide(const Mesh& mesh, const Topology& topology, const MeshPoint& from, const Vec3& normal, const Vec3& u);

} // namespace tapeline
