// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"

#include <vector>

namespace tapeline {

/// Where a mesh is cut: the half space on the side that `normal` points to stays.
struct CutPlane {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX(); ///< unit

    double height(const Vec3& p) const { return (p - point).dot(normal); }
};

struct ClipResult {
    Mesh mesh;               ///< what stays; kept vertices first, in their old order, then those on cut edges
    std::vector<int> vertex; ///< per vertex of the mesh before its index in `mesh`, -1 = gone
};

/// The part of the listed triangles in front of a plane, for pictures of a section. Triangles that the plane crosses
/// are divided along it; neighbours share the new vertices, so what was joined stays joined. A vertex in the plane
/// counts as in front. Rejected when an index does not exist or the normal is no direction.
Result<ClipResult> clip_mesh(const Mesh& mesh, const std::vector<int>& faces, const CutPlane& plane);

} // namespace tapeline
