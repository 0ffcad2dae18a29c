// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/sections.h"

#include "kernel/median.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapeline {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double half_chord_segments = 4; ///< half the chord, in median segments
constexpr double relative_floor = 1e-5;   ///< δ0 / length: below what solvers and files leave behind
constexpr double degrees = 180 / std::numbers::pi;
constexpr int max_samples = 1000;

/// A polyline in its plane, by arc length.
class PlanePolyline {
public:
    PlanePolyline(std::span<const Vec3> polyline, const Vec3& normal, std::span<const double> sagitta)
        : origin_(polyline.front())
    {
        axis_x_ = polyline.back() - polyline.front();
        axis_x_ -= axis_x_.dot(normal) * normal;
        if (axis_x_.norm() <= 0) {
            axis_x_ = normal.unitOrthogonal();
        }
        axis_x_.normalize();
        axis_y_ = normal.cross(axis_x_);
        for (size_t i = 0; i < polyline.size(); ++i) {
            const Vec3& p = polyline[i];
            const Vec2 q(axis_x_.dot(p - origin_), axis_y_.dot(p - origin_));
            const double step = points_.empty() ? 0 : (q - points_.back()).norm();
            if (points_.empty() || step > 0) {
                arc_.push_back(points_.empty() ? 0 : arc_.back() + step);
                points_.push_back(q);
                sagitta_.push_back(i < sagitta.size() ? sagitta[i] : 0);
            }
        }
    }

    double length() const { return arc_.back(); }
    int segments() const { return static_cast<int>(points_.size()) - 1; }

    /// Median length of the segments that are not mere slivers.
    double median_segment() const
    {
        std::vector<double> lengths;
        for (size_t i = 1; i < arc_.size(); ++i) {
            if (arc_[i] - arc_[i - 1] > 1e-6 * length()) {
                lengths.push_back(arc_[i] - arc_[i - 1]);
            }
        }
        return median(std::move(lengths));
    }

    Vec2 at(double s) const
    {
        const auto next = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s);
        const auto i = next - arc_.begin();
        const double t = std::clamp((s - arc_[i - 1]) / (arc_[i] - arc_[i - 1]), 0.0, 1.0);
        return (1 - t) * points_[i - 1] + t * points_[i];
    }

    /// Largest sagitta between two arc lengths.
    double sagitta(double from, double to) const
    {
        double worst = 0;
        for (auto i = std::lower_bound(arc_.begin(), arc_.end(), from) - arc_.begin();
             i < static_cast<std::ptrdiff_t>(arc_.size()) && arc_[i] <= to; ++i) {
            worst = std::max(worst, sagitta_[i]);
        }
        return worst;
    }

    Vec3 lift(const Vec2& q) const { return origin_ + q.x() * axis_x_ + q.y() * axis_y_; }
    Vec3 lift_direction(const Vec2& q) const { return q.x() * axis_x_ + q.y() * axis_y_; }

private:
    Vec3 origin_, axis_x_, axis_y_;
    std::vector<Vec2> points_;
    std::vector<double> arc_, sagitta_;
};

/// θ and ε along a section, at evenly spaced arc lengths.
struct Directions {
    double first = 0, step = 0; ///< arc length of sample i = first + i * step
    std::vector<double> theta, band;
};

/// Deviation of the polyline from straight over one and two segments' length around s, halved.
double roughness(const PlanePolyline& line, double s, double segment)
{
    double worst = 0;
    for (const double reach : {segment, 2 * segment}) {
        const double r = std::min({reach, s, line.length() - s});
        if (r > 0.25 * reach) {
            worst = std::max(worst, 0.25 * (line.at(s - r) - 2 * line.at(s) + line.at(s + r)).norm());
        }
    }
    return worst;
}

Directions directions(const PlanePolyline& line, double segment)
{
    const double length = line.length();
    const double shortest = std::min(segment, length / 4); // half of the shortest chord
    const int count =
        std::clamp(static_cast<int>(std::ceil(2 * (length - 2 * shortest) / segment)) + 1, 3, max_samples);
    Directions d{shortest, (length - 2 * shortest) / (count - 1), {}, {}};
    std::vector<double> rough(count);
    for (int i = 0; i < count; ++i) {
        rough[i] = roughness(line, d.first + i * d.step, segment);
    }
    double previous = 0;
    for (int i = 0; i < count; ++i) {
        const double s = d.first + i * d.step;
        const double r = std::min({half_chord_segments * segment, s, length - s});
        const Vec2 chord = line.at(s + r) - line.at(s - r);
        double theta = std::atan2(chord.y(), chord.x());
        if (i > 0) {
            theta = previous + std::remainder(theta - previous, 2 * std::numbers::pi);
        }
        previous = theta;
        const int reach = static_cast<int>(std::ceil((r + segment) / d.step));
        const auto low = rough.begin() + std::max(0, i - reach);
        const auto high = rough.begin() + std::min(count, i + reach + 1);
        d.theta.push_back(theta);
        const double delta = std::max(*std::max_element(low, high), line.sagitta(s - r - segment, s + r + segment));
        d.band.push_back((delta + relative_floor * length) / r);
    }
    return d;
}

/// Samples at which θ reverses when every reversal within θ ± ε is ignored.
std::vector<int> reversals(const Directions& d)
{
    std::vector<int> found;
    const int count = static_cast<int>(d.theta.size());
    int top = 0, bottom = 0; // samples of the largest θ - ε and the smallest θ + ε since the last reversal
    int sense = 0;
    for (int i = 1; i < count; ++i) {
        const double low = d.theta[i] - d.band[i], high = d.theta[i] + d.band[i];
        const bool falls = high < d.theta[top] - d.band[top];
        const bool rises = low > d.theta[bottom] + d.band[bottom];
        if (falls && sense >= 0) {
            if (sense > 0) {
                found.push_back(top);
            }
            sense = -1;
            bottom = i;
        } else if (rises && sense <= 0) {
            if (sense < 0) {
                found.push_back(bottom);
            }
            sense = 1;
            top = i;
        }
        top = sense >= 0 && low > d.theta[top] - d.band[top] ? i : top;
        bottom = sense <= 0 && high < d.theta[bottom] + d.band[bottom] ? i : bottom;
    }
    return found;
}

/// dθ/ds at sample i: slope of the straight line fitted to θ over `reach` samples either way; one-sided at the ends.
double slope(const Directions& d, int i, int reach)
{
    const int count = static_cast<int>(d.theta.size());
    const int from = std::max(0, i - reach), to = std::min(count - 1, i + reach);
    const double middle = 0.5 * (from + to);
    double rise = 0, run = 0;
    for (int k = from; k <= to; ++k) {
        rise += (k - middle) * d.theta[k];
        run += (k - middle) * (k - middle);
    }
    return rise / (run * d.step);
}

} // namespace

SectionShape section_shape(std::span<const Vec3> polyline, const Vec3& normal, std::span<const double> sagitta)
{
    SectionShape shape;
    if (polyline.size() < 3) {
        return shape;
    }
    const PlanePolyline line(polyline, normal, sagitta);
    if (line.segments() < 2) {
        return shape;
    }
    const double segment = std::max(line.median_segment(), line.length() / max_samples);
    Directions d = directions(line, segment);
    const int count = static_cast<int>(d.theta.size());
    const int reach = std::max(1, static_cast<int>(std::lround(0.75 * half_chord_segments * segment / d.step)));
    for (int i = 0; i < count; ++i) {
        const double s = d.first + i * d.step;
        const double theta = d.theta[i];
        shape.points.push_back(line.lift(line.at(s)));
        shape.angle.push_back((theta - d.theta.front()) * degrees);
        shape.dead_band.push_back(d.band[i] * degrees);
        shape.curvature.push_back(slope(d, i, reach) * line.lift_direction({-std::sin(theta), std::cos(theta)}));
    }
    const std::vector<int> turns = reversals(d);
    shape.inflections = static_cast<int>(turns.size());
    double from = d.theta.front(), total = 0;
    for (const int i : turns) {
        total += std::abs(d.theta[i] - from);
        from = d.theta[i];
        shape.inflection_points.push_back(shape.points[i]);
    }
    total += std::abs(d.theta.back() - from);
    // The first and last chords miss their outer half; a curve that is long enough goes on bending as it did.
    if (line.segments() >= 6) {
        total += d.first * (std::abs(slope(d, 0, reach)) + std::abs(slope(d, count - 1, reach)));
    }
    shape.turning = total * degrees;
    return shape;
}

SectionShapes section_shapes(const Section& section)
{
    return {section_shape(section.compressed_before, section.rest_normal, section.sagitta[0]),
            section_shape(section.compressed_after, section.normal, section.sagitta[1]),
            section_shape(section.tension_before, section.rest_normal, section.sagitta[2]),
            section_shape(section.tension_after, section.normal, section.sagitta[3])};
}

} // namespace tapeline
