// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/crease_ring.h"

#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace tapeline {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
/// The angle that a triangle of the ring may miss where one vertex serves several edges [rad].
constexpr double may_miss = 0.2 / degrees;
/// How far such a vertex may go for it, as a share of its height over the edge.
constexpr double may_shift = 0.35;

/// A line edge, as carried and as wanted, with the normal that this side has and shall have there.
struct RingEdge {
    size_t from = 0, to = 0; ///< entries of the line
    int apex = -1;
    Vec3 normal_before = Vec3::Zero(), normal_after = Vec3::Zero();
    Vec3 along_before = Vec3::Zero(), along_after = Vec3::Zero();
};

/// What one edge asks of the vertex opposite to it: to lie in a plane, near a place, `height` away from the edge.
struct Wish {
    Vec3 place = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double height = 0;
};

/// One place for a vertex that has several edges: as near to the mean of its wishes as the angles allow. Planes of
/// edges that turn little meet far away, so the pull towards them grows only until no angle is missed by too much.
Vec3 reconcile(const std::vector<Wish>& wishes)
{
    Vec3 mean = Vec3::Zero();
    for (const Wish& wish : wishes) {
        mean += wish.place / static_cast<double>(wishes.size());
    }
    double height = std::numeric_limits<double>::infinity();
    for (const Wish& wish : wishes) {
        height = std::min(height, wish.height);
    }
    Vec3 place = mean;
    constexpr int attempts = 79; // up to a pull of about 1e9
    double pull = 1;
    for (int attempt = 0; attempt < attempts; ++attempt, pull *= 1.3) {
        double missed = 0;
        Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
        Vec3 b = Vec3::Zero();
        for (const Wish& wish : wishes) {
            missed = std::max(missed, std::abs(wish.normal.dot(place - wish.place)) / wish.height);
            A += pull * wish.normal * wish.normal.transpose();
            b += pull * wish.normal.dot(wish.place - mean) * wish.normal;
        }
        if (missed <= may_miss) {
            break;
        }
        const Vec3 next = mean + A.inverse() * b;
        if ((next - mean).norm() > may_shift * height) {
            break;
        }
        place = next;
    }
    return place;
}

/// Columns: along, across (in the plane), normal.
Eigen::Matrix3d frame(const Vec3& along, const Vec3& normal)
{
    Eigen::Matrix3d columns;
    columns.col(2) = normal.normalized();
    columns.col(0) = (along - columns.col(2) * columns.col(2).dot(along)).normalized();
    columns.col(1) = columns.col(2).cross(columns.col(0));
    return columns;
}

std::vector<RingEdge> ring_edges(const SideMesh& side, const Positions& carried, bool closed,
                                 const std::vector<Vec3>& line, const std::vector<Vec3>& normals, bool left)
{
    const Mesh inner = side.own_mesh(carried);
    const Topology topology(inner.F, static_cast<int>(inner.V.rows()));
    std::vector<RingEdge> edges;
    const size_t n = side.line.size();
    for (size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
        RingEdge edge{.from = i, .to = (i + 1) % n};
        const int a = side.line[edge.from], b = side.line[edge.to];
        const int t = left ? topology.face_left_of(a, b) : topology.face_left_of(b, a);
        if (t < 0 || normals[i].isZero(0)) {
            continue;
        }
        edge.apex = inner.F.row(t).sum() - a - b;
        edge.normal_before = triangle_normal(inner, t);
        edge.along_before = (carried.row(b) - carried.row(a)).normalized();
        edge.along_after = (line[edge.to] - line[edge.from]).normalized();
        edge.normal_after = normals[i];
        edges.push_back(edge);
    }
    return edges;
}

/// Sums of normals and directions at each entry of the line, as carried and as wanted.
struct LineFrames {
    std::vector<Vec3> normals[2], alongs[2];
    LineFrames(size_t count, const std::vector<RingEdge>& edges)
    {
        for (int k = 0; k < 2; ++k) {
            normals[k].assign(count, Vec3::Zero());
            alongs[k].assign(count, Vec3::Zero());
        }
        for (const RingEdge& edge : edges) {
            for (const size_t i : {edge.from, edge.to}) {
                normals[0][i] += edge.normal_before;
                normals[1][i] += edge.normal_after;
                alongs[0][i] += edge.along_before;
                alongs[1][i] += edge.along_after;
            }
        }
    }
    Eigen::Matrix3d turn(size_t i) const
    {
        return frame(alongs[1][i], normals[1][i]) * frame(alongs[0][i], normals[0][i]).transpose();
    }
};

} // namespace

CreaseRing crease_ring(const SideMesh& side, const Positions& carried, bool closed, const std::vector<Vec3>& line,
                       const std::vector<Vec3>& normals, bool left)
{
    const std::vector<RingEdge> edges = ring_edges(side, carried, closed, line, normals, left);
    const LineFrames frames(side.line.size(), edges);
    std::vector<int> entry(carried.rows(), -1);
    std::vector<char> held(carried.rows(), 0);
    const size_t n = side.line.size();
    for (size_t i = 0; i < n; ++i) {
        held[side.line[i]] = 1;
        const bool first = i == 0 && !closed, last = i + 1 == n && !closed;
        const bool free = (!first && normals[(i + n - 1) % n].isZero(0)) || (!last && normals[i].isZero(0));
        entry[side.line[i]] = free ? -1 : static_cast<int>(i);
    }
    for (const std::vector<int>* list : {&side.fixed, &side.guided}) {
        for (const int v : *list) {
            held[v] = 1;
        }
    }
    const Topology topology(side.mesh.F.topRows(side.inner_faces), static_cast<int>(carried.rows()));
    std::map<int, std::vector<Vec3>> places;
    for (const MeshEdge& edge : topology.edges()) {
        for (const auto& [on, off] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
            if (entry[on] >= 0 && !held[off] && !frames.normals[0][entry[on]].isZero(0)) {
                const Vec3 arm = carried.row(off) - carried.row(on);
                places[off].push_back(line[entry[on]] + frames.turn(entry[on]) * arm);
            }
        }
    }
    std::map<int, std::vector<Wish>> wishes;
    for (const RingEdge& edge : edges) {
        if (places.contains(edge.apex)) {
            const Vec3 arm = carried.row(edge.apex) - carried.row(side.line[edge.from]);
            const Vec3 across = arm - edge.along_before * edge.along_before.dot(arm);
            const double share = edge.along_before.dot(arm) /
                                 (carried.row(side.line[edge.to]) - carried.row(side.line[edge.from])).norm();
            const Vec3 foot = line[edge.from] + share * (line[edge.to] - line[edge.from]);
            const Vec3 into = (left ? 1 : -1) * edge.normal_after.cross(edge.along_after);
            wishes[edge.apex].push_back({foot + across.norm() * into, edge.normal_after, across.norm()});
        }
    }
    CreaseRing ring;
    for (const auto& [v, wanted] : places) {
        Vec3 mean = Vec3::Zero();
        for (const Vec3& place : wanted) {
            mean += place / static_cast<double>(wanted.size());
        }
        const auto own = wishes.find(v);
        ring.vertices.push_back(v);
        ring.targets.push_back(own == wishes.end() ? mean : reconcile(own->second));
    }
    return ring;
}

} // namespace tapeline
