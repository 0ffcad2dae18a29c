// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/foot_candidates.h"

#include "kernel/parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tapeline {

namespace {

constexpr double nearly_as_near = 1.05;
constexpr double rounding = 1e-9; ///< of the curve's length

PointFeet feet_of(const Vec3& p, const TargetCurve& curve, bool closed, double length, double edge)
{
    const CurveFoot foot = curve.foot(p);
    PointFeet feet;
    feet.parameter = foot.parameter;
    feet.station = curve.arc_length(foot.parameter);
    feet.distance = foot.distance;
    if (foot.at_end && !closed) {
        const bool start = feet.station < 0.5 * length;
        feet.overshoot = (start ? 1 : -1) * foot.tangent.dot(foot.point - p);
        feet.beyond = feet.overshoot > rounding * length ? (start ? -1 : 1) : 0;
        return feet;
    }
    const double far = std::max(2 * edge, 0.02 * length);
    for (const CurveFoot& other : curve.all_feet(p)) {
        const double station = curve.arc_length(other.parameter);
        if (other.distance <= nearly_as_near * foot.distance + rounding * length &&
            station_gap(station, feet.station, closed, length) > far) {
            feet.rival.push_back(other);
            feet.rival_stations.push_back(station);
        }
    }
    feet.bad = !feet.rival.empty();
    feet.rival.push_back(foot);
    feet.rival_stations.push_back(feet.station);
    return feet;
}

/// The candidate that goes on from `station` in the given sense by about `edge`.
std::optional<size_t> continuing(const PointFeet& feet, double station, double edge, int sense, bool closed,
                                 double length)
{
    std::optional<size_t> best;
    double least = 0;
    for (size_t k = 0; k < feet.rival.size(); ++k) {
        double step = sense * (feet.rival_stations[k] - station);
        if (closed) {
            step = std::remainder(step, length);
        }
        const double miss = std::abs(step - edge);
        if (miss <= edge && (!best || miss < least)) {
            best = k;
            least = miss;
        }
    }
    return best;
}

} // namespace

double station_gap(double s, double t, bool closed, double length)
{
    const double d = std::abs(s - t);
    return closed ? std::min(d, length - d) : d;
}

std::vector<double> polyline_lengths(const MatchInput& input)
{
    std::vector<double> lengths{0};
    const size_t n = input.points.size();
    for (size_t i = 0; i + 1 < n + (input.closed ? 1 : 0); ++i) {
        lengths.push_back(lengths.back() + (input.points[(i + 1) % n] - input.points[i]).norm());
    }
    return lengths;
}

std::vector<PointFeet> find_feet(const MatchInput& input, const TargetCurve& curve)
{
    const auto along = polyline_lengths(input);
    const double edge = along.back() / static_cast<double>(std::max<size_t>(1, along.size() - 1));
    const double length = curve.length();
    std::vector<PointFeet> feet(input.points.size());
    parallel_for(
        static_cast<int>(feet.size()),
        [&](int i) { feet[i] = feet_of(input.points[i], curve, input.closed, length, edge); }, 8);
    return feet;
}

void reverse_stations(std::vector<PointFeet>& feet, double length)
{
    for (PointFeet& point : feet) {
        point.station = length - point.station;
        point.beyond = -point.beyond;
        for (double& station : point.rival_stations) {
            station = length - station;
        }
    }
}

void settle_ambiguous(const MatchInput& input, int first, int last, double length, std::vector<PointFeet>& feet)
{
    const int n = static_cast<int>(feet.size());
    const auto sweep = [&](int sense) {
        std::vector<std::optional<size_t>> choice(n);
        double station = std::nan("");
        // Round a closed line twice: what precedes the first point is known only then.
        const int steps = input.closed ? 2 * n : last - first + 1;
        for (int k = 0; k < steps; ++k) {
            const int i = (((sense > 0 ? first : last) + sense * k) % n + n) % n;
            if (!feet[i].bad) {
                station = feet[i].station;
                continue;
            }
            choice[i].reset();
            if (!std::isnan(station) && !feet[i].rival.empty()) {
                const double edge = (input.points[i] - input.points[((i - sense) % n + n) % n]).norm();
                choice[i] = continuing(feet[i], station, edge, sense, input.closed, length);
            }
            station = choice[i] ? feet[i].rival_stations[*choice[i]] : std::nan("");
        }
        return choice;
    };
    const auto forward = sweep(1), backward = sweep(-1);
    for (int i = 0; i < n; ++i) {
        if (feet[i].bad && forward[i] && forward[i] == backward[i]) {
            feet[i].station = feet[i].rival_stations[*forward[i]];
            feet[i].parameter = feet[i].rival[*forward[i]].parameter;
            feet[i].bad = false;
        }
    }
}

} // namespace tapeline
