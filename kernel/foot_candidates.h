// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/foot_matching.h"

#include <vector>

namespace tapeline {

/// One point's feet. Stations are arc lengths on the curve.
struct PointFeet {
    double parameter = 0;
    double station = 0;
    double distance = 0;
    int beyond = 0;               ///< -1: before the curve's start, 1: behind its end
    double overshoot = 0;         ///< how far beyond [mm]
    std::vector<CurveFoot> rival; ///< feet nearly as near but far along the curve, and the chosen one
    std::vector<double> rival_stations;
    bool bad = false; ///< the chosen foot is not to be trusted
};

/// The feet of all points; those with rivals are marked bad.
std::vector<PointFeet> find_feet(const MatchInput& input, const TargetCurve& curve);

/// Turns stations round, for a curve that runs against the polyline.
void reverse_stations(std::vector<PointFeet>& feet, double length);

/// Chooses among rival feet of the points `first` to `last` where the neighbours on both sides lead to the same one,
/// at an ordinary pace; those are no longer bad. `length` is the curve's, stations grow along the polyline.
void settle_ambiguous(const MatchInput& input, int first, int last, double length, std::vector<PointFeet>& feet);

/// Length of the polyline up to each point; a closed one has an entry more, its whole length [mm].
std::vector<double> polyline_lengths(const MatchInput& input);

/// Distance of two stations along the curve, the short way round when it is closed [mm].
double station_gap(double s, double t, bool closed, double length);

} // namespace tapeline
