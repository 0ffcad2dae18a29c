// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <optional>

namespace tapeline::spline {

/// Where a walk over the triangles starts.
struct WalkStart {
    int face = -1;
    Vec3 point = Vec3::Zero();
    Vec3 direction = Vec3::Zero(); ///< unit, in the triangle's plane
};

/// Start at `foot`, perpendicular to `tangent`: to the left of it seen from outside, or to the right. A foot on an edge
/// or vertex belongs to several triangles: the one that its own leftward direction enters is taken, so the start is
/// well defined on a crease. Empty where the tangent is normal to the surface or the triangles have no area.
std::optional<WalkStart> start_beside(const Mesh& mesh, const Topology& topology, const MeshFoot& foot,
                                      const Vec3& tangent, bool left);

struct WalkEnd {
    Vec3 point = Vec3::Zero();
    double missing = 0;        ///< what could not be walked because the border was in the way [mm]
    bool along_border = false; ///< the path was bent into the border's direction
};

/// Discrete straightest path: straight in each triangle, the next one unfolded into its plane. At an open border that
/// it meets at less than 30° the path goes on along the border; otherwise it stops there.
WalkEnd walk(const Mesh& mesh, const Topology& topology, const WalkStart& start, double distance);

/// Path along the model's open border, from a start that lies on it and points along it to within 30°; empty for other
/// starts. Ends where the border turns by more than 60°.
std::optional<WalkEnd> walk_border(const Mesh& mesh, const Topology& topology, const WalkStart& start, double distance);

} // namespace tapeline::spline
