// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/face_unfold.h"
#include "kernel/face_patch.h"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace tapeline {

/// Triangles of one face, in space and in the parameter plane, where they are counter-clockwise.
struct UvTriangles {
    std::vector<Vec3> points;
    std::vector<Eigen::Vector2d> uv;
    std::vector<std::array<int, 3>> triangles;
    std::vector<char> fixed;            ///< per node: must stay
    std::vector<VertexPair> kept_edges; ///< ascending: must not be flipped away
    /// How well a triangle of three nodes faces the way of the exact surface: 1 = the same way, negative = folded over.
    std::function<double(int, int, int)> facing;
};

/// Flips edges and takes out nodes until no triangle is folded over or nothing helps; see `unfold_face`. Deterministic.
Unfolded unfold(UvTriangles& work);

} // namespace tapeline
