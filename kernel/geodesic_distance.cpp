// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geodesic_distance.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

namespace tapeline {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr int max_unfolded = 16;
constexpr double least_gain = 1e-6;
constexpr double straight = 0.9; ///< least share of the straight way's length

/// A triangle, real or seen through unfolded neighbours, through which vertex `to` can be reached: laid flat with
/// `to` in the origin, its other corners a and b.
struct Stencil {
    int to = -1;
    int a = -1;
    int b = -1;
    Vec2 at_a = Vec2::Zero();
    Vec2 at_b = Vec2::Zero();
};

double cross2(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

class Front {
public:
    Front(const Mesh& mesh, const Topology& topology, double limit)
        : mesh_(mesh), topology_(topology), limit_(limit),
          distance_(mesh.V.rows(), std::numeric_limits<double>::infinity()), source_(mesh.V.rows(), Vec3::Zero())
    {
    }

    std::vector<double> run(const std::vector<DistanceSeed>& seeds)
    {
        for (const DistanceSeed& seed : seeds) {
            offer(seed.vertex, seed.distance, seed.source);
        }
        while (!queue_.empty()) {
            const auto [distance, v] = queue_.top();
            queue_.pop();
            if (distance <= distance_[v]) {
                spread(v);
            }
        }
        return std::move(distance_);
    }

private:
    void offer(int v, double distance, const Vec3& source)
    {
        if (distance < distance_[v] * (1 - least_gain) && distance <= limit_) {
            distance_[v] = distance;
            source_[v] = source;
            queue_.emplace(distance, v);
        }
    }

    /// Offers new distances to all vertices that see v across a triangle or an edge.
    void spread(int v)
    {
        for (const int e : topology_.vertex_edges(v)) {
            const int to = topology_.other_end(e, v);
            offer(to, distance_[v] + (mesh_.V.row(to) - mesh_.V.row(v)).norm(), source_[v]);
        }
        for (const int t : topology_.vertex_faces(v)) {
            for (int k = 0; k < 3; ++k) {
                if (mesh_.F(t, k) != v) {
                    look_from(mesh_.F(t, k), t, k);
                }
            }
            // Vertices across the opposite edges may see v through unfolded triangles.
            for (const int e : topology_.face_edges(t)) {
                see_through(v, t, e);
            }
        }
    }

    /// Vertices beyond edge e of triangle t whose corner is obtuse and so looks through t at v.
    void see_through(int v, int t, int e)
    {
        int from = t, edge = e;
        const MeshEdge& first = topology_.edge(edge);
        if (first.a == v || first.b == v) {
            return;
        }
        const int across = topology_.face_across(from, edge);
        if (across < 0 || first.face_count != 2) {
            return;
        }
        for (int k = 0; k < 3; ++k) {
            const int to = mesh_.F(across, k);
            if (to != first.a && to != first.b) {
                look_from(to, across, k);
            }
        }
    }

    /// Offers corner k of triangle t what it sees through t.
    void look_from(int to, int t, int k)
    {
        const int a = mesh_.F(t, (k + 1) % 3), b = mesh_.F(t, (k + 2) % 3);
        const Vec3 ea = mesh_.V.row(a) - mesh_.V.row(to), eb = mesh_.V.row(b) - mesh_.V.row(to);
        const double la = ea.norm();
        if (!(la > 0)) {
            return;
        }
        const double x = ea.dot(eb) / la, y = ea.cross(eb).norm() / la;
        if (!(y > 0)) {
            return;
        }
        split_obtuse({to, a, b, Vec2(la, 0), Vec2(x, y)}, t);
    }

    /// Uses a stencil, or when its corner is obtuse unfolds the triangle beyond and uses the parts.
    void split_obtuse(const Stencil& s, int t)
    {
        if (s.at_a.dot(s.at_b) >= 0) {
            use(s);
            return;
        }
        // Walk through the triangles beyond the edge until one has its corner inside the angle.
        int p = s.a, q = s.b;
        Vec2 at_p = s.at_a, at_q = s.at_b;
        for (int walked = 0; walked < max_unfolded; ++walked) {
            const int e = topology_.find_edge(p, q);
            const int next = e < 0 || topology_.edge(e).face_count != 2 ? -1 : topology_.face_across(t, e);
            if (next < 0) {
                break;
            }
            int apex = -1;
            for (int k = 0; k < 3; ++k) {
                if (mesh_.F(next, k) != p && mesh_.F(next, k) != q) {
                    apex = mesh_.F(next, k);
                }
            }
            const Vec3 along = mesh_.V.row(q) - mesh_.V.row(p), out = mesh_.V.row(apex) - mesh_.V.row(p);
            const double length = along.norm();
            if (!(length > 0)) {
                break;
            }
            const Vec2 direction = (at_q - at_p) / length;
            // `to` lies to the left of p→q, so the unfolded corner lies to its right.
            const Vec2 at_apex = at_p + direction * (out.dot(along) / length) +
                                 Vec2(direction.y(), -direction.x()) * (along.cross(out).norm() / length);
            const bool right_of_a = cross2(s.at_a, at_apex) > 0, left_of_b = cross2(at_apex, s.at_b) > 0;
            t = next;
            if (right_of_a && left_of_b) {
                use({s.to, s.a, apex, s.at_a, at_apex});
                use({s.to, apex, s.b, at_apex, s.at_b});
                return;
            }
            if (right_of_a) {
                q = apex;
                at_q = at_apex;
            } else {
                p = apex;
                at_p = at_apex;
            }
        }
        use(s);
    }

    void use(const Stencil& s)
    {
        const double da = distance_[s.a], db = distance_[s.b];
        if (!std::isfinite(da) && !std::isfinite(db)) {
            return;
        }
        // Straight along the stencil's sides: real edges, or unfolded ones inside the flat strip.
        if (std::isfinite(da)) {
            offer(s.to, da + s.at_a.norm(), source_[s.a]);
        }
        if (std::isfinite(db)) {
            offer(s.to, db + s.at_b.norm(), source_[s.b]);
        }
        if (std::isfinite(da) && std::isfinite(db)) {
            const auto [distance, share] = through_edge(s, da, db);
            const Vec3 source = (1 - share) * source_[s.a] + share * source_[s.b];
            // Where an obtuse corner could not be unfolded, ends that see each other round the corner would grow ever
            // shorter: no way is shorter than the straight one, but for what the source between two seeds is off.
            if (share >= 0 && distance >= straight * (Vec3(mesh_.V.row(s.to)) - source).norm()) {
                offer(s.to, distance, source);
            }
        }
    }

    /// Distance of the origin when the front passes edge ab, and where it passes (0 = a, 1 = b); share -1 = nowhere.
    std::pair<double, double> through_edge(const Stencil& s, double da, double db) const
    {
        const Vec2 ab = s.at_b - s.at_a;
        const double length = ab.norm();
        const double slope = (db - da) / length;
        if (!(std::abs(slope) < 1)) {
            return {0, -1};
        }
        // The front moves by `slope` along ab and by `rise` square to it, towards the origin.
        const double rise = std::sqrt(1 - slope * slope);
        const Vec2 u = ab / length;
        const Vec2 n(-u.y(), u.x()); // towards the origin, which lies to the left of a→b
        const double height = -n.dot(s.at_a);
        if (!(height > 0)) {
            return {0, -1};
        }
        const double apart = (source_[s.b] - source_[s.a]).norm(), width = length * rise;
        const double mean = 0.5 * (da + db);
        if (apart < 0.999 * width && mean > 0) {
            // The rays spread: they meet `radius` behind the edge's middle.
            const double radius = mean * width / (width - apart);
            if (const auto answer = around_point(s, da - mean + radius, db - mean + radius)) {
                return {answer->first + mean - radius, answer->second};
            }
        }
        const double x = -u.dot(s.at_a);                 // the origin's foot on ab, from a
        const double passed = x - height * slope / rise; // where its ray crosses ab
        if (passed < 0 || passed > length) {
            return {0, -1};
        }
        return {da + slope * passed + (height / rise), passed / length};
    }

    /// The same for a front around the point behind ab that is ra from a and rb from b.
    static std::optional<std::pair<double, double>> around_point(const Stencil& s, double ra, double rb)
    {
        const Vec2 ab = s.at_b - s.at_a;
        const double length = ab.norm();
        const double x = (ra * ra - rb * rb + length * length) / (2 * length);
        const double y2 = ra * ra - x * x;
        if (!(ra > 0) || !(rb > 0) || y2 < 0) {
            return {};
        }
        const Vec2 u = ab / length;
        const Vec2 centre = s.at_a + x * u - std::sqrt(y2) * Vec2(-u.y(), u.x());
        const double side_a = cross2(centre, s.at_a), side_b = cross2(centre, s.at_b);
        if (!(side_a <= 0 && side_b >= 0)) {
            return std::pair{0.0, -1.0};
        }
        const double sum = side_b - side_a;
        return std::pair{centre.norm(), sum > 0 ? -side_a / sum : 0.5};
    }

    const Mesh& mesh_;
    const Topology& topology_;
    double limit_;
    std::vector<double> distance_;
    std::vector<Vec3> source_;
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue_;
};

} // namespace

std::vector<double> geodesic_distance(const Mesh& mesh, const Topology& topology,
                                      const std::vector<DistanceSeed>& seeds, double limit)
{
    return Front(mesh, topology, limit).run(seeds);
}

} // namespace tapeline
