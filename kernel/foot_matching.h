// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/error.h"

#include <string>
#include <vector>

namespace tapeline {

/// Where the vertices of a polyline go on a target curve.
struct FootMatch {
    int first = 0;                  ///< first used vertex of the polyline
    int last = 0;                   ///< last used vertex
    bool reversed = false;          ///< the curve runs against the polyline
    std::vector<double> parameters; ///< on the curve, one per used vertex
    std::vector<std::string> warnings;
};

/// A polyline to be matched, with what error messages need.
struct MatchInput {
    std::vector<Vec3> points;
    std::vector<int> vertices; ///< mesh vertex of each point, for messages
    bool closed = false;
};

/// Matches each point to its orthogonal foot on the curve.
/// - Points whose foot lies beyond an end of an open curve are left out. Where the polyline passes an end, or misses it
///   by at most three quarters of an edge, the nearest point goes exactly to the end.
/// - The sense of the curve follows from how the feet advance.
/// - A foot is ambiguous when another orthogonal foot is at most 5 % farther away but more than two edges and 2 % of
///   the curve off along it. It is settled when the neighbours on both sides lead to the same foot.
/// - Where feet stay ambiguous, run backwards, or spread by more than twice or less than a fifth of the average (the
///   line lies near or beyond the curve's centre of curvature), the stretch is bridged: it is widened until its average
///   spread is near the whole line's and its points are spread by arc length; a warning names the place.
/// Rejected when that concerns more than half of the used line, or when fewer than two edges remain.
Result<FootMatch> match_by_projection(const MatchInput& input, const TargetCurve& curve);

/// Matches equal fractions of arc length over the whole polyline and the whole curve. Open: in the sense of smaller
/// displacements. Closed: the first point goes to its foot, the sense follows from the feet.
Result<FootMatch> match_by_arc_length(const MatchInput& input, const TargetCurve& curve);

} // namespace tapeline
