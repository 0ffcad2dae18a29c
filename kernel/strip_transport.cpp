// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/strip_transport.h"

#include "kernel/line_tangents.h"
#include "kernel/parallel.h"
#include "kernel/placement.h"
#include "kernel/segment.h"
#include "kernel/strip.h"
#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tapeline {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// A target far off the ground must not turn the strip on edge [deg].
constexpr double largest_pivot = 30;
constexpr int pivot_steps = 30;

using Quaternions = std::vector<Eigen::Quaterniond>;

/// Signed angle about the axis from a to b, as seen along it [rad].
double angle_about(const Vec3& axis, const Vec3& a, const Vec3& b)
{
    return std::atan2(axis.dot(a.cross(b)), a.dot(b) - axis.dot(a) * axis.dot(b));
}

/// The turn about the axis through p that brings p + chord onto the ground.
double pivot_to(const Vec3& p, const Vec3& axis, const Vec3& chord, const StripGround& ground)
{
    double angle = 0;
    for (int step = 0; step < pivot_steps; ++step) {
        const Vec3 arm = Eigen::AngleAxisd(angle, axis) * chord;
        const double more = angle_about(axis, arm, ground(p + arm) - p);
        angle = std::clamp(angle + more, -largest_pivot * degree, largest_pivot * degree);
        if (std::abs(more) < 1e-12) {
            break;
        }
    }
    return angle;
}

class Carrier {
public:
    Carrier(const SideMesh& side, const StripTransport& transport, const std::vector<Vec3>& targets)
        : side_(side), transport_(transport), inner_{side.mesh.V, side.mesh.F.topRows(side.inner_faces)},
          topology_(inner_.F, static_cast<int>(inner_.V.rows())), to_(targets)
    {
        for (size_t i = 0; i < side.line.size(); ++i) {
            from_.push_back(inner_.V.row(side.line[i]));
            farthest_ = std::max(farthest_, (to_[i] - from_[i]).norm());
        }
        along_ = line_tangents(from_, transport.closed);
        along_after_ = line_tangents(to_, transport.closed);
    }

    void turn(const StripGround& ground, CarriedStrip& strip)
    {
        const int n = static_cast<int>(from_.size());
        const std::vector<Vec3> outer = points_across(inner_, side_.line, transport_.closed, transport_.widths_mm);
        turns_.assign(n, Eigen::Quaterniond::Identity());
        strip.pivots.assign(n, 0);
        strip.lifts.assign(n, Vec3::Zero());
        parallel_for(
            n,
            [&](int i) {
                if (stays(i)) {
                    return;
                }
                const Eigen::Quaterniond carried = Eigen::Quaterniond::FromTwoVectors(along_[i], along_after_[i]);
                const Vec3 chord = carried * Vec3(outer[i] - from_[i]);
                const double share = resting(i, outer[i] - from_[i]);
                const double angle = share > 0 ? share * pivot_to(to_[i], along_after_[i], chord, ground) : 0;
                turns_[i] = Eigen::AngleAxisd(angle, along_after_[i]) * carried;
                strip.pivots[i] = angle / degree;
                const Vec3 edge = to_[i] + turns_[i] * Vec3(outer[i] - from_[i]);
                strip.lifts[i] = edge - ground(edge);
            },
            16);
    }

    void find_vertices(CarriedStrip& strip) const
    {
        std::vector<char> out(inner_.V.rows(), 0);
        for (const std::vector<int>* list : {&side_.fixed, &side_.guided}) {
            for (const int v : *list) {
                out[v] = 1;
            }
        }
        for (const VertexPair& edge : side_.features) {
            out[edge[0]] = out[edge[1]] = 1;
        }
        strip.vertices = strip_vertices(inner_, side_.line, transport_.closed, transport_.widths_mm);
        std::erase_if(strip.vertices, [&](int v) { return out[v] || topology_.border_vertex(v); });
    }

    void place(CarriedStrip& strip) const
    {
        const auto count = strip.vertices.size();
        strip.places.resize(static_cast<Eigen::Index>(count), 3);
        strip.segment.resize(count);
        strip.share.resize(count);
        parallel_for(
            static_cast<int>(count),
            [&](int k) {
                const Vec3 x = inner_.V.row(strip.vertices[k]);
                const auto [i, t] = station(x);
                const size_t j = next(i);
                strip.segment[k] = static_cast<int>(i);
                strip.share[k] = t;
                const Vec3 p = from_[i] + t * (from_[j] - from_[i]), q = to_[i] + t * (to_[j] - to_[i]);
                const bool still = stays(i) && stays(j);
                strip.places.row(k) = still ? x : Vec3(q + turns_[i].slerp(t, turns_[j]) * Vec3(x - p));
            },
            64);
    }

private:
    size_t next(size_t i) const { return (i + 1) % from_.size(); }
    bool moves(size_t i) const { return to_[i] != from_[i]; }
    bool stays(size_t i) const
    {
        const auto [before, after] = line_neighbours(i, from_.size(), transport_.closed);
        return !moves(i) && !moves(before) && !moves(after);
    }

    /// By how much the outer edge rests on the ground: not at all where the line leaves the side.
    double resting(size_t i, const Vec3& chord) const
    {
        constexpr double leaves = -0.02; // of the largest displacement
        return transport_.rests && farthest_ > 0
                   ? smooth_step((to_[i] - from_[i]).dot(chord.stableNormalized()) / farthest_, leaves, 0)
                   : 0;
    }

    /// The segment nearest to x and the share of it at which x lies straight across.
    std::pair<size_t, double> station(const Vec3& x) const
    {
        size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        const size_t segments = from_.size() - (transport_.closed ? 0 : 1);
        for (size_t i = 0; i < segments; ++i) {
            if (const double d = distance_to_segment(x, from_[i], from_[next(i)]); d < least) {
                least = d;
                nearest = i;
            }
        }
        // Straight across the tangent, which turns from entry to entry, x may belong to a neighbour.
        for (const int step : {0, 1, -1}) {
            const size_t n = from_.size();
            const size_t i = (nearest + n + static_cast<size_t>(step + static_cast<int>(n))) % n;
            const bool exists = transport_.closed || (static_cast<int>(nearest) + step >= 0 && i < segments);
            if (exists && ahead(x, i, 0) >= 0 && ahead(x, i, 1) <= 0) {
                return {i, crossing(x, i)};
            }
        }
        return {nearest, ahead(x, nearest, 0) < 0 ? 0.0 : (ahead(x, nearest, 1) > 0 ? 1.0 : crossing(x, nearest))};
    }

    /// How far x lies ahead of the section at share t of segment i [mm].
    double ahead(const Vec3& x, size_t i, double t) const
    {
        const size_t j = next(i);
        return (x - from_[i] - t * (from_[j] - from_[i])).dot(along_[i] + t * (along_[j] - along_[i]));
    }

    double crossing(const Vec3& x, size_t i) const
    {
        double low = 0, high = 1;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            (ahead(x, i, middle) >= 0 ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    const SideMesh& side_;
    const StripTransport& transport_;
    Mesh inner_;
    Topology topology_;
    std::vector<Vec3> from_, to_, along_, along_after_;
    Quaternions turns_;
    double farthest_ = 0; ///< largest displacement of the line [mm]
};

} // namespace

CarriedStrip carry_strip(const SideMesh& side, const StripTransport& transport, const std::vector<Vec3>& targets,
                         const StripGround& ground)
{
    CarriedStrip strip;
    Carrier carrier(side, transport, targets);
    carrier.turn(ground, strip);
    carrier.find_vertices(strip);
    carrier.place(strip);
    return strip;
}

} // namespace tapeline
