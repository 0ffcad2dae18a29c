// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension.h"

#include <vector>

namespace tapeline {

/// What one edge of the prolonged line keeps of the change that the crease of the moved line takes.
struct RunOut {
    double left = -1;   ///< share of the change: 0 where the surface goes on as at rest, -1 where the line is free
    bool after = false; ///< whether the edge belongs to the line's last end
};

/// How that change runs out around the ends of the used line, per edge of the prolonged one: as a smooth step from as far
/// within as the end moves sideways, where all of it is left, to as far beyond, where none is. Edges with a crease at rest
/// below `sharp` [deg] have it shorter in proportion, smooth ones have none; 0 counts no edge as sharp. `angles` has the
/// creases at rest, as `signed_crease_angles` gives them. Around ends without a prolongation the line is free.
std::vector<RunOut> run_out(const ExtendedLine& line, const std::vector<double>& angles, double sharp);

} // namespace tapeline
