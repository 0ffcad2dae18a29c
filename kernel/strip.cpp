// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/strip.h"

#include "kernel/geodesic_distance.h"
#include "kernel/line_tangents.h"
#include "kernel/median.h"
#include "kernel/parallel.h"
#include "kernel/quality.h"
#include "kernel/segment.h"
#include "kernel/sliding.h"
#include "kernel/strip_fit.h"
#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace tapeline {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int most_stations = 48, samples = 160;
/// The side is looked at over at most this share of the line's length.
constexpr double farthest = 0.5;
/// What is carried beside the bend, so that the carried piece ends in the smooth part of the side [of the bend's width].
constexpr double margin = 0.25;
/// A strip ends at an edge that turns the surface by more than this [deg].
constexpr double sharp = 40;

/// Where a path across the side starts: the middle of a line edge.
struct Station {
    double entry = 0; ///< its place in the line, between the edge's entries
    MeshPoint from;
    Vec3 start = Vec3::Zero(), along = Vec3::Zero(), normal = Vec3::Zero(), across = Vec3::Zero();
};

std::vector<Station> stations(const Mesh& side, const Topology& topology, const std::vector<int>& line, bool closed)
{
    std::vector<Station> all;
    for (size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
        const int a = line[i], b = line[(i + 1) % line.size()], e = topology.find_edge(a, b);
        if (e < 0 || !topology.edge(e).border()) {
            continue;
        }
        Station station;
        station.entry = static_cast<double>(i) + 0.5;
        const int t = std::max(topology.edge(e).left, topology.edge(e).right);
        station.from.face = t;
        for (int k = 0; k < 3; ++k) {
            station.from.barycentric[k] = side.F(t, k) == a || side.F(t, k) == b ? 0.5 : 0;
        }
        const Vec3 p = side.V.row(a), q = side.V.row(b), r = side.V.row(side.F.row(t).sum() - a - b);
        station.start = 0.5 * (p + q);
        station.along = (q - p).normalized();
        station.normal = triangle_normal(side, t);
        const Vec3 arm = r - p;
        station.across = (arm - station.along * station.along.dot(arm)).normalized();
        all.push_back(station);
    }
    const size_t n = all.size(), few = std::min<size_t>(n, most_stations);
    for (size_t i = 0; i < few; ++i) {
        all[i] = all[(2 * i + 1) * n / (2 * few)];
    }
    all.resize(few);
    return all;
}

/// What of the side is reached from the line without crossing an edge so sharp that no fillet is tessellated with it.
Mesh smooth_part(const Mesh& side, const Topology& topology, const std::vector<int>& line)
{
    std::vector<char> on_line(side.V.rows(), 0), reached(side.F.rows(), 0);
    for (const int v : line) {
        on_line[v] = 1;
    }
    std::vector<int> front;
    for (const MeshEdge& edge : topology.edges()) {
        if (edge.border() && on_line[edge.a] && on_line[edge.b]) {
            front.push_back(std::max(edge.left, edge.right));
            reached[front.back()] = 1;
        }
    }
    const double smooth = std::cos(sharp * degree);
    for (size_t i = 0; i < front.size(); ++i) {
        const Vec3 normal = triangle_normal(side, front[i]);
        for (const int e : topology.face_edges(front[i])) {
            const int next = topology.face_across(front[i], e);
            if (next >= 0 && !reached[next] && normal.dot(triangle_normal(side, next)) > smooth) {
                reached[next] = 1;
                front.push_back(next);
            }
        }
    }
    std::ranges::sort(front);
    return {side.V, side.F(front, Eigen::all)};
}

Vec3 normal_at(const Mesh& side, const Positions& normals, const MeshPoint& at)
{
    Vec3 normal = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        normal += at.barycentric[k] * Vec3(normals.row(side.F(at.face, k)));
    }
    return normal;
}

/// Per station the turn of the normal about the line at each distance, relative to the line [rad].
std::vector<std::vector<double>> profiles(const Mesh& side, const Topology& topology, const std::vector<Station>& all,
                                          const std::vector<double>& distances)
{
    const Positions normals = vertex_normals(side);
    std::vector<std::vector<double>> result(all.size(), std::vector<double>(distances.size(), 0));
    parallel_for(static_cast<int>(all.size()), [&](int i) {
        const Station& s = all[i];
        const Vec3 first = normal_at(side, normals, s.from), other = s.along.cross(first);
        double last = 0;
        for (size_t k = 0; k < distances.size(); ++k) {
            const Vec3 n = normal_at(side, normals, slide(side, topology, s.from, s.normal, distances[k] * s.across));
            const double angle = std::atan2(n.dot(other), n.dot(first));
            last += std::remainder(angle - last, 2 * std::numbers::pi); // round and round
            result[i][k] = last;
        }
    });
    return result;
}

/// The share of the stations that turn through at least half of the bend.
double share_bent(const std::vector<double>& d, const std::vector<std::vector<double>>& all, const BendFit& fit)
{
    const auto k =
        std::min(static_cast<size_t>(std::ranges::lower_bound(d, (1 + margin) * fit.width) - d.begin()), d.size() - 1);
    const auto bent = std::ranges::count_if(
        all, [&](const std::vector<double>& tau) { return tau[k] / (fit.inner * fit.width) >= 0.5; });
    return static_cast<double>(bent) / static_cast<double>(all.size());
}

/// The value beside x of something known at the polyline's points.
double value_beside(const std::vector<Vec3>& points, bool closed, const std::vector<double>& values, const Vec3& x)
{
    double least = std::numeric_limits<double>::infinity(), value = values.front();
    for (size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
        const size_t j = (i + 1) % points.size();
        const double share = share_of_segment(x, points[i], points[j]);
        if (const double d = (x - points[i] - share * (points[j] - points[i])).squaredNorm(); d < least) {
            least = d;
            value = std::lerp(values[i], values[j], share);
        }
    }
    return value;
}

/// The value there of something known at the stations; `period` entries make the loop of a closed line, 0 = open.
double at_entry(const std::vector<Station>& all, const std::vector<double>& values, double entry, size_t period)
{
    const auto above = std::ranges::upper_bound(all, entry, {}, &Station::entry) - all.begin();
    const auto n = static_cast<std::ptrdiff_t>(all.size()), before = above - 1;
    if (period == 0 && (before < 0 || above == n)) {
        return values[std::clamp<std::ptrdiff_t>(before, 0, n - 1)];
    }
    const auto place = [&](std::ptrdiff_t i) {
        const std::ptrdiff_t round = i < 0 ? -1 : (i == n ? 1 : 0);
        return all[(i + n) % n].entry + static_cast<double>(round) * static_cast<double>(period);
    };
    const double share = (entry - place(before)) / (place(above) - place(before));
    return std::lerp(values[(before + n) % n], values[above % n], share);
}

} // namespace

Strip find_strip(const Mesh& beside, const std::vector<int>& line, bool closed, const StripOptions& options)
{
    const Mesh side = smooth_part(beside, Topology(beside.F, static_cast<int>(beside.V.rows())), line);
    const Topology topology(side.F, static_cast<int>(side.V.rows()));
    const std::vector<Station> all = stations(side, topology, line, closed);
    const double length = line_length(side.V, line, closed);
    std::vector<double> reaches;
    for (const Station& s : all) {
        const MeshPoint end = slide(side, topology, s.from, s.normal, farthest * length * s.across);
        reaches.push_back((position_of(side, end) - s.start).norm());
    }
    const double reach = reaches.empty() ? 0 : median(reaches);
    if (!(reach > 0)) {
        return {};
    }
    std::vector<double> distances;
    for (int k = 0; k <= samples; ++k) {
        distances.push_back(reach * k * k / (samples * samples)); // densest beside the line
    }
    const auto each = profiles(side, topology, all, distances);
    const BendFit best = best_bend(distances, median_profile(each), {0, reach}, options);
    constexpr double most = 0.7;
    if (!best.found() || share_bent(distances, each, best) < most) {
        return {};
    }
    Strip strip{best.width, (1 + margin) * best.width, std::abs(best.inner) * best.width / degree,
                1 / std::abs(best.inner)};
    const std::vector<double> local = widths_along(distances, each, closed, best, options);
    for (size_t i = 0; i < line.size() && !local.empty(); ++i) {
        strip.widths.push_back(at_entry(all, local, static_cast<double>(i), closed ? line.size() : 0));
    }
    return strip;
}

std::vector<double> Strip::carried(size_t entries, double share) const
{
    std::vector<double> result(entries, share * carried_mm);
    for (size_t i = 0; i < entries && !widths.empty(); ++i) {
        result[i] = share * widths[i] * carried_mm / width_mm;
    }
    return result;
}

std::pair<Mesh, Mesh> meshes_beside(const Mesh& mesh, const std::vector<int>& line, bool closed)
{
    std::vector<int> faces(mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    const auto sides = sides_of_line(mesh, faces, line, closed);
    const auto part = [&](const std::vector<int>& list) {
        Mesh side{mesh.V, Triangles(static_cast<Eigen::Index>(list.size()), 3)};
        for (size_t i = 0; i < list.size(); ++i) {
            side.F.row(static_cast<Eigen::Index>(i)) = mesh.F.row(list[i]);
        }
        return side;
    };
    return {part(sides.first), part(sides.second)};
}

std::vector<int> strip_vertices(const Mesh& side, const std::vector<int>& line, bool closed,
                                const std::vector<double>& widths_mm)
{
    const double widest = widths_mm.empty() ? 0 : *std::ranges::max_element(widths_mm);
    std::vector<Vec3> points;
    std::vector<DistanceSeed> seeds;
    std::vector<char> out(side.V.rows(), 0);
    for (const int v : line) {
        seeds.push_back({v, 0, side.V.row(v)});
        points.emplace_back(side.V.row(v));
        out[v] = 1;
    }
    const Topology topology(side.F, static_cast<int>(side.V.rows()));
    const std::vector<double> distance = geodesic_distance(side, topology, seeds, 2 * widest);
    constexpr double same = 1e-9;
    std::vector<int> vertices;
    for (int v = 0; v < static_cast<int>(out.size()); ++v) {
        if (!out[v] && distance[v] <= widest * (1 + same) &&
            distance[v] <= value_beside(points, closed, widths_mm, side.V.row(v)) * (1 + same)) {
            vertices.push_back(v);
        }
    }
    return vertices;
}

std::vector<int> kept_strips(const Mesh& rest, const Positions& moved, const std::vector<int>& line, bool closed)
{
    std::vector<int> vertices;
    const auto [left, right] = meshes_beside(rest, line, closed);
    for (const Mesh& side : {left, right}) {
        const Strip before = find_strip(side, line, closed);
        const Strip after = before.found() ? find_strip({moved, side.F}, line, closed) : Strip{};
        constexpr double about = 0.1;
        if (after.found() && std::abs(after.width_mm - before.width_mm) < about * before.width_mm &&
            std::abs(after.turning - before.turning) < about * before.turning) {
            const auto found = strip_vertices(side, line, closed, before.carried(line.size(), 1 + about));
            vertices.insert(vertices.end(), found.begin(), found.end());
        }
    }
    return vertices;
}

std::vector<Vec3> points_across(const Mesh& side, const std::vector<int>& line, bool closed,
                                const std::vector<double>& distances_mm)
{
    const Topology topology(side.F, static_cast<int>(side.V.rows()));
    const size_t n = line.size();
    std::vector<Vec3> conormals(n, Vec3::Zero());
    for (size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
        const size_t j = (i + 1) % n;
        const int e = topology.find_edge(line[i], line[j]);
        if (e < 0) {
            continue;
        }
        const int t = std::max(topology.edge(e).left, topology.edge(e).right);
        const Vec3 along = (side.V.row(line[j]) - side.V.row(line[i])).normalized();
        const Vec3 arm = side.V.row(side.F.row(t).sum() - line[i] - line[j]) - side.V.row(line[i]);
        const Vec3 m = (arm - along * along.dot(arm)).normalized();
        conormals[i] += m;
        conormals[j] += m;
    }
    std::vector<Vec3> points;
    for (size_t i = 0; i < n; ++i) {
        const Vec3 p = side.V.row(line[i]);
        const MeshPoint end = conormals[i].isZero(0)
                                  ? MeshPoint{}
                                  : slide(side, topology, line[i], distances_mm[i] * conormals[i].normalized());
        points.push_back(end.face < 0 ? p : position_of(side, end));
    }
    return points;
}

} // namespace tapeline
