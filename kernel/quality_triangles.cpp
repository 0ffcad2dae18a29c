// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/quality_detail.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tapeline::quality {

namespace {

/// The rest line's edges, searched by distance with a box around every few of them.
class LineSearch {
public:
    explicit LineSearch(const Context& context) : context_(context)
    {
        for (int k = 0; k < context.line_edges(); ++k) {
            if (k % chunk == 0) {
                boxes_.emplace_back();
            }
            boxes_.back().extend(Vec3(context.rest.V.row(context.line_from(k))));
            boxes_.back().extend(Vec3(context.rest.V.row(context.line_to(k))));
        }
    }

    /// Direction (not normalised) of the line's edge nearest to p.
    Vec3 direction_near(const Vec3& p) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        Vec3 direction = Vec3::Zero();
        for (int b = 0; b < static_cast<int>(boxes_.size()); ++b) {
            if (boxes_[b].squaredExteriorDistance(p) >= nearest) {
                continue;
            }
            for (int k = b * chunk; k < std::min((b + 1) * chunk, context_.line_edges()); ++k) {
                const Vec3 a = context_.rest.V.row(context_.line_from(k));
                const Vec3 along = context_.rest.V.row(context_.line_to(k)).transpose() - a;
                const double t = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
                const double distance = (p - a - t * along).squaredNorm();
                if (distance < nearest) {
                    nearest = distance;
                    direction = along;
                }
            }
        }
        return direction;
    }

private:
    static constexpr int chunk = 12;
    const Context& context_;
    std::vector<Eigen::AlignedBox3d> boxes_;
};

/// Altitude on the line's direction, after / before. The direction in the rest triangle is that of the nearest edge of L0,
/// laid into its plane; in the moved triangle it is what the deformation makes of that direction, so at the line itself it
/// is Lt's, and a triangle that was not deformed has ratio 1. For an affine map the ratio is (area ratio) / (stretch along
/// the direction). Infinite where there is no such direction.
double altitude_ratio(const Context& context, const LineSearch& search, int t)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    const auto corner = [&](const Mesh& mesh, int k) { return Vec3(mesh.V.row(mesh.F(t, k))); };
    const Vec3 p = corner(context.rest, 0), n = context.rest_normals.row(t);
    const Vec3 e1 = corner(context.rest, 1) - p, e2 = corner(context.rest, 2) - p;
    Vec3 along = search.direction_near(p + (e1 + e2) / 3);
    const double whole = along.norm();
    along -= along.dot(n) * n;
    if (context.rest_areas[t] <= 0 || along.norm() < 1e-3 * whole || whole <= 0) {
        return none;
    }
    along.normalize();
    // Weights of the two edge vectors in `along`.
    const double twice_area = 2 * context.rest_areas[t];
    const double w1 = along.cross(e2).dot(n) / twice_area, w2 = e1.cross(along).dot(n) / twice_area;
    const Vec3 q = corner(context.moved, 0);
    const Vec3 image = w1 * (corner(context.moved, 1) - q) + w2 * (corner(context.moved, 2) - q);
    const double stretch = image.norm();
    const double area_ratio = context.moved_areas[t] / context.rest_areas[t];
    return stretch > 0 ? area_ratio / stretch : (area_ratio > 0 ? none : 0);
}

/// Turned over: on the compressed side against its own rest normal, on either side against its neighbours, when most of its
/// edges fold by more than 90° where the rest shape does not.
bool is_flipped(const Context& context, int t)
{
    const Vec3 now = context.moved_normals.row(t), was = context.rest_normals.row(t);
    if (context.side[t] == SideOf::compressed && now.dot(was) < 0) {
        return true;
    }
    int edges = 0, folded = 0;
    for (const int e : context.topology.face_edges(t)) {
        const int other = context.topology.face_across(t, e);
        if (other < 0) {
            continue;
        }
        ++edges;
        folded +=
            now.dot(Vec3(context.moved_normals.row(other))) < 0 && was.dot(Vec3(context.rest_normals.row(other))) > 0;
    }
    return folded > 0 && 2 * folded > edges;
}

} // namespace

void measure_triangles(const Context& context, QualityReport& report)
{
    struct Measure {
        double angle_before = 180, angle_after = 180, squash = 1, area_ratio = 1;
        bool flipped = false;
    };
    const LineSearch search(context);
    std::vector<Measure> measures(context.faces.size());
    parallel_for(static_cast<int>(measures.size()), [&](int i) {
        const int t = context.faces[i];
        Measure& m = measures[i];
        m.angle_before = triangle_min_angle(context.rest, t);
        m.angle_after = triangle_min_angle(context.moved, t);
        m.squash = altitude_ratio(context, search, t);
        m.area_ratio = context.rest_areas[t] > 0 ? context.moved_areas[t] / context.rest_areas[t] : 1;
        m.flipped = is_flipped(context, t);
    });
    constexpr double unset = std::numeric_limits<double>::infinity();
    Measure worst{180, 180, unset, unset, false};
    for (const Measure& m : measures) {
        worst.angle_before = std::min(worst.angle_before, m.angle_before);
        worst.angle_after = std::min(worst.angle_after, m.angle_after);
        worst.squash = std::min(worst.squash, m.squash);
        worst.area_ratio = std::min(worst.area_ratio, m.area_ratio);
        report.flipped += m.flipped;
    }
    report.min_angle_before = measures.empty() ? 0 : worst.angle_before;
    report.min_angle_after = measures.empty() ? 0 : worst.angle_after;
    report.squash = worst.squash == unset ? 1 : worst.squash;
    report.min_area_ratio = worst.area_ratio == unset ? 1 : worst.area_ratio;
}

} // namespace tapeline::quality
