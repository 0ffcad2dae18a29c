// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/face_patch.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// Per triangle the number of the part it belongs to, from 0 in the order of each part's first triangle. Triangles hang
/// together over edges that exactly two of them share and that are not in `walls` (in any order; a pair that is no edge
/// parts nothing).
std::vector<int> mesh_parts(const Topology& topology, const std::vector<VertexPair>& walls = {});

} // namespace tapeline
