// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <optional>
#include <span>
#include <vector>

namespace tapeline {

/// Closest points on the exact CAD surface behind a part of a model, which its triangles only approximate. The triangle
/// closest to a point says where to look: on the CAD faces of the triangles around it, each trimmed as it is, so that
/// places go from face to face without a gap. Safe from several threads.
class ExactGround {
public:
    /// The part of the model made of `faces`, all of it where that is empty. The model must outlive the ground.
    explicit ExactGround(const Model& model, std::span<const int> faces = {});

    /// Whether there is an exact surface at all: false for models that were read as a mesh.
    bool available() const { return tree_.has_value(); }

    /// Point of the exact surface closest to p; empty where no face has one, or none is available.
    std::optional<Vec3> closest(const Vec3& p) const;

private:
    const Model& model_;
    std::optional<Topology> topology_;
    std::vector<char> inside_; ///< per triangle, empty = all
    std::optional<ClosestPoint> tree_;
};

} // namespace tapeline
