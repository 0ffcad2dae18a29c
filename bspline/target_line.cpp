// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/target_line.h"

#include "bspline/knots.h"
#include "bspline/target_line_impl.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

tl::unexpected<Error> rejected(std::string message) { return fail(ErrorKind::rejected, std::move(message)); }

Result<void> check_values(const BSplineData& data)
{
    const size_t n = data.control_points.size();
    if (data.degree < 1 || data.degree > BSplineData::max_degree) {
        return rejected(fmt::format("the target line has degree {}: use a degree from 1 to {}", data.degree,
                                    BSplineData::max_degree));
    }
    if (n < static_cast<size_t>(data.degree) + 1) {
        return rejected(fmt::format("the target line has {} control points: degree {} needs at least {}", n,
                                    data.degree, data.degree + 1));
    }
    if (data.knots.size() != n + data.degree + 1) {
        return rejected(fmt::format("the target line has {} knots: {} control points of degree {} need {}, each knot "
                                    "as often as its multiplicity",
                                    data.knots.size(), n, data.degree, n + data.degree + 1));
    }
    if (!data.weights.empty() && data.weights.size() != n) {
        return rejected(fmt::format("the target line has {} weights for {} control points: give one each, or none",
                                    data.weights.size(), n));
    }
    for (size_t i = 0; i < n; ++i) {
        // The square of a coordinate must not overflow.
        if (!data.control_points[i].allFinite() || data.control_points[i].cwiseAbs().maxCoeff() > 1e100) {
            return rejected(fmt::format("control point {} of the target line is not finite or absurdly large", i));
        }
        if (!data.weights.empty() && !(data.weights[i] > 1e-100 && data.weights[i] < 1e100)) {
            return rejected(
                fmt::format("weight {} of the target line is {}: weights must be positive", i, data.weights[i]));
        }
    }
    return {};
}

Result<void> check_knots(const BSplineData& data)
{
    const auto& knots = data.knots;
    for (size_t i = 0; i < knots.size(); ++i) {
        if (!(std::abs(knots[i]) < 1e100)) {
            return rejected(fmt::format("knot {} of the target line is not finite or absurdly large", i));
        }
        if (i > 0 && knots[i] < knots[i - 1]) {
            return rejected(fmt::format("knot {} of the target line ({}) is smaller than the knot before it ({}): "
                                        "knots must not decrease",
                                        i, knots[i], knots[i - 1]));
        }
        const double size = std::max(std::abs(knots.front()), std::abs(knots.back()));
        if (i > 0 && knots[i] != knots[i - 1] && knots[i] - knots[i - 1] < 1e-14 * size) {
            return rejected(fmt::format("knots {} and {} of the target line ({} and {}) differ only by rounding: make "
                                        "them equal, or farther apart",
                                        i - 1, i, knots[i - 1], knots[i]));
        }
    }
    const double first = knots[data.degree], last = knots[data.control_points.size()];
    if (!(first < last)) {
        return rejected(fmt::format("the knots of the target line leave no parameter range ({} to {})", first, last));
    }
    for (size_t i = 0; i < knots.size();) {
        size_t j = i;
        while (j < knots.size() && knots[j] == knots[i]) {
            ++j;
        }
        const bool inside = knots[i] > first && knots[i] < last;
        if (static_cast<int>(j - i) > data.degree + (inside ? 0 : 1)) {
            return rejected(fmt::format("knot {} of the target line is repeated {} times: at degree {} at most {} are "
                                        "allowed there",
                                        knots[i], j - i, data.degree, data.degree + (inside ? 0 : 1)));
        }
        i = j;
    }
    return {};
}

Result<void> check_closed(const BSplineData& data, double extent)
{
    const double gap = (data.control_points.front() - data.control_points.back()).norm();
    if (data.closed && gap > 1e-9 * extent) {
        return rejected(
            fmt::format("the target line is marked as closed but its ends are {} mm apart: repeat the first "
                        "control point as the last, or leave the mark out",
                        gap));
    }
    return {};
}

} // namespace

TargetLine::TargetLine(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Result<TargetLine> TargetLine::from_data(const BSplineData& input)
try {
    if (auto checked = check_values(input).and_then([&] { return check_knots(input); }); !checked) {
        return tl::unexpected(checked.error());
    }
    auto impl = std::make_shared<Impl>();
    impl->data = spline::clamp(input);
    Eigen::AlignedBox3d box;
    for (const Vec3& p : impl->data.control_points) {
        box.extend(p);
    }
    const double extent = box.diagonal().norm();
    const double size = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    if (!(extent > 1e-12 * size)) {
        return rejected(fmt::format("the target line has no length: all control points lie at ({}, {}, {})",
                                    box.min().x(), box.min().y(), box.min().z()));
    }
    if (auto checked = check_closed(impl->data, extent); !checked) {
        return tl::unexpected(checked.error());
    }
    impl->tiny = 1e-12 * extent;
    impl->spans = spline::BezierSpans(impl->data);
    std::vector<double> breaks{impl->spans.spans().front().first};
    for (const auto& span : impl->spans.spans()) {
        breaks.push_back(span.last);
    }
    impl->lengths = spline::ArcLengthTable(breaks, [&](double t) { return impl->derivative(t).norm(); });
    if (!(impl->lengths.total() > 1e-12 * size)) {
        return rejected("the target line has no length");
    }
    return TargetLine(impl);
} catch (const std::exception& exception) {
    return rejected(fmt::format("the target line cannot be used: {}", exception.what()));
}

BSplineData TargetLine::data() const { return impl_->data; }
double TargetLine::first_parameter() const { return impl_->spans.spans().front().first; }
double TargetLine::last_parameter() const { return impl_->spans.spans().back().last; }
bool TargetLine::closed() const { return impl_->data.closed; }

namespace {

double inside(const TargetLine& line, double t) { return std::clamp(t, line.first_parameter(), line.last_parameter()); }

} // namespace

Vec3 TargetLine::point(double parameter) const { return impl_->point(inside(*this, parameter)); }

Vec3 TargetLine::tangent(double parameter) const
{
    const double t = inside(*this, parameter);
    const double range = last_parameter() - first_parameter();
    const Vec3 d = impl_->derivative(t);
    if (d.norm() * range > impl_->tiny * 1e4) {
        return d.normalized();
    }
    // Coinciding control points: the direction of a short chord around the point.
    double h = 1e-6;
    while (h < 1) {
        const Vec3 chord = point(t + h * range) - point(t - h * range);
        if (chord.norm() > impl_->tiny) {
            return chord.normalized();
        }
        h *= 10;
    }
    return Vec3::UnitX();
}

double TargetLine::arc_length(double parameter) const
{
    return impl_->lengths.length_at(parameter, [this](double t) { return impl_->derivative(t).norm(); });
}

double TargetLine::parameter_at(double arc_length) const
{
    const double total = impl_->lengths.total();
    if (closed() && (arc_length < 0 || arc_length > total)) {
        arc_length -= std::floor(arc_length / total) * total;
    }
    return impl_->lengths.parameter_at(arc_length, [this](double t) { return impl_->derivative(t).norm(); });
}

} // namespace tapeline
