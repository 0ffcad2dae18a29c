// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/crease.h"

#include "kernel/topology.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <optional>

namespace tapeline {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
/// Angles that agree to this are the same [deg].
constexpr double same_angle = 1e-7;
/// Planes of two edges that are more nearly parallel than this (as a singular value) count as one plane.
constexpr double same_plane = 0.05;

/// A used edge of the line with this side's triangle beside it.
struct LineEdge {
    int a = -1, b = -1; ///< local vertices, in the line's direction
    int apex = -1;      ///< third corner of the triangle
    double sign = 1;    ///< +1 when the triangle runs a→b
    Vec3 other_normal = Vec3::Zero();
    double wanted = 0; ///< [rad]
};

/// What one edge asks of its apex: to lie in a plane, near a place, `height` away from the edge.
struct Wish {
    Vec3 place = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double height = 0;
};

Vec3 row(const Positions& V, int v) { return V.row(v); }

Vec3 normal_of(const Positions& V, const LineEdge& edge)
{
    const Vec3 n = (row(V, edge.b) - row(V, edge.a)).cross(row(V, edge.apex) - row(V, edge.a));
    return n.norm() > 0 ? Vec3(edge.sign * n.normalized()) : Vec3::Zero();
}

/// Angle from the other side's normal to this side's about the edge, without full turns [rad].
double missing_angle(const Positions& V, const LineEdge& edge)
{
    const Vec3 along = (row(V, edge.b) - row(V, edge.a)).normalized();
    const Vec3 n = normal_of(V, edge);
    const double now = std::atan2(edge.other_normal.cross(n).dot(along), edge.other_normal.dot(n));
    return std::remainder(edge.wanted - now, 2 * std::numbers::pi);
}

Result<std::vector<LineEdge>> used_edges(const SideMesh& side, int first, int last,
                                         const std::vector<Vec3>& other_normals, const std::vector<double>& rest_angles)
{
    const int n = static_cast<int>(side.line.size());
    const int count = static_cast<int>(rest_angles.size());
    const bool closed = first == 0 && last == n - 1 && count == n && n > 2;
    if (first < 0 || last >= n || first >= last || rest_angles.size() != other_normals.size() ||
        (!closed && count != last - first)) {
        return fail(ErrorKind::usage,
                    fmt::format("{} crease angles and {} normals were given for entries {} to {} of a "
                                "line of {} vertices",
                                count, other_normals.size(), first, last, n));
    }
    const Topology topology(side.mesh.F.topRows(side.inner_faces), static_cast<int>(side.mesh.V.rows()));
    std::vector<LineEdge> edges;
    for (int i = 0; i < count; ++i) {
        LineEdge edge;
        edge.a = side.line[first + i];
        edge.b = side.line[(first + i + 1) % n];
        const int left = topology.face_left_of(edge.a, edge.b);
        const int t = left >= 0 ? left : topology.face_left_of(edge.b, edge.a);
        if (t < 0) {
            return fail(ErrorKind::usage,
                        fmt::format("no triangle of the side lies on the line between its entries {} and {}", first + i,
                                    (first + i + 1) % n));
        }
        edge.apex = side.mesh.F.row(t).sum() - edge.a - edge.b;
        edge.sign = left >= 0 ? 1 : -1;
        edge.other_normal = other_normals[i];
        edge.wanted = rest_angles[i] / degrees;
        if (!edge.other_normal.allFinite() || !std::isfinite(edge.wanted)) {
            return fail(ErrorKind::usage,
                        fmt::format("the crease angle or normal of line edge {} is not a number", first + i));
        }
        edges.push_back(edge);
    }
    return edges;
}

/// The apex turned about its edge until the angle is the wanted one.
Wish wish_of(const Positions& V, const LineEdge& edge)
{
    const Vec3 a = row(V, edge.a), arm = row(V, edge.apex) - a;
    const Vec3 along = (row(V, edge.b) - a).normalized();
    const Eigen::AngleAxisd turn(missing_angle(V, edge), along);
    return {a + turn * arm, turn * normal_of(V, edge), (arm - along * along.dot(arm)).norm()};
}

/// One place for an apex with several edges: the mean of its wishes, moved as little as possible to where the edges'
/// planes are met best, in the sense of least squares of the angles.
Vec3 reconciled(const std::vector<Wish>& wishes)
{
    Vec3 mean = Vec3::Zero();
    for (const Wish& wish : wishes) {
        mean += wish.place / static_cast<double>(wishes.size());
    }
    double height = 0;
    for (const Wish& wish : wishes) {
        height = std::max(height, wish.height);
    }
    if (wishes.size() < 2 || !(height > 0)) {
        return mean;
    }
    Eigen::MatrixXd N(wishes.size(), 3);
    Eigen::VectorXd off(wishes.size());
    for (size_t k = 0; k < wishes.size(); ++k) {
        const double weight = height / std::max(wishes[k].height, 1e-3 * height);
        N.row(static_cast<Eigen::Index>(k)) = weight * wishes[k].normal;
        off[static_cast<Eigen::Index>(k)] = weight * wishes[k].normal.dot(wishes[k].place - mean);
    }
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(N, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(same_plane);
    return mean + svd.solve(off);
}

/// Root mean square of what is missing, over the edges whose apex may move [deg].
double missing_rms(const Positions& V, const std::vector<LineEdge>& edges, const std::vector<char>& held)
{
    double sum = 0;
    int count = 0;
    for (const LineEdge& edge : edges) {
        if (!held[edge.apex]) {
            sum += std::pow(missing_angle(V, edge) * degrees, 2);
            ++count;
        }
    }
    return count == 0 ? 0 : std::sqrt(sum / count);
}

Result<DeformationResult> bend(const SideMesh& side, const Positions& V, const std::vector<LineEdge>& edges,
                               const std::vector<char>& held, const DeformationOptions& options)
{
    std::map<int, std::vector<Wish>> wishes;
    for (const LineEdge& edge : edges) {
        if (!held[edge.apex]) {
            wishes[edge.apex].push_back(wish_of(V, edge));
        }
    }
    std::vector<int> constrained;
    for (int v = 0; v < static_cast<int>(held.size()); ++v) {
        if (held[v] || wishes.contains(v)) {
            constrained.push_back(v);
        }
    }
    Positions targets(static_cast<Eigen::Index>(constrained.size()), 3);
    for (size_t i = 0; i < constrained.size(); ++i) {
        const auto wish = wishes.find(constrained[i]);
        targets.row(static_cast<Eigen::Index>(i)) =
            wish == wishes.end() ? row(V, constrained[i]) : reconciled(wish->second);
    }
    return deform(Mesh{V, side.mesh.F}, constrained, targets, options);
}

} // namespace

Result<DeformationResult> restore_crease(const SideMesh& side, const Positions& V, int first, int last,
                                         const std::vector<Vec3>& other_normals, const std::vector<double>& rest_angles,
                                         const DeformationOptions& options)
{
    try {
        const auto edges = used_edges(side, first, last, other_normals, rest_angles);
        if (!edges) {
            return tl::unexpected(edges.error());
        }
        std::vector<char> held(V.rows(), 0);
        for (const std::vector<int>* list : {&side.line, &side.fixed, &side.guided}) {
            for (const int v : *list) {
                held[v] = 1;
            }
        }
        DeformationResult result;
        result.V = V;
        result.converged = true;
        if (missing_rms(V, *edges, held) < same_angle) {
            return result;
        }
        return bend(side, V, *edges, held, options);
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("the crease restoration failed: {}", e.what()));
    }
}

} // namespace tapeline
