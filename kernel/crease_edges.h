// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

enum class CreaseLevel : char {
    none,
    weak,  ///< sharp enough for a line to go on
    strong ///< sharp enough for a line to start
};

/// From this angle on an edge of a mesh file is a crease whatever its neighbourhood looks like [deg].
constexpr double very_sharp_angle = 40;

/// Bend at an edge between two triangles, positive where the surface is convex [deg].
double signed_bend(const Mesh& mesh, const MeshEdge& edge);

/// What is left of the crease angle of edge e when the bending that both sides show beside it is taken off [deg].
/// Walks straight away from the middle of e on both sides (triangles unfolded), measures how fast the facets there
/// turn, and extrapolates both sides' normals to e: an edge of a coarsely tessellated cylinder or fillet leaves
/// nearly 0, an edge between two flat or gently curved patches leaves its whole angle.
double standing_out_angle(const Mesh& mesh, const Topology& topology, int e);

/// Decides for every edge of the model whether it is part of a crease; `high` and `low` are the two thresholds [deg].
/// - Mesh files: the crease angle reaches the threshold, and it is very sharp (between facets that are not slivers: the
///   folds of a tessellation are as sharp) or at least 40 % of it stands out.
/// - Between two CAD faces: the angle between the exact faces' normals, taken on the exact edge, reaches the threshold
///   (where there are no exact faces: as for mesh files), and 180° minus it reaches `low`: faces that fold back onto each
///   other along a common tangent plane (the lip of a nacelle that runs into a cusp) have no crease. A CAD edge that is a crease over most of its length is filled where the crease dips below
///   `low` for less than a fifth of it.
/// - Inside one CAD face, or on its seam: as for mesh files, but only where the exact normals close beside the edge differ by at
///   least half as much; off CAD edges only very sharp edges that stand out, since the rest is tessellation.
/// Borders and non-manifold edges are never creases.
std::vector<CreaseLevel> crease_edges(const Model& model, const Topology& topology, double high, double low);

/// CAD edge per mesh edge, -1 = none; ignores tags that name no mesh edge.
std::vector<int> cad_edge_of_edges(const Model& model, const Topology& topology);

} // namespace tapeline
