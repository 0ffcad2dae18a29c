// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/cgal_peer.h"

#include "tests/support/cgal_deformer.h"

namespace tapeline::testing {

Positions cgal_spokes_and_rims(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                               int iterations)
{
    return cgal_deformed<CGAL::SPOKES_AND_RIMS>(rest, constrained, targets, iterations, 0);
}

} // namespace tapeline::testing
