// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/feature_lines.h"
#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// A set of triangles as one flag per triangle of the mesh.
using FaceSet = std::vector<char>;

/// Distance along the surface to the line and to the feet of its targets, per vertex [mm].
std::vector<double> band_distance(const Mesh& mesh, const Topology& topology, const FeatureLine& line,
                                  const std::vector<MeshFoot>& feet);

/// The triangles on both sides of the line's edges, ascending.
std::vector<int> faces_along(const Topology& topology, const FeatureLine& line);

/// The part of `inside` that is connected through ordinary interior edges to one of `starts`; edges flagged in
/// `barrier` (one entry per edge, or empty) are not crossed.
FaceSet connected_part(const Topology& topology, const FaceSet& inside, const std::vector<int>& starts,
                       const std::vector<char>& barrier = {});

/// Smooths what the discretisation left ragged, and repairs vertices at which the region touches only itself:
/// 1. triangles whose neighbours are all inside join, and so do pockets of outside triangles of at most 1 % of the
///    region's area;
/// 2. at a vertex where the region's triangles form several fans, all triangles around the vertex join; where that
///    does not help (a non-manifold vertex, no end after some rounds) the fans without a triangle of `keep` leave.
/// The result is again the part connected to `keep`.
FaceSet tidy(const Mesh& mesh, const Topology& topology, FaceSet inside, const std::vector<int>& keep);

/// The region's form as a surface.
struct RegionShape {
    int euler = 0;                          ///< V - E + F
    std::vector<std::vector<int>> openings; ///< vertices of each border loop, ascending; the largest loop first

    /// A disk (open line), or a disk or ring (closed line): the cut along the line then leaves two simple sides.
    bool simple_around(const FeatureLine& line) const
    {
        return openings.empty() ? false : euler == 1 || (line.closed && euler == 0 && openings.size() == 2);
    }
};
RegionShape shape_of(const Mesh& mesh, const Topology& topology, const FaceSet& inside);

} // namespace tapeline
