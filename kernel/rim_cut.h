// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension.h"
#include "kernel/region.h"

#include <vector>

namespace tapeline {

struct RimCut {
    Model model;   ///< the input's vertices in order, then those on the cut; cut triangles replaced in place by their
                   ///< first part, further parts appended
    Region region; ///< on the new triangles
    std::vector<AppendedVertex> appended; ///< in the order of their indices
};

/// Gives a band of triangles a smooth rim: cuts the triangles at the region's width along the line of equal distance
/// (method.md A10), so that its rim has no teeth to show where the surface may kink there. `region` must come from
/// `make_region` with the same line, targets and options; regions that were not chosen by distance are returned as
/// they are. Edges are cut at least a tenth of their length from their ends; nearer vertices count as on the line. Edges
/// of other feature lines, of `line` and of its continuation are not cut, nor is the rim moved across them.
RimCut cut_rim(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets, const Region& region,
               const RegionOptions& options);

} // namespace tapeline
