// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/exact_edge.h"

#include "kernel/segment.h"

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <limits>

namespace tapeline {

namespace {

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

} // namespace

struct ExactEdge::Impl {
    Handle(Geom_Curve) curve; ///< null for a degenerated edge, which is one point
    std::vector<double> parameters;
    std::vector<Vec3> points;
    bool closed = false; ///< periodic: parameters beyond an end come in again at the other one
};

namespace {

/// Newton steps on the squared distance from a start near the foot; the start's own point where they lead away.
Vec3 refined(const ExactEdge::Impl& edge, const Vec3& p, double t)
{
    const double first = edge.parameters.front(), last = edge.parameters.back();
    const double period = edge.closed ? last - first : 0;
    const auto gap_at = [&](double at) -> Vec3 { return vec(edge.curve->Value(at).XYZ()) - p; };
    gp_Pnt c;
    gp_Vec d1, d2;
    Vec3 gap = gap_at(t);
    for (int i = 0; i < 50; ++i) {
        edge.curve->D2(t, c, d1, d2);
        const double slope = gap.dot(vec(d1.XYZ())), speed = d1.SquareMagnitude();
        const double bend = speed + gap.dot(vec(d2.XYZ()));
        if (!(speed > 0)) {
            break;
        }
        double step = -slope / (bend > 1e-9 * speed ? bend : speed);
        double next = t;
        Vec3 next_gap = gap;
        for (int halving = 0; halving < 30; ++halving, step /= 2) {
            next = t + step;
            next = period > 0 ? first + std::fmod(std::fmod(next - first, period) + period, period)
                              : std::clamp(next, first, last);
            next_gap = gap_at(next);
            // Squared distances stop telling steps apart at the square root of rounding: equal ones are taken on trust.
            if (next_gap.squaredNorm() <= gap.squaredNorm() * (1 + 1e-13)) {
                break;
            }
        }
        if (!(next_gap.squaredNorm() <= gap.squaredNorm() * (1 + 1e-13))) {
            break;
        }
        const double moved = (next_gap - gap).norm();
        t = next;
        gap = next_gap;
        if (moved <= 1e-14 * (p.norm() + gap.norm())) {
            break;
        }
    }
    return gap + p;
}

} // namespace

ExactEdge::ExactEdge(const TopoDS_Edge& edge, std::vector<double> parameters)
{
    Impl impl;
    double first = 0, last = 0;
    impl.curve = BRep_Tool::Degenerated(edge) ? nullptr : BRep_Tool::Curve(edge, first, last);
    if (impl.curve.IsNull()) {
        const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
        if (!vertex.IsNull()) {
            impl.points.push_back(vec(BRep_Tool::Pnt(vertex).XYZ()));
        }
    } else {
        std::erase_if(parameters, [=](double t) { return t <= first || t >= last; });
        if (parameters.empty()) {
            constexpr int spans = 32;
            for (int i = 1; i < spans; ++i) {
                parameters.push_back(first + (last - first) * i / spans);
            }
        }
        parameters.insert(parameters.begin(), first);
        parameters.push_back(last);
        for (const double t : parameters) {
            impl.points.push_back(vec(impl.curve->Value(t).XYZ()));
        }
        impl.parameters = std::move(parameters);
        impl.closed = impl.curve->IsPeriodic() && std::abs(last - first - impl.curve->Period()) < 1e-9 * (last - first);
    }
    impl_ = std::make_unique<const Impl>(std::move(impl));
}

ExactEdge::ExactEdge(ExactEdge&&) noexcept = default;
ExactEdge::~ExactEdge() = default;

std::optional<Vec3> ExactEdge::closest(const Vec3& p) const
{
    const auto& points = impl_->points;
    if (points.empty()) {
        return std::nullopt;
    }
    if (points.size() == 1) {
        return points.front();
    }
    double best = std::numeric_limits<double>::infinity(), t = 0;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec3 along = points[i + 1] - points[i];
        const double s = share_of_segment(p, points[i], points[i + 1]);
        const double distance = (points[i] + s * along - p).squaredNorm();
        if (distance < best) {
            best = distance;
            t = impl_->parameters[i] + s * (impl_->parameters[i + 1] - impl_->parameters[i]);
        }
    }
    return refined(*impl_, p, t);
}

} // namespace tapeline
