// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/join.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

/// The curves as a graph: nodes are places where ends meet.
struct EndGraph {
    std::vector<int> node;              ///< of curve end 2 i (first point) and 2 i + 1 (last point)
    std::vector<Vec3> place;            ///< per node
    std::vector<std::vector<int>> ends; ///< per node the curve ends there, ascending
};

const Vec3& end_point(const std::vector<BSplineData>& curves, int end)
{
    const auto& points = curves[end / 2].control_points;
    return end % 2 == 0 ? points.front() : points.back();
}

EndGraph make_graph(const std::vector<BSplineData>& curves, double tolerance_mm)
{
    EndGraph graph;
    for (int end = 0; end < static_cast<int>(2 * curves.size()); ++end) {
        const Vec3& p = end_point(curves, end);
        const auto known = std::ranges::find_if(
            graph.ends, [&](const auto& ends) { return (end_point(curves, ends.front()) - p).norm() <= tolerance_mm; });
        const int node = static_cast<int>(known - graph.ends.begin());
        if (known == graph.ends.end()) {
            graph.ends.emplace_back();
        }
        graph.ends[node].push_back(end);
        graph.node.push_back(node);
    }
    for (const auto& ends : graph.ends) {
        Vec3 sum = Vec3::Zero();
        for (const int end : ends) {
            sum += end_point(curves, end);
        }
        graph.place.push_back(sum / static_cast<double>(ends.size()));
    }
    return graph;
}

/// Number of connected parts.
int count_parts(const EndGraph& graph, int curves)
{
    std::vector<int> part(graph.ends.size());
    std::iota(part.begin(), part.end(), 0);
    const auto root = [&](int i) {
        while (part[i] != i) {
            i = part[i] = part[part[i]];
        }
        return i;
    };
    int parts = static_cast<int>(graph.ends.size());
    for (int i = 0; i < curves; ++i) {
        const int a = root(graph.node[2 * i]), b = root(graph.node[2 * i + 1]);
        parts -= a != b ? 1 : 0;
        part[a] = b;
    }
    return parts;
}

/// Curve ends in the order of the walk: each entry is the end by which a curve is entered.
std::vector<int> walk(const EndGraph& graph, int curves)
{
    const auto single = std::ranges::find_if(graph.ends, [](const auto& ends) { return ends.size() == 1; });
    std::vector<int> order;
    int entry = single == graph.ends.end() ? 0 : single->front();
    while (static_cast<int>(order.size()) < curves) {
        order.push_back(entry);
        const int exit = entry ^ 1;
        for (const int end : graph.ends[graph.node[exit]]) {
            if (end != exit) {
                entry = end;
            }
        }
    }
    // The first curve gives the sense.
    const auto first = std::ranges::find_if(order, [](int end) { return end / 2 == 0; });
    if (*first == 1) {
        std::ranges::reverse(order);
        std::ranges::transform(order, order.begin(), [](int end) { return end ^ 1; });
    }
    // A closed line begins with the first curve.
    if (single == graph.ends.end()) {
        std::rotate(order.begin(), std::ranges::find_if(order, [](int end) { return end / 2 == 0; }), order.end());
    }
    return order;
}

void reverse(BSplineData& curve)
{
    std::ranges::reverse(curve.control_points);
    std::ranges::reverse(curve.weights);
    std::ranges::reverse(curve.knots);
    std::ranges::transform(curve.knots, curve.knots.begin(), [](double u) { return -u; });
}

/// Appends a clamped curve: its parameters follow on, scaled to its arc length, its weights to meet at the joint.
Result<void> append(BSplineData& chain, const BSplineData& curve)
{
    const auto line = TargetLine::from_data(curve);
    if (!line) {
        return tl::unexpected(line.error());
    }
    const double start = chain.knots.empty() ? 0 : chain.knots.back();
    const double scale = line->length() / (curve.knots.back() - curve.knots.front());
    const double weight = chain.weights.empty() ? 1 : chain.weights.back() / curve.weights.front();
    const size_t shared = chain.knots.empty() ? 0 : 1;
    if (shared) {
        chain.knots.pop_back();
    }
    for (size_t i = shared ? curve.degree + 1 : 0; i < curve.knots.size(); ++i) {
        chain.knots.push_back(start + scale * (curve.knots[i] - curve.knots.front()));
    }
    for (size_t i = shared; i < curve.control_points.size(); ++i) {
        chain.control_points.push_back(curve.control_points[i]);
        chain.weights.push_back(weight * curve.weights[i]);
    }
    return {};
}

} // namespace

Result<TargetLine> join_lines(const std::vector<BSplineData>& curves, double tolerance_mm)
{
    const int n = static_cast<int>(curves.size());
    const auto rejected = [](std::string message) { return fail(ErrorKind::rejected, std::move(message)); };
    if (curves.empty()) {
        return rejected("there is no curve");
    }
    std::vector<BSplineData> clamped;
    for (const BSplineData& curve : curves) {
        BSplineData open = curve;
        open.closed = false;
        auto line = TargetLine::from_data(open);
        if (!line) {
            return line;
        }
        clamped.push_back(line->data());
        if (clamped.back().degree != clamped.front().degree) {
            return rejected("the curves have different degrees");
        }
        clamped.back().weights.resize(clamped.back().control_points.size(), 1.0);
    }
    const EndGraph graph = make_graph(clamped, tolerance_mm);
    if (const int parts = count_parts(graph, n); parts > 1) {
        return rejected(
            fmt::format("its curves form {} separate lines, a target is one: leave one of them in the file, "
                        "or close the gaps between them",
                        parts));
    }
    for (size_t i = 0; i < graph.ends.size(); ++i) {
        if (graph.ends[i].size() > 2) {
            const Vec3& p = graph.place[i];
            return rejected(fmt::format("its curves branch at ({:.6g}, {:.6g}, {:.6g}), where {} ends meet: leave one "
                                        "line in the file",
                                        p.x(), p.y(), p.z(), graph.ends[i].size()));
        }
    }
    BSplineData chain;
    chain.degree = clamped.front().degree;
    const std::vector<int> order = walk(graph, n);
    for (const int entry : order) {
        BSplineData& curve = clamped[entry / 2];
        if (entry % 2 == 1) {
            reverse(curve);
        }
        curve.control_points.front() = graph.place[graph.node[entry]];
        curve.control_points.back() = graph.place[graph.node[entry ^ 1]];
        if (const auto appended = append(chain, curve); !appended) {
            return tl::unexpected(appended.error());
        }
    }
    chain.closed = graph.node[order.front()] == graph.node[order.back() ^ 1];
    if (std::ranges::all_of(chain.weights, [&](double w) { return w == chain.weights.front(); })) {
        chain.weights.clear();
    }
    if (n == 1) { // nothing was joined: the curve as it came
        const BSplineData& only = clamped.front();
        chain.knots = order.front() == 0 ? only.knots : chain.knots;
    }
    return TargetLine::from_data(chain);
}

} // namespace tapeline
