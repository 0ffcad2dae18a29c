// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/error.h"
#include "kernel/region.h"
#include "kernel/topology.h"

#include <string>
#include <vector>

namespace tapeline {

/// "vertex 12 at (1, 2, 3)".
std::string vertex_place(const Mesh& mesh, int v);

/// Checks what the caller asks for, before any triangle is chosen: at most one way to choose, values in range, targets
/// that fit the line, a line of mesh edges.
Result<void> check_request(const Model& model, const Topology& topology, const FeatureLine& line,
                           const std::vector<Vec3>& targets, const RegionOptions& options);

/// Checks that the method can work on the region: it has triangles and a rim, holds the line and touches it at its
/// ends only, is a clean manifold surface. Every failure names the place.
Result<void> check_region(const Model& model, const Topology& topology, const FeatureLine& line, const Region& region,
                          const RegionOptions& options);

/// Checks the targets against the region; `feet` are the targets' closest points on the whole mesh.
Result<void> check_targets(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets,
                           const std::vector<MeshFoot>& feet, const Region& region);

} // namespace tapeline
