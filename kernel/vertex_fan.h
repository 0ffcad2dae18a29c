// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <optional>
#include <vector>

namespace tapeline {

/// The triangles around a vertex that hang together over edges shared by two, counter-clockwise, laid out as polar
/// angles [rad]: triangle k spans start[k] to start[k + 1]; start.back() is the angle sum.
struct VertexFan {
    std::vector<int> faces;
    std::vector<double> start;
    bool closed = false; ///< the last triangle touches the first

    double total() const { return start.back(); }
};

/// Which corner of the triangle vertex v is; v must be one of them.
int corner_of(const Mesh& mesh, int face, int v);

/// The fan around v that holds `face`, which must touch v. A closed fan begins with `face`, an open one at its
/// clockwise end.
VertexFan fan_at(const Mesh& mesh, const Topology& topology, int v, int face);

/// All fans around v: one on a manifold, several where parts touch at v or meet over a non-manifold edge.
std::vector<VertexFan> fans_at(const Mesh& mesh, const Topology& topology, int v);

/// The direction u in the polar angles of a fan around v: the angles of the fan's edges, scaled by their opening as seen
/// along the fan's normal, are turned so that they fit the projected edges best (exactly, on a flat fan; Polthier and
/// Schmies 1998). Empty when u points beside an open fan, or when the fan has no area.
std::optional<double> polar_angle(const Mesh& mesh, int v, const VertexFan& fan, const Vec3& u);

} // namespace tapeline
