// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/edit.h"

#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// Keeps a closed line closed and smooth at its seam while control points are moved.
class Seam {
public:
    explicit Seam(const BSplineData& data) : n_(static_cast<int>(data.control_points.size()) - 1)
    {
        const auto& p = data.control_points;
        const auto& u = data.knots;
        if (!data.closed) {
            return;
        }
        const double first = u[data.degree + 1] - u[1], last = u[n_ + data.degree] - u[n_];
        const double first_weight = data.weights.empty() ? 1 : data.weights[1] / data.weights[0];
        const double last_weight = data.weights.empty() ? 1 : data.weights[n_ - 1] / data.weights[n_];
        const Vec3 a = (p[1] - p[0]).normalized(), b = (p[n_] - p[n_ - 1]).normalized();
        // A tangent-continuous seam with control points to both sides that are not the same one.
        tangent_ = data.degree > 1 && n_ > 3 && (a - b).norm() < 1e-6;
        ratio_ = last / first * first_weight / last_weight;
        if (tangent_ && std::abs((p[n_] - p[n_ - 1]).norm() / (p[1] - p[0]).norm() / ratio_ - 1) > 1e-6) {
            ratio_ = (p[n_] - p[n_ - 1]).norm() / (p[1] - p[0]).norm(); // same direction, different speed: keep it
        }
        closed_ = true;
    }

    void move(std::vector<Vec3>& p, int index, const Vec3& by) const
    {
        if (closed_ && (index == 0 || index == n_)) {
            p[0] += by;
            p[n_] = p[0];
            if (tangent_) {
                p[1] += by;
                p[n_ - 1] += by;
            }
            return;
        }
        p[index] += by;
        if (closed_ && tangent_ && index == 1) {
            p[n_ - 1] = p[n_] - ratio_ * (p[1] - p[0]);
        } else if (closed_ && tangent_ && index == n_ - 1) {
            p[1] = p[0] + (p[n_] - p[n_ - 1]) / ratio_;
        }
    }

private:
    int n_;
    bool closed_ = false, tangent_ = false;
    double ratio_ = 1; ///< |P_n - P_(n-1)| / |P_1 - P_0| for a smooth seam
};

} // namespace

Result<TargetLine> move_control_points(const TargetLine& line, const std::vector<ControlPointEdit>& edits)
{
    BSplineData data = line.data();
    const Seam seam(data);
    const int n = static_cast<int>(data.control_points.size());
    for (const ControlPointEdit& edit : edits) {
        if (edit.index < 0 || edit.index >= n) {
            return fail(ErrorKind::rejected, fmt::format("the line has no control point {}: its {} control points are "
                                                         "numbered 0 to {}",
                                                         edit.index, n, n - 1));
        }
        if (!edit.value.allFinite()) {
            return fail(ErrorKind::rejected,
                        fmt::format("the edit of control point {} has a value that is not finite", edit.index));
        }
        seam.move(data.control_points, edit.index,
                  edit.relative ? edit.value : Vec3(edit.value - data.control_points[edit.index]));
    }
    return TargetLine::from_data(data);
}

} // namespace tapeline
