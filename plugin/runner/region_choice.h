// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/correspondence.h"
#include "kernel/region.h"
#include "plugin/runner/job.h"

#include <vector>

namespace tapeline {

/// Translates the job's region settings for one model; reads files of bounding vertices. `lines` are the model's
/// feature lines, `moving` is the one that moves. Fails (usage) when more than one way to choose the region is given, or
/// when a line to be kept or held is the moving one.
Result<RegionOptions> region_options(const Model& model, const std::vector<FeatureLine>& lines,
                                     const FeatureLine& moving, const RegionSettings& settings);

/// Half-width [mm] of a band that holds the region which make_region would choose on an even mesh when none is given.
double automatic_roi_distance(const FeatureLine& line, const std::vector<Vec3>& displacements);

/// Triangles that come within `distance` of one of the points and hang together with the line's own triangles,
/// ascending. Long triangles count by their nearest point, so coarse tessellations are covered too.
std::vector<int> faces_near(const Mesh& mesh, const FeatureLine& line, const std::vector<Vec3>& points,
                            double distance);

} // namespace tapeline
