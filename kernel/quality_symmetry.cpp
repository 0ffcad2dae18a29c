// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/closest_point.h"
#include "kernel/parallel.h"
#include "kernel/quality_detail.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tapeline::quality {

namespace {

constexpr double relative_tolerance = 1e-6;
/// Vertices without a mirrored vertex may lie on a mirrored triangle instead (a cut for the extension need not be
/// symmetric), but only so many.
constexpr double loose_share = 0.1;

struct Mirror {
    Vec3 origin, normal;
    Vec3 operator()(const Vec3& p) const { return p - 2 * (p - origin).dot(normal) * normal; }
};

/// Planes that a symmetric shape is likely to have: through the bounding box's middle along the axes, and through the
/// vertices' centre along their principal axes.
std::vector<Mirror> candidates(const Positions& V)
{
    std::vector<Mirror> mirrors;
    const Vec3 middle = 0.5 * (V.colwise().minCoeff() + V.colwise().maxCoeff()).transpose();
    for (int k = 0; k < 3; ++k) {
        mirrors.push_back({middle, Vec3::Unit(k)});
    }
    const Vec3 centre = V.colwise().mean().transpose();
    const Positions centred = V.rowwise() - centre.transpose();
    const Eigen::Matrix3d moments = centred.transpose() * centred;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
    for (int k = 0; k < 3; ++k) {
        const Vec3 axis = axes.eigenvectors().col(k);
        const bool known = std::any_of(mirrors.begin(), mirrors.begin() + 3,
                                       [&](const Mirror& m) { return std::abs(m.normal.dot(axis)) > 1 - 1e-12; });
        if (!known) {
            mirrors.push_back({centre, axis});
        }
    }
    return mirrors;
}

/// Finds vertices by position: sorted along a direction in which few share a coordinate.
class VertexSearch {
public:
    explicit VertexSearch(const Positions& V) : V_(V), order_(V.rows()), keys_(V.rows())
    {
        const Eigen::VectorXd key = V * direction();
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(),
                  [&](int a, int b) { return std::pair(key[a], a) < std::pair(key[b], b); });
        std::transform(order_.begin(), order_.end(), keys_.begin(), [&](int v) { return key[v]; });
    }

    /// Nearest vertex to p within the tolerance; -1 when there is none.
    int find(const Vec3& p, double tolerance) const
    {
        const double key = p.dot(direction());
        int best = -1;
        double nearest = tolerance;
        for (auto i = std::lower_bound(keys_.begin(), keys_.end(), key - tolerance) - keys_.begin();
             i < static_cast<std::ptrdiff_t>(keys_.size()) && keys_[i] <= key + tolerance; ++i) {
            const double distance = (V_.row(order_[i]).transpose() - p).norm();
            if (distance <= nearest) {
                nearest = distance;
                best = order_[i];
            }
        }
        return best;
    }

private:
    static Vec3 direction() { return Vec3(0.5393, 0.7331, 0.4144).normalized(); }
    const Positions& V_;
    std::vector<int> order_;
    std::vector<double> keys_;
};

/// Whether the line as it was and as it should be are their own mirror images.
bool line_is_symmetric(const Context& context, const Mirror& mirror, const std::vector<int>& partner, double tolerance)
{
    return std::all_of(context.input.line.begin(), context.input.line.end(), [&](int v) {
        if (partner[v] < 0 || !context.on_line[partner[v]]) {
            return false;
        }
        const Vec3 image = mirror(context.moved.V.row(v));
        return context.input.target != nullptr ? context.input.target->foot(image).distance <= tolerance
                                               : (image - Vec3(context.moved.V.row(partner[v]))).norm() <= tolerance;
    });
}

/// Per vertex the vertex at its mirror image, -1 = none; empty when more than a few have none.
std::vector<int> partners(const Positions& V, const VertexSearch& search, const Mirror& mirror, double tolerance)
{
    const int count = static_cast<int>(V.rows());
    const auto missing_among = [&](int stride) {
        int missing = 0;
        for (int v = 0; v < count; v += stride) {
            missing += search.find(mirror(V.row(v)), tolerance) < 0;
        }
        return missing;
    };
    const int stride = std::max(1, count / 64);
    const int tried = 1 + (count - 1) / stride;
    if (missing_among(stride) > 0.3 * tried) {
        return {};
    }
    std::vector<int> partner(count);
    parallel_for(count, [&](int v) { partner[v] = search.find(mirror(V.row(v)), tolerance); });
    const auto missing = std::count(partner.begin(), partner.end(), -1);
    return static_cast<double>(missing) <= loose_share * count ? partner : std::vector<int>{};
}

/// Largest distance between a moved vertex's image and the moved place of its mirrored material point; negative when
/// the rest shape is not symmetric after all.
double residual(const Context& context, const Mirror& mirror, const std::vector<int>& partner, double tolerance)
{
    const int count = static_cast<int>(partner.size());
    const bool whole = std::count(partner.begin(), partner.end(), -1) == 0;
    const ClosestPoint surface =
        whole ? ClosestPoint(context.rest, std::span<const int>{}) : ClosestPoint(context.rest);
    constexpr double broken = -1;
    std::vector<double> distances(count);
    parallel_for(count, [&](int v) {
        const Vec3 image = mirror(context.moved.V.row(v));
        if (partner[v] >= 0) {
            distances[v] = (image - Vec3(context.moved.V.row(partner[v]))).norm();
            return;
        }
        const MeshFoot foot = surface.closest(mirror(context.rest.V.row(v)));
        if (foot.face < 0 || foot.distance > tolerance) {
            distances[v] = broken;
            return;
        }
        Vec3 there = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            there += foot.barycentric[k] * context.moved.V.row(context.moved.F(foot.face, k)).transpose();
        }
        distances[v] = (image - there).norm();
    });
    return *std::min_element(distances.begin(), distances.end()) < 0
               ? broken
               : *std::max_element(distances.begin(), distances.end());
}

} // namespace

std::optional<double> symmetry_residual(const Context& context)
{
    const Positions& V = context.rest.V;
    const double tolerance = relative_tolerance * bounding_diagonal(V);
    if (tolerance <= 0) {
        return {};
    }
    const VertexSearch search(V);
    std::optional<double> worst;
    for (const Mirror& mirror : candidates(V)) {
        const std::vector<int> partner = partners(V, search, mirror, tolerance);
        if (partner.empty() || !line_is_symmetric(context, mirror, partner, tolerance)) {
            continue;
        }
        const double found = residual(context, mirror, partner, tolerance);
        if (found >= 0) {
            worst = std::max(worst.value_or(0), found);
        }
    }
    return worst;
}

} // namespace tapeline::quality
