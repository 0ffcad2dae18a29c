// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

namespace tapeline {

/// Removes triangles without area whose corners differ (caps: one corner lies on the opposite edge) by flipping that
/// edge with the triangle across it; no vertex moves and the number of triangles stays. Such triangles come from
/// degenerated CAD edges, where the tessellation's triangles in the parameter plane collapse. Edges on CAD edges and on
/// the border are not flipped. The mesh must be manifold and oriented. Returns the
/// number of caps that are gone.
int flip_caps(Model& model);

} // namespace tapeline
