// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/face_patch.h"

namespace tapeline {

/// Number of the CAD edge on which a mesh edge of the model lies (`pair` ascending); -1 where it lies on none.
int cad_edge_at(const Model& model, const VertexPair& pair);

} // namespace tapeline
