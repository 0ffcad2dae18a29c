// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/face_patch.h"
#include "kernel/sliding.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// The surface on which a retraction places vertices; not for use outside retraction*.cpp. Cut along the other feature
/// lines in the side (`walls`), so that a vertex stays in the smooth part that it lies in: a path ends at a wall, the
/// normals beside it are those of its own part, and closest points are looked for in that part alone.
class RetractionGround {
public:
    RetractionGround(const Mesh& inner, const std::vector<VertexPair>& walls);

    /// The surface point closest to p, in any part.
    Vec3 closest(const Vec3& p) const;

    /// Distance of p to the smooth part that vertex v (not beside a wall) lies in [mm].
    double distance_in_part(int v, const Vec3& p) const;

    /// The tangent vector at vertex v along which the straightest path ends at `goal` (by shooting); u itself, the way to
    /// the goal in space, where no such path is found [mm].
    Vec3 arc_to(int v, const Vec3& u, const Vec3& goal) const;

    /// The place on the surface for vertex v that moves by `u` in space, or by the tangent vector `arc` along the
    /// surface. Where the surface turns by less than 15° on the way: the surface point closest to P + u. (On folded
    /// sides that point may lie on another sheet; where it is not next to the path's end, the point found by walking
    /// downhill from there is taken, unless it misses P + u by more than a quarter of |u| beyond the closest point's
    /// distance; then the point over or under P + u along the surface's smooth normal.) Where it turns by more than 30°,
    /// P + u leaves the surface: the end of the straightest path along `arc`. A blend of both, laid on the surface, in
    /// between.
    Vec3 place(int v, const Vec3& u, const Vec3& arc) const;

private:
    Vec3 position(int v) const { return mesh_.V.row(v); }
    Vec3 normal_at(int face, const Vec3& barycentric) const;
    Vec3 along_normal(int face, const Vec3& foot, const Vec3& wanted) const;
    Vec3 closest_from(int face, const Vec3& wanted, const Vec3& u) const;

    Mesh mesh_; ///< vertices beside walls have a copy for each part
    Topology topology_;
    Positions normals_;
    std::vector<int> local_;          ///< vertex of the side -> a copy of it here
    std::vector<int> part_;           ///< per triangle
    std::vector<ClosestPoint> trees_; ///< per part
};

} // namespace tapeline
