// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/edit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// A plain cubic while it is made fair; indices as in method.md H3: pole i has the support [t_i, t_(i+4)].
class Fairing {
public:
    Fairing(BSplineData data, double max_move)
        : data_(std::move(data)), original_(data_.control_points), max_move_(max_move)
    {
    }

    /// Knots t_j whose pole d_(j-2) may move: the two poles at each end stay.
    int first() const { return 4; }
    int last() const { return static_cast<int>(original_.size()) - 1; }

    /// |C'''(t_j+) - C'''(t_j-)|
    double jump(int j) const { return jump_vector(j).norm(); }

    /// Sum of the jumps that pole d_(j-2) takes part in.
    double jumps_around(int j) const
    {
        double sum = 0;
        for (int k = std::max(j - 2, first()); k <= std::min(j + 2, last()); ++k) {
            sum += jump(k);
        }
        return sum;
    }

    /// Moves d_(j-2), as far as allowed, to the better of two places: Farin and Sapidis's, where the jump at t_j
    /// vanishes, and the one where the squares of all jumps that it takes part in have the least sum (the first alone
    /// soon gets stuck, as what one knot wins its neighbours lose). False, and nothing changed, where neither lessens
    /// the sum of the jumps.
    bool improve(int j)
    {
        Vec3& pole = data_.control_points[j - 2];
        const Vec3 old = pole;
        double best = jumps_around(j) * (1 - 1e-6);
        Vec3 best_place = old;
        for (const Vec3& goal : {smooth_position(j), least_squares_position(j)}) {
            Vec3 move = goal - original_[j - 2];
            if (move.norm() > max_move_) {
                move *= max_move_ / move.norm();
            }
            pole = original_[j - 2] + move;
            if (jumps_around(j) < best) {
                best = jumps_around(j);
                best_place = pole;
            }
        }
        pole = best_place;
        return best_place != old;
    }

    const BSplineData& data() const { return data_; }

private:
    double t(int i) const { return data_.knots[i]; }
    const Vec3& d(int i) const { return data_.control_points[i]; }

    /// C''' on the span that begins at t_i: three differences of the poles d_(i-3) .. d_i.
    Vec3 third(int i) const
    {
        const auto first_difference = [&](int k) -> Vec3 { return 3 * (d(k) - d(k - 1)) / (t(k + 3) - t(k)); };
        const auto second = [&](int k) -> Vec3 {
            return 2 * (first_difference(k) - first_difference(k - 1)) / (t(k + 2) - t(k));
        };
        return (second(i) - second(i - 1)) / (t(i + 1) - t(i));
    }

    Vec3 jump_vector(int j) const { return third(j) - third(j - 1); }

    Vec3 smooth_position(int j) const
    {
        const Vec3 l = ((t(j + 1) - t(j - 3)) * d(j - 3) - (t(j + 1) - t(j)) * d(j - 4)) / (t(j) - t(j - 3));
        const Vec3 r = ((t(j + 3) - t(j - 1)) * d(j - 1) - (t(j) - t(j - 1)) * d(j)) / (t(j + 3) - t(j));
        return ((t(j + 2) - t(j)) * l + (t(j) - t(j - 2)) * r) / (t(j + 2) - t(j - 2));
    }

    Vec3 least_squares_position(int j)
    {
        // Each jump is linear in the pole, with a scalar slope: measured by moving it once in x.
        Vec3& pole = data_.control_points[j - 2];
        const Vec3 old = pole;
        Vec3 sum = Vec3::Zero();
        double weight = 0;
        for (int k = std::max(j - 2, first()); k <= std::min(j + 2, last()); ++k) {
            const Vec3 before = jump_vector(k);
            pole.x() = old.x() + max_move_;
            const double slope = (jump_vector(k) - before).x() / max_move_;
            pole = old;
            sum += slope * before;
            weight += slope * slope;
        }
        return old - sum / weight;
    }

    BSplineData data_;
    std::vector<Vec3> original_;
    double max_move_;
};

bool plain_cubic(const BSplineData& data)
{
    const bool weighted = std::ranges::any_of(data.weights, [&](double w) { return w != data.weights.front(); });
    bool simple = true;
    for (size_t i = 4; i + 4 < data.knots.size(); ++i) {
        simple = simple && data.knots[i] < data.knots[i + 1] && data.knots[i - 1] < data.knots[i];
    }
    return data.degree == 3 && !weighted && simple;
}

Result<TargetLine> refit_as_cubic(const TargetLine& line, double tolerance_mm)
{
    constexpr int samples = 1000;
    std::vector<Vec3> points;
    for (int i = 0; i <= samples - (line.closed() ? 1 : 0); ++i) {
        points.push_back(line.point(line.parameter_at(line.length() * i / samples)));
    }
    FitOptions options;
    options.tolerance_mm = tolerance_mm;
    return fit_polyline(points, line.closed(), options);
}

} // namespace

Result<TargetLine> fair(const TargetLine& line, double max_move_mm)
try {
    if (!(max_move_mm > 0) || !std::isfinite(max_move_mm)) {
        return fail(ErrorKind::usage,
                    fmt::format("fairing may move control points by {} mm: give a length above 0", max_move_mm));
    }
    Result<TargetLine> cubic = line;
    double allowed = max_move_mm;
    if (!plain_cubic(line.data())) {
        cubic = refit_as_cubic(line, 0.1 * max_move_mm);
        allowed = 0.9 * max_move_mm;
        if (!cubic) {
            return cubic;
        }
    }
    Fairing fairing(cubic->data(), allowed);
    std::vector<bool> settled(cubic->data().knots.size(), false);
    const int rounds = 200 * std::max(0, fairing.last() - fairing.first() + 1);
    for (int round = 0; round < rounds; ++round) {
        int worst = -1;
        for (int j = fairing.first(); j <= fairing.last(); ++j) {
            if (!settled[j] && (worst < 0 || fairing.jump(j) > fairing.jump(worst))) {
                worst = j;
            }
        }
        if (worst < 0) {
            break;
        }
        const bool moved = fairing.improve(worst);
        settled[worst] = true;
        for (int j = std::max(fairing.first(), worst - 4); moved && j <= std::min(fairing.last(), worst + 4); ++j) {
            settled[j] = j == worst; // what was best for the neighbours has changed
        }
    }
    return TargetLine::from_data(fairing.data());
} catch (const std::exception& exception) {
    return fail(ErrorKind::rejected, fmt::format("the line cannot be faired: {}", exception.what()));
}

} // namespace tapeline
