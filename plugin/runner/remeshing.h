// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/feature_lines.h"
#include "kernel/region.h"
#include "kernel/remesh.h"

#include <vector>

namespace tapeline {

/// A remeshed model, and what was known on the old one in new numbers.
struct Remeshed {
    Model model;
    FeatureLine line;      ///< the same line, with the vertices that were put between, and its `before` and `after`
    RegionOptions options; ///< its lines and fixed vertices in new numbers
    double min_angle_before = 0; ///< over the remeshed part [deg]
    double min_angle_after = 0;
    int projected = 0;
    std::vector<std::string> warnings;
};

/// Edge length for remeshing `faces` when none is given: a sixtieth of the line's length, but not so small that the
/// faces would get more than 50 000 vertices [mm].
double automatic_max_edge(const Mesh& mesh, const std::vector<int>& faces, const FeatureLine& line);

/// Remeshes `faces` with edges of about `max_edge` [mm] and keeps the line and the bounding lines of the region as
/// chains of edges. A fixed vertex that remeshing drops is replaced by the nearest vertex of the remeshed part.
Result<Remeshed> remesh_around(const Model& model, const std::vector<int>& faces, const FeatureLine& line,
                               const RegionOptions& options, double max_edge, double crease_angle);

} // namespace tapeline
