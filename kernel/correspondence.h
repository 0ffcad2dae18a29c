// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/error.h"
#include "kernel/feature_lines.h"

#include <string>
#include <vector>

namespace tapeline {

enum class CorrespondenceMode {
    projection, ///< each L0 vertex goes to its orthogonal foot on Lt (the paper's eq. 1); Lt trims L0
    arc_length  ///< equal fractions of arc length of the whole line and the whole target; nothing is trimmed
};

struct CorrespondenceOptions {
    CorrespondenceMode mode = CorrespondenceMode::projection;
    double max_distance_mm = 0; ///< a foot farther away than this is an error; 0 = no limit
};

/// The part of L0 that moves, and where each of its vertices goes.
struct Correspondence {
    FeatureLine line;                ///< the used part of L0 (the whole line when nothing was trimmed)
    std::vector<int> before;         ///< L0's vertices beyond the used part's first vertex, nearest first
    std::vector<int> after;          ///< the same beyond its last vertex
    std::vector<double> parameters;  ///< on Lt, one per vertex of `line`, strictly monotone (cyclically if closed)
    std::vector<Vec3> targets;       ///< C(parameter) [mm]
    std::vector<Vec3> displacements; ///< u_i = target - position [mm]
    std::vector<Vec3> tangents;      ///< unit tangents of Lt at the targets, in the sense of `line`
    bool reversed = false;           ///< Lt runs against the line
    std::vector<std::string> warnings;
};

/// Maps the vertices of L0 to Lt. With `projection`, vertices whose foot falls beyond an end of Lt are trimmed off,
/// and the first and last used vertices go to the ends of Lt when L0 reaches beyond them. Rejected when fewer than
/// two edges remain, when feet do not advance monotonically, when a foot is not unique, or when one is too far.
/// Short stretches near or beyond the target's centre of curvature, where orthogonal feet cannot be even or do not exist
/// uniquely, are spread by arc length instead, with a warning; the rules are in kernel/foot_matching.h. `before` and
/// `after` go on with those of `line` where it is a part of a longer line.
Result<Correspondence> correspond(const Model& model, const FeatureLine& line, const TargetCurve& target,
                                  const CorrespondenceOptions& options = {});

} // namespace tapeline
