// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/uv_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tapeline {

namespace {

using Corners = std::array<int, 3>;

/// Cosine below which a triangle is put right: a triangle that follows its surface is off by no more than half the
/// angular deflection at its middle, whatever deflection is asked for.
constexpr double too_steep = 0.5;

/// Works on the triangles; those taken out are marked dead, new ones take their places or come last.
class Unfolder {
public:
    explicit Unfolder(UvTriangles& work) : work_(work), around_(work.points.size())
    {
        for (size_t t = 0; t < work.triangles.size(); ++t) {
            const Corners& c = work.triangles[t];
            facing_.push_back(work.facing(c[0], c[1], c[2]));
            for (const int v : c) {
                around_[v].push_back(static_cast<int>(t));
            }
        }
        alive_.assign(facing_.size(), 1);
    }

    bool is_folded(int t) const { return alive_[t] && facing_[t] < too_steep; }
    std::vector<int> folded() const
    {
        std::vector<int> list;
        for (size_t t = 0; t < facing_.size(); ++t) {
            if (is_folded(static_cast<int>(t))) {
                list.push_back(static_cast<int>(t));
            }
        }
        return list;
    }

    /// True when an edge of folded triangle t was flipped so that the worse of the two triangles faces better.
    bool flip_edge_of(int t)
    {
        for (int k = 0; k < 3; ++k) {
            const Corners corners = work_.triangles[t];
            const int a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
            const int other = across(t, a, b);
            if (other < 0 || std::ranges::binary_search(work_.kept_edges, vertex_pair(a, b))) {
                continue;
            }
            const int d = third(other, a, b);
            if (!turns_left(a, d, c) || !turns_left(d, b, c) || joined(c, d)) {
                continue;
            }
            const double before = std::min(facing_[t], facing_[other]);
            const double after = std::min(work_.facing(a, d, c), work_.facing(d, b, c));
            if (after > before + 1e-6) {
                take_out({t, other});
                put_in({{a, d, c}, {d, b, c}}, {t, other});
                return true;
            }
        }
        return false;
    }

    /// True when an inner corner of folded triangle t was taken out, the one that leaves the fewest folded triangles; not
    /// when that would make more of them.
    bool remove_corner_of(int t)
    {
        std::vector<int> star;
        std::vector<Corners> filling;
        std::ptrdiff_t gained = -1000;
        for (const int v : work_.triangles[t]) {
            const auto ring = work_.fixed[v] ? std::nullopt : ring_of(v);
            const auto filled = ring ? fill(*ring) : std::nullopt;
            if (!filled) {
                continue;
            }
            const auto before = std::ranges::count_if(around_[v], [&](int s) { return facing_[s] < too_steep; });
            const auto after = std::ranges::count_if(
                *filled, [&](const Corners& c) { return work_.facing(c[0], c[1], c[2]) < too_steep; });
            if (before - after > gained) {
                gained = before - after;
                star = around_[v];
                filling = *filled;
            }
        }
        if (gained < -999) {
            return false;
        }
        take_out(star);
        put_in(filling, star);
        return true;
    }

    void tidy()
    {
        size_t kept = 0;
        for (size_t t = 0; t < alive_.size(); ++t) {
            if (alive_[t]) {
                work_.triangles[kept++] = work_.triangles[t];
            }
        }
        work_.triangles.resize(kept);
    }

private:
    int third(int t, int a, int b) const
    {
        for (const int v : work_.triangles[t]) {
            if (v != a && v != b) {
                return v;
            }
        }
        return -1;
    }
    int across(int t, int a, int b) const
    {
        for (const int s : around_[a]) {
            if (s != t && std::ranges::count(work_.triangles[s], b) > 0) {
                return s;
            }
        }
        return -1;
    }
    bool joined(int a, int b) const
    {
        return std::ranges::any_of(around_[a], [&](int t) { return std::ranges::count(work_.triangles[t], b) > 0; });
    }
    double turn(int a, int b, int c) const
    {
        const Eigen::Vector2d x = work_.uv[b] - work_.uv[a], y = work_.uv[c] - work_.uv[a];
        return x.x() * y.y() - x.y() * y.x();
    }
    bool turns_left(int a, int b, int c) const { return turn(a, b, c) > 0; }
    void take_out(const std::vector<int>& triangles)
    {
        for (const int t : triangles) {
            alive_[t] = 0;
            for (const int v : work_.triangles[t]) {
                std::erase(around_[v], t);
            }
        }
    }
    /// Puts triangles into the given places, which are at least as many.
    void put_in(const std::vector<Corners>& triangles, const std::vector<int>& places)
    {
        for (size_t i = 0; i < triangles.size(); ++i) {
            const int t = places[i];
            work_.triangles[t] = triangles[i];
            alive_[t] = 1;
            facing_[t] = work_.facing(triangles[i][0], triangles[i][1], triangles[i][2]);
            for (const int v : triangles[i]) {
                around_[v].push_back(t);
            }
        }
    }

    /// The neighbours of an inner node, counter-clockwise; empty when they are no simple ring.
    std::optional<std::vector<int>> ring_of(int v) const
    {
        std::vector<std::pair<int, int>> sides;
        for (const int t : around_[v]) {
            const Corners& c = work_.triangles[t];
            const auto k = std::ranges::find(c, v) - c.begin();
            sides.emplace_back(c[(k + 1) % 3], c[(k + 2) % 3]);
        }
        std::vector<int> ring;
        for (int at = sides.empty() ? -1 : sides.front().first; ring.size() < sides.size();) {
            ring.push_back(at);
            const auto next = std::ranges::find(sides, at, &std::pair<int, int>::first);
            if (next == sides.end()) {
                return std::nullopt;
            }
            at = next->second;
            if (at == ring.front() && ring.size() < sides.size()) {
                return std::nullopt;
            }
        }
        return ring.size() >= 3 ? std::optional(ring) : std::nullopt;
    }

    /// How good it is to cut the corner (a, b, c) off a ring: folded triangles last, then thin ones.
    double worth(int a, int b, int c) const
    {
        const Vec3 &p = work_.points[a], &q = work_.points[b], &r = work_.points[c];
        const double longest = std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
        const double facing = work_.facing(a, b, c);
        return facing < too_steep ? facing - 1 : (q - p).cross(r - p).norm() / longest;
    }
    bool holds_another(const std::vector<int>& ring, int a, int b, int c) const
    {
        return std::ranges::any_of(ring, [&](int v) {
            return v != a && v != b && v != c && turn(a, b, v) >= 0 && turn(b, c, v) >= 0 && turn(c, a, v) >= 0;
        });
    }

    /// Triangles that fill a ring, one corner after the other cut off; empty when that does not come to an end.
    std::optional<std::vector<Corners>> fill(std::vector<int> ring) const
    {
        std::vector<Corners> triangles;
        while (ring.size() >= 3) {
            const size_t n = ring.size();
            size_t best = n;
            double most = -std::numeric_limits<double>::infinity();
            for (size_t i = 0; i < n; ++i) {
                const int a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
                if (!turns_left(a, b, c) || holds_another(ring, a, b, c) || (n > 3 && joined(a, c))) {
                    continue;
                }
                if (const double own = worth(a, b, c); own > most) {
                    most = own;
                    best = i;
                }
            }
            if (best == n) {
                return std::nullopt;
            }
            triangles.push_back({ring[best], ring[(best + 1) % n], ring[(best + 2) % n]});
            ring.erase(ring.begin() + static_cast<long>((best + 1) % n));
        }
        return triangles;
    }

    UvTriangles& work_;
    std::vector<std::vector<int>> around_; ///< triangles at each node
    std::vector<double> facing_;
    std::vector<char> alive_;
};

} // namespace

Unfolded unfold(UvTriangles& work)
{
    // Flips alone may go round in circles; every removal takes a node, so that the whole comes to an end.
    constexpr int most_flips = 20;
    Unfolder unfolder(work);
    std::vector<int> folded = unfolder.folded();
    Unfolded result;
    result.found = static_cast<int>(folded.size());
    for (bool changed = true; changed && !folded.empty();) {
        for (int round = 0; round < most_flips && changed; ++round) {
            changed = false;
            for (const int t : folded) {
                changed = (unfolder.is_folded(t) && unfolder.flip_edge_of(t)) || changed;
            }
            folded = unfolder.folded();
        }
        changed = false;
        for (const int t : folded) {
            changed = (unfolder.is_folded(t) && unfolder.remove_corner_of(t)) || changed;
        }
        folded = unfolder.folded();
    }
    if (result.found > 0) {
        unfolder.tidy();
    }
    result.left = static_cast<int>(folded.size());
    return result;
}

} // namespace tapeline
