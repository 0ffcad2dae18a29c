// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/quality_detail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::quality {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

double distance_to(const TargetCurve& target, const Vec3& p) { return target.foot(p).distance; }

} // namespace

void measure_line(const Context& context, QualityReport& report)
{
    const std::vector<int>& line = context.input.line;
    for (const int v : line) {
        report.slide_max_mm = std::max(report.slide_max_mm, (context.moved.V.row(v) - context.rest.V.row(v)).norm());
    }
    if (context.input.target == nullptr) {
        return;
    }
    const TargetCurve& target = *context.input.target;
    const int count = static_cast<int>(line.size()), edges = context.line_edges();
    std::vector<double> at_vertex(count), at_middle(edges);
    parallel_for(
        count, [&](int k) { at_vertex[k] = distance_to(target, context.moved.V.row(line[k])); }, 16);
    parallel_for(
        edges,
        [&](int k) {
            const Vec3 middle =
                0.5 * (context.moved.V.row(context.line_from(k)) + context.moved.V.row(context.line_to(k)));
            at_middle[k] = distance_to(target, middle);
        },
        16);
    report.line_error_max_mm = *std::max_element(at_vertex.begin(), at_vertex.end());
    report.chord_error_max_mm = *std::max_element(at_middle.begin(), at_middle.end());
}

void measure_creases(const Context& context, QualityReport& report)
{
    double length_before = 0, length_after = 0, sum_before = 0, sum_after = 0, squares = 0;
    for (int k = 0; k < context.line_edges(); ++k) {
        const int a = context.line_from(k), b = context.line_to(k);
        const int e = context.topology.find_edge(a, b);
        if (e < 0 || context.topology.edge(e).left < 0 || context.topology.edge(e).right < 0) {
            continue; // a border has no crease
        }
        const double before = degrees * dihedral(context.rest, context.topology, context.rest_normals, e);
        const double after = degrees * dihedral(context.moved, context.topology, context.moved_normals, e);
        const double was = (context.rest.V.row(b) - context.rest.V.row(a)).norm();
        const double is = (context.moved.V.row(b) - context.moved.V.row(a)).norm();
        // Signed angles, so that a ridge turned into a valley is a large difference.
        const double difference = std::abs(std::remainder(after - before, 360));
        length_before += was;
        length_after += is;
        sum_before += was * std::abs(before);
        sum_after += is * std::abs(after);
        squares += was * difference * difference;
        report.crease_max_difference = std::max(report.crease_max_difference, difference);
    }
    report.crease_before = length_before > 0 ? sum_before / length_before : 0;
    report.crease_after = length_after > 0 ? sum_after / length_after : 0;
    report.crease_rms_difference = length_before > 0 ? std::sqrt(squares / length_before) : 0;
}

namespace {

/// Change of the angle across edges: the mean by length at rest, and the largest [deg].
class AngleChange {
public:
    explicit AngleChange(const Context& context) : context_(context) {}

    void add(int e)
    {
        const MeshEdge& edge = context_.topology.edge(e);
        const double before = dihedral(context_.rest, context_.topology, context_.rest_normals, e);
        const double after = dihedral(context_.moved, context_.topology, context_.moved_normals, e);
        const double change = degrees * std::abs(std::remainder(after - before, 2 * std::numbers::pi));
        const double weight = (context_.rest.V.row(edge.b) - context_.rest.V.row(edge.a)).norm();
        length_ += weight;
        sum_ += weight * change;
        largest_ = std::max(largest_, change);
    }
    bool any() const { return length_ > 0; }
    double mean() const { return length_ > 0 ? sum_ / length_ : 0; }
    double largest() const { return largest_; }

private:
    const Context& context_;
    double length_ = 0, sum_ = 0, largest_ = 0;
};

} // namespace

void measure_rim(const Context& context, QualityReport& report)
{
    AngleChange change(context);
    for (int e = 0; e < context.topology.edge_count(); ++e) {
        const MeshEdge& edge = context.topology.edge(e);
        if (edge.left >= 0 && edge.right >= 0 &&
            (context.side[edge.left] == SideOf::none) != (context.side[edge.right] == SideOf::none)) {
            change.add(e);
        }
    }
    report.rim_crease_mean_change = change.mean();
    report.rim_crease_max_change = change.largest();
}

void measure_extension(const Context& context, QualityReport& report)
{
    const std::vector<int>& line = context.input.extended_line;
    AngleChange change(context);
    for (size_t k = 1; k < line.size(); ++k) {
        const int e = context.topology.find_edge(line[k - 1], line[k]);
        const bool used = context.on_line[line[k - 1]] && context.on_line[line[k]];
        if (e >= 0 && !used && !context.topology.edge(e).border()) {
            change.add(e);
        }
    }
    if (change.any()) {
        report.extension_crease_mean_change = change.mean();
        report.extension_crease_max_change = change.largest();
    }
}

} // namespace tapeline::quality
