// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/border_slide.h"

#include "kernel/segment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace tapeline {

namespace {

/// Part of an open border as a polyline, from the line's end outwards; `arc` is the length from the end.
struct Chain {
    std::vector<int> vertices;
    std::vector<double> arc;
    double length() const { return arc.back(); }
};

std::vector<int> border_edges_in_region(const Topology& topology, const Region& region, int v)
{
    std::vector<int> result;
    for (const int e : topology.vertex_edges(v)) {
        const MeshEdge& edge = topology.edge(e);
        const int face = edge.left >= 0 ? edge.left : edge.right;
        if (edge.border() && std::ranges::binary_search(region.faces, face)) {
            result.push_back(e);
        }
    }
    return result;
}

Chain walk_border(const Mesh& mesh, const Topology& topology, const Region& region, int end, int first_edge)
{
    constexpr double corner = 45 * std::numbers::pi / 180;
    Chain chain{{end}, {0}};
    int edge = first_edge, v = end;
    Vec3 heading = Vec3::Zero();
    while (edge >= 0) {
        const int next = topology.other_end(edge, v);
        const Vec3 step = Vec3(mesh.V.row(next)) - Vec3(mesh.V.row(v));
        const bool turned = heading.norm() > 0 && std::atan2(heading.cross(step).norm(), heading.dot(step)) > corner;
        if (turned || next == end) {
            break;
        }
        chain.vertices.push_back(next);
        chain.arc.push_back(chain.arc.back() + step.norm());
        heading = step;
        const std::vector<int> around = border_edges_in_region(topology, region, next);
        const int from = edge;
        edge = -1;
        if (around.size() == 2) {
            edge = around[0] == from ? around[1] : around[0];
        }
        v = next;
    }
    return chain;
}

Vec3 point_at(const Mesh& mesh, const Chain& chain, double arc)
{
    const auto it = std::upper_bound(chain.arc.begin(), chain.arc.end(), arc);
    const auto i = std::clamp<std::ptrdiff_t>(it - chain.arc.begin(), 1, std::ssize(chain.arc) - 1);
    const double t = (arc - chain.arc[i - 1]) / (chain.arc[i] - chain.arc[i - 1]);
    return (1 - t) * Vec3(mesh.V.row(chain.vertices[i - 1])) + t * Vec3(mesh.V.row(chain.vertices[i]));
}

/// Arc length of the chain's point nearest to p, and how far that is.
std::pair<double, double> nearest(const Mesh& mesh, const Chain& chain, const Vec3& p)
{
    double best_arc = 0, best = std::numeric_limits<double>::infinity();
    for (size_t i = 1; i < chain.vertices.size(); ++i) {
        const Vec3 a = mesh.V.row(chain.vertices[i - 1]), b = mesh.V.row(chain.vertices[i]);
        const double t = share_of_segment(p, a, b);
        const double distance = (p - a - t * (b - a)).norm();
        if (distance < best) {
            best = distance;
            best_arc = chain.arc[i - 1] + t * (chain.arc[i] - chain.arc[i - 1]);
        }
    }
    return {best_arc, best};
}

} // namespace

Result<BorderSlide> slide_border(const Mesh& mesh, const Topology& topology, const Region& region, int end,
                                 const Vec3& target)
{
    BorderSlide slide;
    const std::vector<int> edges = border_edges_in_region(topology, region, end);
    const Vec3 origin = mesh.V.row(end);
    if (edges.size() != 2 || (target - origin).norm() == 0) {
        return slide;
    }
    const std::array<Chain, 2> chains{walk_border(mesh, topology, region, end, edges[0]),
                                      walk_border(mesh, topology, region, end, edges[1])};
    const auto [arc0, distance0] = nearest(mesh, chains[0], target);
    const auto [arc1, distance1] = nearest(mesh, chains[1], target);
    const int ahead = distance0 <= distance1 ? 0 : 1;
    const double moved = ahead == 0 ? arc0 : arc1;
    if (moved > 0.95 * chains[ahead].length()) {
        return fail(ErrorKind::rejected,
                    fmt::format("the line's end at ({:.6g}, {:.6g}, {:.6g}) mm would slide {:.4g} mm along the model's "
                                "border, where only {:.4g} mm lie inside the region: widen the region (--roi-distance)",
                                origin.x(), origin.y(), origin.z(), moved, chains[ahead].length()));
    }
    const Vec3 off = target - point_at(mesh, chains[ahead], moved);
    for (int c = 0; c < 2; ++c) {
        const Chain& chain = chains[c];
        const Chain& other = chains[1 - c];
        // The last vertex keeps its place: there the border leaves the region or turns.
        for (size_t i = 1; i + 1 < chain.vertices.size(); ++i) {
            const double left = 1 - chain.arc[i] / chain.length();
            const double arc = chain.arc[i] + (c == ahead ? moved : -moved) * left;
            slide.vertices.push_back(chain.vertices[i]);
            slide.targets.push_back((arc >= 0 ? point_at(mesh, chain, arc) : point_at(mesh, other, -arc)) + left * off);
        }
    }
    return slide;
}

} // namespace tapeline
