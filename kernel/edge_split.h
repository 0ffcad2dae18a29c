// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <vector>

namespace tapeline {

/// A new vertex on the edge a–b at (1 - t) V[a] + t V[b], 0 < t < 1.
struct EdgePoint {
    int a = -1;
    int b = -1;
    double t = 0;
};

struct EdgeSplit {
    Model model;             ///< old vertices, then the new ones in the order given
    std::vector<int> parent; ///< per triangle of `model` the triangle that it is a part of
};

/// Puts new vertices on edges and splits every triangle at those edges, so that the mesh stays conforming. A split
/// triangle is replaced in place by its first part, its other parts are appended. CAD faces and edge tags are handed
/// down to the parts. A triangle with one new vertex on each of two edges gets the edge between them; one with a
/// single new vertex gets the edge from it to the opposite corner. Points must be distinct and lie on existing edges.
EdgeSplit split_edges(const Model& model, const std::vector<EdgePoint>& points);

} // namespace tapeline
