// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <memory>
#include <span>

namespace tapeline {

/// A point on a mesh, and where it is.
struct MeshFoot {
    Vec3 point = Vec3::Zero();
    int face = -1;                   ///< triangle index in the mesh that the tree was built from
    Vec3 barycentric = Vec3::Zero(); ///< weights of the triangle's three corners; sum 1, each ≥ 0
    double distance = 0;             ///< to the query point [mm]
};

/// Axis-aligned bounding-box tree over the triangles of a mesh (CGAL AABB_tree behind a light face).
/// Holds a copy of what it needs; queries are const and safe from several threads. Zero-area triangles are left out.
class ClosestPoint {
public:
    explicit ClosestPoint(const Mesh& mesh);
    /// Only over the listed triangles; `face` in answers still counts in `mesh`.
    ClosestPoint(const Mesh& mesh, std::span<const int> faces);
    ~ClosestPoint();
    ClosestPoint(ClosestPoint&&) noexcept;
    ClosestPoint& operator=(ClosestPoint&&) noexcept;

    /// Nearest point of the mesh; face is -1 when the tree is empty.
    MeshFoot closest(const Vec3& p) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tapeline
