// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/exact_edge.h"

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <limits>

namespace tapeline
{

namespace
{

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

} // namespace

struct ExactEdge::Impl {
    Handle(Geom_Curve) curve; ///< null for a degenerated edge, which is one point
    std::vector<double> parameters;
    std::vector<Vec3> points;
};

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
    size_t span = 0;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec3 along = points[i + 1] - points[i];
        const double square = along.squaredNorm();
        const double s = square > 0 ? std::clamp((p - points[i]).dot(along) / square, 0.0, 1.0) : 0;
        const double distance = (points[i] + s * along - p).squaredNorm();
        if (distance < best) {
            best = distance;
            span = i;
            t = impl_->parameters[i] + s * (impl_->parameters[i + 1] - impl_->parameters[i]);
        }
    }
    // The foot lies in this span or, by the chord's error, in a neighbour.
    const double low = impl_->parameters[span == 0 ? 0 : span - 1];
    const double high = impl_->parameters[std::min(span + 2, points.size() - 1)];
    gp_Pnt c;
    gp_Vec d1, d2;
    double at = t, distance = std::numeric_limits<double>::infinity();
    Vec3 result = points[span];
    for (int i = 0; i < 30; ++i) {
        impl_->curve->D2(at, c, d1, d2);
        const Vec3 gap = vec(c.XYZ()) - p;
        if (!(gap.squaredNorm() < distance)) {
            break;
        }
        distance = gap.squaredNorm();
        result = vec(c.XYZ());
        const double slope = gap.dot(vec(d1.XYZ())), speed = d1.SquareMagnitude();
        double bend = speed + gap.dot(vec(d2.XYZ()));
        bend = bend > 0.1 * speed ? bend : speed;
        if (!(speed > 0)) {
            break;
        }
        at = std::clamp(at - slope / bend, low, high);
    }
    return result;
}

} // namespace tapeline
