// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/deformation.h"
#include "kernel/error.h"
#include "kernel/split.h"

#include <vector>

namespace tapeline {

struct CreaseReport {
    bool applied = false;
    double before = 0;                  ///< length-weighted mean crease angle of L0 on the rest model [deg]
    double after = 0;                   ///< the same along Lt at the end [deg]
    double lost_before_restoration = 0; ///< mean absolute change before step 7 [deg]
};

/// Brings the crease angle along Lt back to that of L0 by turning the triangles beside the line on one side
/// (Section 5.6; method.md K), then letting the rest of that side follow with the ASAN solver.
/// `side` is the side to bend, `V` its current local positions; the used line is side.line[first .. last] (a closed
/// line: all of it and the closing edge). Per used line edge i (from entry i to i + 1), `other_normals` has the unit
/// normal of the triangle on the other side and `rest_angles` the wanted signed angle [deg] from that normal to the
/// normal of this side's triangle, about the direction of the edge. Returns the new local positions.
Result<DeformationResult> restore_crease(const SideMesh& side, const Positions& V, int first, int last,
                                         const std::vector<Vec3>& other_normals, const std::vector<double>& rest_angles,
                                         const DeformationOptions& options);

} // namespace tapeline
