// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/foot_matching.h"

#include "kernel/foot_bridging.h"
#include "kernel/foot_candidates.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr double end_snap = 0.75; ///< share of an edge

std::string place(const MatchInput& input, int i)
{
    const Vec3& p = input.points[i];
    return fmt::format("line vertex {} at ({:.6g}, {:.6g}, {:.6g})", input.vertices[i], p.x(), p.y(), p.z());
}

class Matcher {
public:
    Matcher(const MatchInput& input, const TargetCurve& curve)
        : input_(input), curve_(curve), n_(static_cast<int>(input.points.size())), length_(curve.length()),
          along_(polyline_lengths(input))
    {
    }

    Result<FootMatch> run()
    {
        feet_ = find_feet(input_, curve_);
        if (const auto sense = find_sense(); !sense) {
            return tl::unexpected(sense.error());
        }
        if (!input_.closed) {
            find_used_part();
            if (match_.last - match_.first < 2) {
                return fail(
                    ErrorKind::rejected,
                    fmt::format("only {} of the line's {} edges lie beside the target, two are needed; move the "
                                "target nearer to the line, or refine the mesh",
                                std::max(0, match_.last - match_.first), n_ - 1));
            }
        }
        settle_ambiguous(input_, match_.first, input_.closed ? n_ - 1 : match_.last, length_, feet_);
        return finish();
    }

private:
    tl::unexpected<Error> ambiguous_error() const
    {
        for (int i = 0; i < n_; ++i) {
            if (feet_[i].bad && feet_[i].beyond == 0 && feet_[i].rival.size() > 1) {
                return fail(
                    ErrorKind::rejected,
                    fmt::format("the foot of {} on the target is not unique: two places of the target {:.4g} mm "
                                "apart are both {:.4g} mm away; use the arc_length correspondence or a target "
                                "with gentler bends",
                                place(input_, i),
                                station_gap(feet_[i].rival_stations.front(), feet_[i].station, input_.closed, length_),
                                feet_[i].distance));
            }
        }
        return fail(ErrorKind::rejected, "the line's feet on the target do not advance; the target must run beside the "
                                         "line (use the arc_length correspondence if it does)");
    }

    /// Which way the feet go; turns stations round so that they grow along the polyline.
    Result<bool> find_sense()
    {
        double advance = 0;
        int good = 0, before = -1;
        const int steps = input_.closed ? n_ + 1 : n_;
        for (int k = 0; k < steps; ++k) {
            const int i = k % n_;
            if (feet_[i].bad) {
                continue;
            }
            good += k < n_ && feet_[i].beyond == 0 ? 1 : 0;
            if (before >= 0) {
                double step = feet_[i].station - feet_[before].station;
                if (input_.closed) {
                    step = std::remainder(step, length_);
                }
                advance += step;
            }
            before = i;
        }
        if (std::abs(advance) <= 1e-6 * length_) {
            if (std::ranges::any_of(feet_, &PointFeet::bad)) {
                return ambiguous_error();
            }
            return fail(
                ErrorKind::rejected,
                fmt::format("the line does not run beside the target: from {} on all its vertices have the same "
                            "foot on it; move the target to the line, or use the arc_length correspondence",
                            place(input_, 0)));
        }
        if (input_.closed && (good < 3 || std::abs(std::abs(advance) - length_) > 1e-6 * length_)) {
            return std::ranges::any_of(feet_, &PointFeet::bad)
                       ? Result<bool>(ambiguous_error())
                       : fail(ErrorKind::rejected, fmt::format("the closed line does not go round the closed target "
                                                               "exactly once; look at {}",
                                                               place(input_, 0)));
        }
        match_.reversed = advance < 0;
        if (match_.reversed) {
            reverse_stations(feet_, length_);
        }
        return true;
    }

    /// Trims an open polyline to the open curve and snaps its ends.
    void find_used_part()
    {
        int first = 0, last = n_ - 1;
        while (first < n_ && feet_[first].beyond != 0) {
            ++first;
        }
        while (last > first && feet_[last].beyond != 0) {
            --last;
        }
        if (first == n_) {
            // The whole curve may lie within one edge: nothing is left to use.
            match_.first = match_.last = 0;
            return;
        }
        for (int i = first; i <= last; ++i) {
            feet_[i].bad = feet_[i].bad || feet_[i].beyond != 0;
        }
        match_.first = snap_end(first, -1, 0);
        match_.last = snap_end(last, 1, length_);
        if (feet_[match_.first].station > 1e-4 * length_) {
            warn_unused(feet_[match_.first].station, "first");
        }
        if (length_ - feet_[match_.last].station > 1e-4 * length_) {
            warn_unused(length_ - feet_[match_.last].station, "last");
        }
    }

    void warn_unused(double mm, const char* end)
    {
        match_.warnings.push_back(
            fmt::format("the target is longer than the line: its {:.4g} mm beyond the foot of the "
                        "line's {} vertex are not used",
                        mm, end));
    }

    /// Sends the vertex nearest to the curve's end at `station` there; returns the end of the used part.
    int snap_end(int inner, int step, double station)
    {
        const double parameter =
            (station == 0) == !match_.reversed ? curve_.first_parameter() : curve_.last_parameter();
        const int outer = inner + step;
        const double missed = std::abs(feet_[inner].station - station);
        int chosen = inner;
        if (outer >= 0 && outer < n_) {
            const double edge = std::abs(along_[outer] - along_[inner]);
            if (feet_[outer].overshoot < missed && feet_[outer].overshoot <= end_snap * edge) {
                chosen = outer;
            } else if (missed > end_snap * edge) {
                return inner;
            }
        } else if (const int in = inner - step;
                   in < 0 || in >= n_ || missed > 0.5 * end_snap * std::abs(along_[in] - along_[inner])) {
            return inner;
        }
        feet_[chosen].station = station;
        feet_[chosen].parameter = parameter;
        feet_[chosen].beyond = 0;
        feet_[chosen].bad = false;
        return chosen;
    }

    Result<FootMatch> finish();
    StationRow row_from(int start) const;
    void take(const StationRow& row, const std::vector<bool>& bridged, int start);

    const MatchInput& input_;
    const TargetCurve& curve_;
    int n_;
    double length_;
    std::vector<double> along_;
    std::vector<PointFeet> feet_;
    FootMatch match_;
};

/// The used points in order from point `start`, all of them and the first again when closed.
StationRow Matcher::row_from(int start) const
{
    StationRow row;
    const int count = input_.closed ? n_ + 1 : match_.last - match_.first + 1;
    double station = feet_[start].station;
    for (int k = 0; k < count; ++k) {
        const PointFeet& feet = feet_[(start + k) % n_];
        if (!input_.closed) {
            station = feet.station;
        } else if (!feet.bad) {
            station += std::remainder(feet.station - station, length_);
        }
        row.station.push_back(station);
        row.along.push_back(start + k < n_ || !input_.closed ? along_[start + k] : along_[n_] + along_[start + k - n_]);
        row.bad.push_back(feet.bad);
    }
    if (input_.closed) {
        row.station.back() = row.station.front() + length_;
    }
    return row;
}

/// Takes the parameters over; those of bridged points follow from their new stations.
void Matcher::take(const StationRow& row, const std::vector<bool>& bridged, int start)
{
    match_.parameters.resize(input_.closed ? n_ : match_.last - match_.first + 1);
    std::vector<int> moved;
    for (int k = 0; k < static_cast<int>(match_.parameters.size()); ++k) {
        const int i = (start + k) % n_;
        double& parameter = match_.parameters[input_.closed ? i : k];
        parameter = feet_[i].parameter;
        if (bridged[k]) {
            const double s = input_.closed ? std::fmod(row.station[k] + length_, length_) : row.station[k];
            parameter = curve_.parameter_at(match_.reversed ? length_ - s : s);
            moved.push_back(i);
        }
    }
    if (!moved.empty()) {
        match_.warnings.push_back(
            fmt::format("{} vertices around {} lie near or beyond the target's centre of curvature and were spread by "
                        "arc length instead of by their feet",
                        moved.size(), place(input_, moved[moved.size() / 2])));
    }
}

/// Bridges what is left, and turns stations into parameters.
Result<FootMatch> Matcher::finish()
{
    // A closed polyline is cut open at the good vertex whose surroundings are good for longest.
    int start = match_.first;
    if (input_.closed) {
        std::vector<bool> bad;
        for (const PointFeet& feet : feet_) {
            bad.push_back(feet.bad);
        }
        start = farthest_from(bad);
        match_.last = n_ - 1;
    }
    StationRow row = row_from(start);
    const auto bridged = bridge(row);
    if (!bridged) {
        if (std::ranges::any_of(feet_, [](const PointFeet& feet) { return feet.bad && feet.rival.size() > 1; })) {
            return ambiguous_error();
        }
        return fail(
            ErrorKind::rejected,
            fmt::format("the feet on the target do not advance from {} on; use the arc_length correspondence or "
                        "a target that runs along the line",
                        place(input_, (start + bridged.error()) % n_)));
    }
    take(row, *bridged, start);
    return match_;
}

} // namespace

Result<FootMatch> match_by_projection(const MatchInput& input, const TargetCurve& curve)
{
    return Matcher(input, curve).run();
}

Result<FootMatch> match_by_arc_length(const MatchInput& input, const TargetCurve& curve)
{
    const auto along = polyline_lengths(input);
    const double length = curve.length();
    const size_t n = input.points.size();
    const auto parameters = [&](double phase, bool reversed) {
        std::vector<double> list(n);
        for (size_t i = 0; i < n; ++i) {
            const double share = along[i] / along.back() * length;
            const double s = phase + (reversed ? -share : share);
            list[i] = curve.parameter_at(input.closed ? std::fmod(s + length, length) : (reversed ? length + s : s));
        }
        if (!input.closed) {
            list.front() = reversed ? curve.last_parameter() : curve.first_parameter();
            list.back() = reversed ? curve.first_parameter() : curve.last_parameter();
        }
        return list;
    };
    const double phase = input.closed ? curve.arc_length(curve.foot(input.points.front()).parameter) : 0;
    const auto cost = [&](const std::vector<double>& list) {
        double sum = 0;
        for (size_t i = 0; i < n; ++i) {
            sum += (curve.point(list[i]) - input.points[i]).squaredNorm();
        }
        return sum;
    };
    FootMatch match;
    match.last = static_cast<int>(n) - 1;
    match.parameters = parameters(phase, false);
    auto backwards = parameters(phase, true);
    if (cost(backwards) < cost(match.parameters)) {
        match.parameters = std::move(backwards);
        match.reversed = true;
    }
    return match;
}

} // namespace tapeline
