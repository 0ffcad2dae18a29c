// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shaders.h"
#include "kernel/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::picture {

namespace {

/// A fading crease ends where it is no sharper than this many times the surface beside it, or than `least_angle`.
constexpr double standing_out = 3;
constexpr double least_angle = 0.5 * std::numbers::pi / 180;
/// It goes on within this angle of its direction so far.
constexpr double straight_on = 40 * std::numbers::pi / 180;

/// Follows creases beyond the edges that are marked already.
class FadingCreases {
public:
    FadingCreases(const Mesh& mesh, const Topology& topology, const std::vector<double>& angles,
                  std::vector<char>& sharp)
        : mesh_(mesh), topology_(topology), angles_(angles), sharp_(sharp)
    {
    }

    void grow()
    {
        std::vector<std::pair<int, int>> ends; // the last edge, and the vertex it ends at
        for (int e = 0; e < topology_.edge_count(); ++e) {
            const MeshEdge& edge = topology_.edge(e);
            for (const int v : {edge.a, edge.b}) {
                if (sharp_[e] && edge.face_count == 2 && is_end(v)) {
                    ends.emplace_back(e, v);
                }
            }
        }
        for (auto [last, v] : ends) {
            for (int next = continuation(last, v); next >= 0; next = continuation(last, v)) {
                sharp_[next] = 1;
                v = topology_.other_end(next, v);
                last = next;
            }
        }
    }

private:
    bool is_end(int v) const
    {
        const auto edges = topology_.vertex_edges(v);
        return std::count_if(edges.begin(), edges.end(), [&](int e) { return sharp_[e]; }) == 1;
    }

    Vec3 direction(int e, int from) const
    {
        return (mesh_.V.row(topology_.other_end(e, from)) - mesh_.V.row(from)).transpose().normalized();
    }

    /// The sharpest of the other edges of its two triangles: what the surface itself turns by.
    double beside(int e) const
    {
        double most = 0;
        for (const int t : {topology_.edge(e).left, topology_.edge(e).right}) {
            for (const int other : topology_.face_edges(t)) {
                most = other == e || sharp_[other] ? most : std::max(most, angles_[other]);
            }
        }
        return most;
    }

    int continuation(int last, int v) const
    {
        const Vec3 ahead = -direction(last, v);
        int best = -1;
        for (const int e : topology_.vertex_edges(v)) {
            if (e == last) {
                continue;
            }
            if (sharp_[e]) {
                return -1; // another crease or a border is reached
            }
            const bool goes_on =
                topology_.edge(e).face_count == 2 && direction(e, v).dot(ahead) > std::cos(straight_on);
            if (goes_on && angles_[e] > least_angle && (best < 0 || angles_[e] > angles_[best])) {
                best = e;
            }
        }
        return best >= 0 && angles_[best] > standing_out * beside(best) ? best : -1;
    }

    const Mesh& mesh_;
    const Topology& topology_;
    const std::vector<double>& angles_;
    std::vector<char>& sharp_;
};

/// Angle between the normals of each edge's two triangles [rad]; half a turn where there are not two.
std::vector<double> edge_angles(const Mesh& mesh, const Topology& topology)
{
    std::vector<double> angles(topology.edge_count(), std::numbers::pi);
    parallel_for(topology.edge_count(), [&](int e) {
        const MeshEdge& edge = topology.edge(e);
        if (edge.face_count == 2 && edge.left >= 0 && edge.right >= 0) {
            const Vec3 left = triangle_normal(mesh, edge.left), right = triangle_normal(mesh, edge.right);
            angles[e] = std::atan2(left.cross(right).norm(), left.dot(right));
        }
    });
    return angles;
}

} // namespace

std::vector<char> sharp_edges(const Mesh& mesh, const Topology& topology, double crease_angle,
                              const std::vector<std::vector<int>>& lines)
{
    const std::vector<double> angles = edge_angles(mesh, topology);
    std::vector<char> sharp(topology.edge_count(), 0);
    for (int e = 0; e < topology.edge_count(); ++e) {
        sharp[e] = angles[e] >= crease_angle * std::numbers::pi / 180;
    }
    for (const std::vector<int>& line : lines) {
        for (size_t i = 1; i < line.size(); ++i) {
            const int e = topology.find_edge(line[i - 1], line[i]);
            if (e >= 0) {
                sharp[e] = 1;
            }
        }
    }
    FadingCreases(mesh, topology, angles, sharp).grow();
    return sharp;
}

} // namespace tapeline::picture
