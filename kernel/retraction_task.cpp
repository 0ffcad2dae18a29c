// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/line_tangents.h"
#include "kernel/retraction_steps.h"
#include "kernel/segment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace tapeline {

namespace {

/// Share of the largest displacement over which a line that leaves the side stops dragging material along.
constexpr double fade_width = 0.3;
/// The same for the corner where what goes into the side ends.
constexpr double round_width = 0.06;

/// A target lies beyond another feature line when the part of the side beside the line ends this share of the
/// displacement before it.
constexpr double crossing_share = 0.05;

/// Unit vector in the plane of triangle t, orthogonal to its edge a-b, pointing into the triangle.
Vec3 conormal(const Mesh& mesh, int t, int a, int b)
{
    const int c = mesh.F.row(t).sum() - a - b;
    const Vec3 edge = (mesh.V.row(b) - mesh.V.row(a)).normalized();
    const Vec3 arm = mesh.V.row(c) - mesh.V.row(a);
    return (arm - edge * edge.dot(arm)).normalized();
}

} // namespace

RetractionTask::RetractionTask(const SideMesh& side, const std::vector<Vec3>& displacements,
                               const std::vector<VertexPair>& features, bool on_rails, double share,
                               const CarriedStrip* strip)
    : side_(side), inner_(side.own_mesh()), topology_(inner_.F, static_cast<int>(inner_.V.rows())),
      walls_(on_rails ? features : std::vector<VertexPair>{}), ground_(inner_, walls_), entry_(inner_.V.rows(), -1),
      free_(inner_.V.rows(), 1), normals_(vertex_normals(inner_)), start_(inner_.V)
{
    for (size_t i = 0; i < side.line.size(); ++i) {
        entry_[side.line[i]] = static_cast<int>(i);
        free_[side.line[i]] = 0;
    }
    for (const int v : side.fixed) {
        free_[v] = 0;
    }
    for (const int v : side.guided) {
        free_[v] = 0;
    }
    for (int v = 0; v < inner_.V.rows(); ++v) {
        if (topology_.vertex_faces(v).empty()) {
            free_[v] = 0;
        }
    }
    const int closing = side.line.size() > 2 ? topology_.find_edge(side.line.back(), side.line.front()) : -1;
    closed_ = closing >= 0 && topology_.edge(closing).border();
    find_moves(displacements, share);
    lay_rails(false);
    place_line();
    if (strip) {
        place_strip(*strip, displacements);
    }
    place_guided(displacements);
    slide_borders(on_rails);
    lay_rails(on_rails);
    find_arcs();
}

void RetractionTask::lay_rails(bool along_borders)
{
    std::vector<VertexPair> edges = walls_;
    std::vector<char> given(free_.size());
    std::ranges::transform(free_, given.begin(), std::logical_not<>());
    for (const MeshEdge& edge : topology_.edges()) {
        if (along_borders && edge.border() && (free_[edge.a] || free_[edge.b])) {
            edges.push_back({edge.a, edge.b});
        }
    }
    rails_ = FeatureRails(inner_, edges, given);
    for (int v = 0; v < static_cast<int>(free_.size()); ++v) {
        free_[v] = free_[v] && !rails_.corner(v) ? 1 : 0;
    }
}

void RetractionTask::find_moves(const std::vector<Vec3>& displacements, double share)
{
    const size_t n = side_.line.size();
    std::vector<Vec3> inwards(n, Vec3::Zero());
    for (size_t i = 0; i + (closed_ ? 0 : 1) < n; ++i) {
        const size_t j = (i + 1) % n;
        const int a = side_.line[i], b = side_.line[j], e = topology_.find_edge(a, b);
        if (e < 0) {
            continue;
        }
        const int t = topology_.edge(e).left >= 0 ? topology_.edge(e).left : topology_.edge(e).right;
        const Vec3 m = conormal(inner_, t, a, b);
        inwards[i] += m;
        inwards[j] += m;
    }
    double largest = 0, outwards = 0;
    std::vector<double> into(n);
    for (size_t i = 0; i < n; ++i) {
        inwards[i].stableNormalize();
        into[i] = displacements[i].dot(inwards[i]);
        largest = std::max(largest, displacements[i].norm());
        outwards = std::max(outwards, -into[i]);
    }
    const auto slope_to = [&](size_t i, size_t j) {
        const double step = (position(side_.line[j]) - position(side_.line[i])).norm();
        return step > 0 ? std::abs(into[j] - into[i]) / step : 0;
    };
    for (size_t i = 0; i < n; ++i) {
        // What stays, as the prolongation's far end, is to stay: no corner to round where the way in does not change.
        const auto [before, after] = line_neighbours(i, n, closed_);
        const double slope = std::min(slope_to(i, before), slope_to(i, after));
        const double round = std::min({round_width, slope, outwards / std::max(largest, 1e-300)}) * largest;
        const double s = largest > 0 ? std::clamp(1 + into[i] / (fade_width * largest), 0.0, 1.0) : 1;
        shares_.push_back(share * s * s * (3 - 2 * s));
        if (into[i] >= round) {
            moves_.push_back(share * displacements[i]);
            continue;
        }
        const double more = std::max(0.0, into[i] + round), kept = round > 0 ? more * more / (4 * round) : 0;
        moves_.push_back(shares_.back() * (displacements[i] - into[i] * inwards[i]) + share * kept * inwards[i]);
    }
}

void RetractionTask::place_line()
{
    for (size_t i = 0; i < moves_.size(); ++i) {
        if (!moves_[i].isZero(0)) {
            start_.row(side_.line[i]) = on_surface(i);
        }
    }
}

/// The line on the strip's inner edge goes to its target itself, less what lifts the strip off the ground.
void RetractionTask::place_strip(const CarriedStrip& strip, const std::vector<Vec3>& displacements)
{
    for (size_t i = 0; i < moves_.size(); ++i) {
        moves_[i] = shares_[i] * (displacements[i] - strip.lifts[i]);
        if (!moves_[i].isZero(0)) {
            start_.row(side_.line[i]) = position(side_.line[i]) + moves_[i];
        }
    }
    for (size_t k = 0; k < strip.vertices.size(); ++k) {
        const int v = strip.vertices[k];
        const Vec3 lift = at_station(strip, k, strip.lifts), place = strip.places.row(static_cast<Eigen::Index>(k));
        const Vec3 move = at_station(strip, k, shares_) * (place - position(v) - lift);
        free_[v] = 0;
        start_.row(v) = position(v) + move;
    }
}

/// Where another feature line leaves the moving line and runs the way that the displacement goes, the vertex they share
/// slides along it; elsewhere the surface point closest to rest + move.
Vec3 RetractionTask::on_surface(size_t entry)
{
    const int v = side_.line[entry];
    const Vec3 wanted = position(v) + moves_[entry];
    const double size = moves_[entry].norm();
    double least = 0.5 * size;
    std::optional<Vec3> on_rail;
    for (const RailPiece& piece : rails_.pieces(v)) {
        const RailFoot foot = nearest_on(piece, wanted);
        if (const double off = (foot.point - wanted).norm(); foot.arc > 0 && off < least) {
            least = off;
            on_rail = foot.point;
        }
    }
    if (!on_rail) {
        Vec3 place = ground_.closest(wanted);
        const double over =
            rails_.pieces(v).empty() ? ground_.distance_in_part(v, wanted) - (place - wanted).norm() : 0;
        if (over > std::max(crossed_by_, crossing_share * size)) {
            crossed_by_ = over;
            crossed_ = static_cast<int>(entry);
        }
        return place;
    }
    moves_[entry] = *on_rail - position(v);
    return *on_rail;
}

void RetractionTask::place_guided(const std::vector<Vec3>& displacements)
{
    for (size_t i = 0; i < side_.guided.size() && !side_.line.empty(); ++i) {
        const int v = side_.guided[i];
        const auto distance = [&](int w) { return (position(w) - position(v)).squaredNorm(); };
        const size_t end = distance(side_.line.front()) <= distance(side_.line.back()) ? 0 : side_.line.size() - 1;
        const double whole = displacements[end].norm();
        const double share = whole > 0 ? moves_[end].norm() / whole : 1;
        if (share == 1) {
            start_.row(v) = side_.guided_targets[i];
        } else if (share > 0) {
            start_.row(v) = ground_.closest((1 - share) * position(v) + share * side_.guided_targets[i]);
        }
    }
}

void RetractionTask::slide_borders(bool others_slide)
{
    std::vector<char> seen(inner_.V.rows(), 0);
    for (int v = 0; v < inner_.V.rows(); ++v) {
        if (free_[v] && topology_.border_vertex(v)) {
            free_[v] = 0;
            seen[v] = 1; // still to be put into a chain
        }
    }
    for (const int v : {side_.line.empty() ? -1 : side_.line.front(), side_.line.empty() ? -1 : side_.line.back()}) {
        if (v < 0) {
            continue;
        }
        for (const int e : topology_.vertex_edges(v)) {
            const int next = topology_.other_end(e, v);
            if (topology_.edge(e).border() && seen[next]) {
                slide_chain(border_chain(v, next, seen));
            }
        }
    }
    // Borders that the line does not reach, as those of a hole, are rails.
    for (size_t v = 0; v < seen.size() && others_slide; ++v) {
        free_[v] |= seen[v];
    }
}

/// The border from vertex `from` over `next` up to the first vertex that is not on a free border; clears `seen`.
std::vector<int> RetractionTask::border_chain(int from, int next, std::vector<char>& seen) const
{
    std::vector<int> chain{from};
    for (int before = from, at = next; at >= 0;) {
        chain.push_back(at);
        if (!seen[at]) {
            break;
        }
        seen[at] = 0;
        int onward = -1;
        for (const int e : topology_.vertex_edges(at)) {
            const int other = topology_.other_end(e, at);
            if (topology_.edge(e).border() && other != before) {
                onward = other;
            }
        }
        before = at;
        at = onward;
    }
    return chain;
}

void RetractionTask::slide_chain(const std::vector<int>& chain)
{
    std::vector<double> arc{0};
    for (size_t i = 1; i < chain.size(); ++i) {
        arc.push_back(arc.back() + (position(chain[i]) - position(chain[i - 1])).norm());
    }
    const auto point_at = [&](double s) -> Vec3 {
        size_t k = 0;
        while (k + 2 < arc.size() && arc[k + 1] < s) {
            ++k;
        }
        const double t = arc[k + 1] > arc[k] ? std::clamp((s - arc[k]) / (arc[k + 1] - arc[k]), 0.0, 1.0) : 0;
        return (1 - t) * position(chain[k]) + t * position(chain[k + 1]);
    };
    const auto nearest_arc = [&](const Vec3& p) {
        double best = 0, least = std::numeric_limits<double>::infinity();
        for (size_t k = 0; k + 1 < chain.size(); ++k) {
            const Vec3 a = position(chain[k]), edge = position(chain[k + 1]) - a;
            const double t = share_of_segment(p, a, a + edge);
            if (const double distance = (a + t * edge - p).norm(); distance < least) {
                least = distance;
                best = arc[k] + t * edge.norm();
            }
        }
        return best;
    };
    const auto end = [&](int v, double rest) { return line_entry(v) >= 0 ? nearest_arc(start_.row(v)) : rest; };
    const double first = end(chain.front(), 0), last = end(chain.back(), arc.back());
    if (first == 0 && last == arc.back()) {
        return;
    }
    for (size_t i = 1; i + 1 < chain.size(); ++i) {
        start_.row(chain[i]) = point_at(first + (last - first) * arc[i] / arc.back());
    }
}

void RetractionTask::find_arcs()
{
    for (size_t i = 0; i < moves_.size(); ++i) {
        const int v = side_.line[i];
        arcs_.push_back(moves_[i].isZero(0) ? moves_[i] : ground_.arc_to(v, moves_[i], start_.row(v)));
    }
}

} // namespace tapeline
