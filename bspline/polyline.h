// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline/least_squares.h"
#include "kernel/error.h"

#include <vector>

namespace tapeline::spline {

/// A cleaned polyline: finite points, no equal neighbours; a closed one does not repeat its first point.
struct Polyline {
    std::vector<Vec3> points;
    bool closed = false;
    std::vector<double> lengths; ///< arc length at each point; closed: one more entry, the whole length
    std::vector<double> bends;   ///< per point the distance to the chord of its neighbours [mm]; 0 at open ends

    double length() const { return lengths.back(); }
    int edges() const { return static_cast<int>(points.size()) - (closed ? 0 : 1); }
    const Vec3& end_of(int edge) const { return points[(edge + 1) % points.size()]; }
    /// Mean chord height of the edges, as far as neighbouring points tell it [mm].
    double sagitta() const;
};

/// Rejected with fewer than two different points (closed: three) or with one that is not finite.
Result<Polyline> make_polyline(const std::vector<Vec3>& points, bool closed);

/// Where a fit is checked between the points: the middle of each edge, and evenly spread inner points on edges longer
/// than a hundredth of the line.
struct EdgePoint {
    int edge = -1;
    Vec3 point = Vec3::Zero();
};
std::vector<EdgePoint> edge_points(const Polyline& polyline);

/// Points for a fit with parameters by arc length on [0, 1]: the polyline's own, weighted by the length they stand for,
/// and inner ones on edges longer than a quarter of a span, so that no span is left without. Inner points are known up
/// to the edge's chord height h only, so they weigh (tolerance / (tolerance + h))² of that: they hold the curve beside
/// a long straight edge, yet do not pull it into the bends that a polyline cuts. A closed polyline's first point is
/// repeated at parameter 1 with weight 0.
FitPoints fit_points(const Polyline& polyline, int spans, double tolerance_mm);

} // namespace tapeline::spline
