// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/median.h"
#include "kernel/repair_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace tapeline {

namespace {

/// Disjoint sets of vertices, each known by its lowest member.
class VertexSets {
public:
    explicit VertexSets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int root(int v)
    {
        while (parent_[v] != v) {
            parent_[v] = parent_[parent_[v]];
            v = parent_[v];
        }
        return v;
    }
    void join(int a, int b)
    {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<int> parent_;
};

/// Finds vertices that lie within a distance of each other, by a grid with cells of four times that distance.
class NearVertices {
public:
    NearVertices(const Positions& V, const std::vector<int>& vertices, double distance)
        : V_(V), distance_(distance), cell_(4 * distance)
    {
        for (const int v : vertices) {
            entries_.push_back({cell_of(V.row(v)), {V(v, 0), V(v, 1), V(v, 2)}, v});
        }
        std::sort(entries_.begin(), entries_.end());
    }

    /// Sets of the vertices that are near each other, directly or through others.
    VertexSets sets() const
    {
        VertexSets sets(static_cast<int>(V_.rows()));
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            const auto& [cell, point, v] = entries_[i];
            if (i > 0 && entries_[i - 1].point == point) {
                sets.join(v, entries_[i - 1].vertex);
                continue; // its neighbours are those of its twin
            }
            const Vec3 p = V_.row(v);
            const Cell low = cell_of(p.array() - distance_), high = cell_of(p.array() + distance_);
            for (auto x = low[0]; x <= high[0]; ++x) {
                for (auto y = low[1]; y <= high[1]; ++y) {
                    for (auto z = low[2]; z <= high[2]; ++z) {
                        join_cell(v, {x, y, z}, sets);
                    }
                }
            }
        }
        return sets;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    struct Entry {
        Cell cell;
        std::array<double, 3> point;
        int vertex;
        bool operator<(const Entry& other) const
        {
            return std::tie(cell, point, vertex) < std::tie(other.cell, other.point, other.vertex);
        }
    };
    Cell cell_of(const Vec3& p) const
    {
        const auto index = [&](int axis) {
            return static_cast<std::int64_t>(std::clamp(std::floor(p[axis] / cell_), -1e18, 1e18));
        };
        return {index(0), index(1), index(2)};
    }
    void join_cell(int v, const Cell& cell, VertexSets& sets) const
    {
        // A cell far smaller than any edge holds few places; the limit keeps absurd input from taking forever.
        int tries = 256;
        for (auto i = std::ranges::lower_bound(entries_, cell, {}, &Entry::cell);
             i != entries_.end() && i->cell == cell && tries > 0; ++i, --tries) {
            if ((V_.row(i->vertex) - V_.row(v)).cwiseAbs().maxCoeff() <= distance_) {
                sets.join(v, i->vertex);
            }
        }
    }

    const Positions& V_;
    double distance_, cell_;
    std::vector<Entry> entries_;
};

/// A border edge by the places of its ends, the lower place first, and the vertices there.
struct PlacedEdge {
    int place_a, place_b, a, b;
};

std::vector<int> border_vertices(const Topology& topology)
{
    std::vector<int> ends;
    for (const MeshEdge& edge : topology.edges()) {
        if (edge.border()) {
            ends.insert(ends.end(), {edge.a, edge.b});
        }
    }
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
}

/// The median, which a few stray vertices far out do not change, of the vertices' largest coordinates.
double median_coordinate(const Positions& V, const std::vector<int>& vertices)
{
    std::vector<double> largest;
    for (const int v : vertices) {
        largest.push_back(V.row(v).cwiseAbs().maxCoeff());
    }
    return median(std::move(largest));
}

std::vector<PlacedEdge> place_border(const Mesh& mesh, const Topology& topology, const std::vector<int>& vertices,
                                     double tolerance)
{
    VertexSets places = NearVertices(mesh.V, vertices, tolerance).sets();
    std::vector<PlacedEdge> border;
    for (const MeshEdge& edge : topology.edges()) {
        const int a = places.root(edge.a), b = places.root(edge.b);
        if (edge.border() && a != b) {
            border.push_back(a < b ? PlacedEdge{a, b, edge.a, edge.b} : PlacedEdge{b, a, edge.b, edge.a});
        }
    }
    std::ranges::stable_sort(border, {}, [](const PlacedEdge& edge) { return std::pair(edge.place_a, edge.place_b); });
    return border;
}

} // namespace

bool sew_borders(RepairedMesh& work, const EdgeSides& sides)
{
    Mesh& mesh = work.mesh;
    const std::vector<int> vertices = border_vertices(sides.topology());
    if (vertices.empty()) {
        return false;
    }
    const double tolerance =
        std::max(border_tolerance * median_coordinate(mesh.V, vertices), std::numeric_limits<double>::min());
    const auto border = place_border(mesh, sides.topology(), vertices, tolerance);
    VertexSets joined(static_cast<int>(mesh.V.rows()));
    int pairs = 0;
    for (std::size_t i = 0; i < border.size();) {
        std::size_t end = i + 1;
        while (end < border.size() && border[end].place_a == border[i].place_a &&
               border[end].place_b == border[i].place_b) {
            ++end;
        }
        if (end - i == 2) {
            joined.join(border[i].a, border[i + 1].a);
            joined.join(border[i].b, border[i + 1].b);
            ++pairs;
        }
        i = end;
    }
    if (pairs == 0) {
        return false;
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            mesh.F(t, k) = joined.root(mesh.F(t, k));
        }
    }
    work.report.sewn_edges += pairs;
    work.report.warnings.push_back(fmt::format("{} pairs of border edges whose ends agree to {:.2g} mm were joined at "
                                               "their lower-numbered vertices; the others are no longer used",
                                               pairs, tolerance));
    return true;
}

} // namespace tapeline
