// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/cgal_deformer.h"
#include "tests/support/cgal_peer.h"

namespace tapeline::testing {

Positions cgal_smooth_rotations(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                int iterations, double smoothness)
{
    return cgal_deformed<CGAL::SRE_ARAP>(rest, constrained, targets, iterations, smoothness);
}

} // namespace tapeline::testing
