// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <memory>
#include <optional>
#include <vector>

class TopoDS_Edge;

namespace tapeline {

/// One CAD edge as an exact curve, for closest points. Immutable, safe from several threads.
class ExactEdge {
public:
    /// `parameters`: ascending curve parameters, close enough together that the polygon through them is near the curve
    /// (from the tessellation); empty = evenly spaced.
    ExactEdge(const TopoDS_Edge& edge, std::vector<double> parameters);
    ExactEdge(ExactEdge&&) noexcept;
    ~ExactEdge();

    /// Closest point of the edge, its ends included; empty for an edge without any geometry.
    std::optional<Vec3> closest(const Vec3& p) const;

    struct Impl;

private:
    std::unique_ptr<const Impl> impl_;
};

} // namespace tapeline
