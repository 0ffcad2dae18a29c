// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <memory>
#include <optional>

class TopoDS_Face;

namespace tapeline {

/// Unit normals of a face's exact surface, by parameters.
class FaceNormals {
public:
    explicit FaceNormals(const TopoDS_Face& face);
    ~FaceNormals();
    /// Normal du × dv, in the frame in which the face's triangulation is stored; empty where the surface has none.
    std::optional<Vec3> at(double u, double v) const;

private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

/// Cosine between the normal of triangle (a, b, c) and the exact one at its middle; a triangle without area (altitude
/// below 1e-6 of the longest side) or a surface without normal there counts as 1. Negative = folded over.
double facing(const Vec3& a, const Vec3& b, const Vec3& c, const std::optional<Vec3>& exact_normal);

/// Triangles turned over by `unfold_face`.
struct Unfolded {
    int found = 0;
    int left = 0;
};

/// Undoes the folds of one face's triangulation, in place.
///
/// Triangles that are well oriented in the parameter plane can lie back to front in space: where interior nodes come
/// nearer to a curved CAD edge than the edge's chords do, the strip between them is folded over (OpenCASCADE places
/// such nodes where the surface's derivatives fade towards the edge). Such triangles are told by the exact normal at
/// their middle. Edges between them are flipped where both triangles face better then; interior nodes of the rest are
/// taken out and the holes triangulated anew in the parameter plane. Nodes on CAD edges, and all node numbers, stay; a
/// node taken out remains without triangles.
Unfolded unfold_face(const TopoDS_Face& face);

} // namespace tapeline
