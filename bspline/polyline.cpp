// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/polyline.h"

#include <cmath>
#include <fmt/format.h>

namespace tapeline::spline {

Result<Polyline> make_polyline(const std::vector<Vec3>& points, bool closed)
{
    Polyline line;
    line.closed = closed;
    Vec3 size = Vec3::Zero();
    for (size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite() || points[i].cwiseAbs().maxCoeff() > 1e100) {
            return fail(ErrorKind::rejected, fmt::format("point {} of the line is not finite", i));
        }
        size = size.cwiseMax((points[i] - points[0]).cwiseAbs());
    }
    const double equal = 1e-12 * size.norm();
    for (const Vec3& p : points) {
        if (line.points.empty() || (p - line.points.back()).norm() > equal) {
            line.points.push_back(p);
        }
    }
    while (closed && line.points.size() > 1 && (line.points.back() - line.points.front()).norm() <= equal) {
        line.points.pop_back();
    }
    const size_t needed = closed ? 3 : 2;
    if (line.points.size() < needed) {
        return fail(ErrorKind::rejected, fmt::format("a{} line needs at least {} different points, it has {}",
                                                     closed ? " closed" : "n open", needed, line.points.size()));
    }
    line.lengths.push_back(0);
    for (int e = 0; e < line.edges(); ++e) {
        line.lengths.push_back(line.lengths.back() + (line.end_of(e) - line.points[e]).norm());
    }
    const int n = static_cast<int>(line.points.size());
    line.bends.assign(n, 0.0);
    for (int i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
        const Vec3 a = line.points[(i + n - 1) % n], d = line.points[(i + 1) % n] - a;
        const Vec3 m = line.points[i] - a;
        line.bends[i] = d.norm() > equal ? (m - d * (m.dot(d) / d.squaredNorm())).norm() : m.norm();
    }
    return line;
}

double Polyline::sagitta() const
{
    double sum = 0;
    for (int e = 0; e < edges(); ++e) {
        const double bend = 0.5 * (bends[e] + bends[(e + 1) % points.size()]);
        sum += bend * (end_of(e) - points[e]).norm();
    }
    return 0.25 * sum / length(); // the chord over two edges is four times as high as over one
}

std::vector<EdgePoint> edge_points(const Polyline& line)
{
    std::vector<EdgePoint> result;
    for (int e = 0; e < line.edges(); ++e) {
        const double share = (line.lengths[e + 1] - line.lengths[e]) / line.length();
        const int inner = 2 * static_cast<int>(std::ceil(50 * share)) - 1; // odd, so that the middle is among them
        for (int i = 1; i <= inner; ++i) {
            const double f = static_cast<double>(i) / (inner + 1);
            result.push_back({e, (1 - f) * line.points[e] + f * line.end_of(e)});
        }
    }
    return result;
}

FitPoints fit_points(const Polyline& line, int spans, double tolerance_mm)
{
    FitPoints data;
    const double total = line.length(), longest = total / (4 * spans);
    const auto edge_length = [&](int e) { return line.lengths[e + 1] - line.lengths[e]; };
    const auto add = [&](const Vec3& p, double s, double weight) {
        data.points.push_back(p);
        data.parameters.push_back(s / total);
        data.weights.push_back(weight);
    };
    for (int e = 0; e < line.edges(); ++e) {
        const double before = e > 0 ? edge_length(e - 1) : line.closed ? edge_length(line.edges() - 1) : 0;
        add(line.points[e], line.lengths[e], 0.5 * (before + edge_length(e)));
        const int pieces = static_cast<int>(std::min(std::ceil(edge_length(e) / longest), 1e6));
        const double height = 0.5 * std::max(line.bends[e], line.bends[(e + 1) % line.points.size()]);
        const double trust = std::pow(tolerance_mm / (tolerance_mm + height), 2);
        for (int i = 1; i < pieces; ++i) {
            const double f = static_cast<double>(i) / pieces;
            add((1 - f) * line.points[e] + f * line.end_of(e), line.lengths[e] + f * edge_length(e),
                trust * edge_length(e) / pieces);
        }
    }
    add(line.end_of(line.edges() - 1), total, line.closed ? 0 : 0.5 * edge_length(line.edges() - 1));
    data.parameters.back() = 1;
    return data;
}

} // namespace tapeline::spline
