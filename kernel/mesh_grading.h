// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/face_patch.h"

#include <vector>

namespace tapeline {

/// A mesh of which every triangle belongs to a part, to be asked for the nearest point of one part.
class PartSurface {
public:
    /// `part` has one number ≥ 0 per triangle.
    PartSurface(const Mesh& mesh, const std::vector<int>& part);

    MeshFoot closest(int part, const Vec3& p) const { return trees_[part].closest(p); }
    Vec3 normal(const MeshFoot& foot) const { return foot.face < 0 ? Vec3::Zero() : normals_[foot.face]; }

private:
    std::vector<ClosestPoint> trees_;
    std::vector<Vec3> normals_;
};

/// A mesh whose triangles are being improved.
struct GradedMesh {
    Mesh mesh;
    std::vector<int> part;     ///< per triangle
    std::vector<char> movable; ///< per vertex
};

/// Improves the triangles of an evenly remeshed surface. Kept edges (ascending; they neither move nor split) that are
/// much shorter than `wanted` leave thin triangles beside them: there edges are split to a length that grows with the
/// distance by 0.4 mm per mm. Then edges are flipped and movable vertices relaxed on `surface`, each only where that
/// enlarges the smallest angle around; triangles folded over against the surface count as worst, so folds are undone
/// where that is possible. Existing vertices keep their numbers, new ones are appended. Deterministic.
void grade_triangles(GradedMesh& graded, const std::vector<VertexPair>& kept, double wanted,
                     const PartSurface& surface);

} // namespace tapeline
