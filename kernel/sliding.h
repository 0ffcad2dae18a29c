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

Vec3 position_of(const Mesh& mesh, const MeshPoint& point);

/// Slides vertex v along the surface by the tangential part of u: the discrete straightest path from v in that
/// direction over the length of the tangential part (Section 4.1; method.md F). Stops at a border.
MeshPoint slide(const Mesh& mesh, const Topology& topology, int v, const Vec3& u);

} // namespace tapeline
