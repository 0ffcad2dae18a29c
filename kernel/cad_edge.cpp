// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cad_edge.h"

#include <algorithm>

namespace tapeline {

int cad_edge_at(const Model& model, const VertexPair& pair)
{
    const auto& tags = model.cad_edges;
    const auto at = std::lower_bound(tags.begin(), tags.end(), CadEdgeTag{pair[0], pair[1], -1});
    return at != tags.end() && at->a == pair[0] && at->b == pair[1] ? at->cad_edge : -1;
}

} // namespace tapeline
