// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/feature_rails.h"

#include "kernel/feature_lines.h"

#include <algorithm>
#include <limits>

namespace tapeline {

namespace {

constexpr double straight_on = 0.5; ///< cosine of the largest turn at a vertex that slides

} // namespace

std::vector<VertexPair> other_feature_edges(const Model& model, const std::vector<int>& line, bool closed)
{
    std::vector<VertexPair> own, others;
    for (size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
        own.push_back(vertex_pair(line[i], line[(i + 1) % line.size()]));
    }
    std::ranges::sort(own);
    for (const FeatureLine& other : find_feature_lines(model)) {
        const auto& vertices = other.vertices;
        for (size_t i = 0; i + (other.closed ? 0 : 1) < vertices.size(); ++i) {
            const VertexPair edge = vertex_pair(vertices[i], vertices[(i + 1) % vertices.size()]);
            if (!std::ranges::binary_search(own, edge)) {
                others.push_back(edge);
            }
        }
    }
    std::ranges::sort(others);
    return others;
}

FeatureRails::FeatureRails(const Mesh& mesh, const std::vector<VertexPair>& edges, const std::vector<char>& given)
    : mesh_(&mesh)
{
    if (edges.empty()) {
        return;
    }
    ends_.resize(given.size());
    next_.assign(given.size(), {-1, -1});
    corner_.assign(given.size(), 0);
    for (const VertexPair& edge : edges) {
        ends_[edge[0]].push_back(edge[1]);
        ends_[edge[1]].push_back(edge[0]);
    }
    for (int v = 0; v < static_cast<int>(given.size()); ++v) {
        if (given[v] || ends_[v].size() < 2) {
            continue;
        }
        const Vec3 in = position(v) - position(ends_[v][0]), out = position(ends_[v][1]) - position(v);
        if (ends_[v].size() == 2 && in.dot(out) >= straight_on * in.norm() * out.norm()) {
            next_[v] = {ends_[v][0], ends_[v][1]};
        } else {
            corner_[v] = 1;
        }
    }
}

Vec3 FeatureRails::tangent(int v) const { return (position(next_[v].second) - position(next_[v].first)).normalized(); }

/// The rail's vertices from `before` over `at` on, to its end or until `length` is reached.
std::vector<int> FeatureRails::chain(int before, int at, double length) const
{
    std::vector<int> vertices{before, at};
    length -= (position(at) - position(before)).norm();
    // A closed rail is walked once.
    while (length > 0 && slides(at) && at != vertices.front()) {
        const int onward = next_[at].first == before ? next_[at].second : next_[at].first;
        length -= (position(onward) - position(at)).norm();
        before = at;
        at = onward;
        vertices.push_back(at);
    }
    return vertices;
}

Vec3 FeatureRails::along(int v, double s) const
{
    const std::vector<int> vertices = chain(v, s < 0 ? next_[v].first : next_[v].second, std::abs(s));
    double left = std::abs(s);
    for (size_t i = 1; i < vertices.size(); ++i) {
        const Vec3 step = position(vertices[i]) - position(vertices[i - 1]);
        if (left <= step.norm()) {
            return position(vertices[i - 1]) + step * (left / step.norm());
        }
        left -= step.norm();
    }
    return position(vertices.back());
}

std::vector<RailPiece> FeatureRails::pieces(int v) const
{
    std::vector<RailPiece> pieces;
    for (const int first : empty() ? std::vector<int>{} : ends_[v]) {
        pieces.emplace_back();
        for (const int w : chain(v, first, std::numeric_limits<double>::infinity())) {
            pieces.back().points.push_back(position(w));
        }
    }
    return pieces;
}

double RailPiece::length() const
{
    double sum = 0;
    for (size_t i = 1; i < points.size(); ++i) {
        sum += (points[i] - points[i - 1]).norm();
    }
    return sum;
}

RailFoot nearest_on(const RailPiece& piece, const Vec3& p, const Vec3& beyond)
{
    const auto across = [&](const Vec3& v) { return Vec3(v - beyond * beyond.dot(v)); };
    RailFoot best{piece.points.front(), 0};
    double least = across(best.point - p).norm(), arc = 0;
    for (size_t i = 1; i < piece.points.size(); ++i) {
        const Vec3 a = piece.points[i - 1], step = piece.points[i] - a, flat = across(step);
        const double t = flat.squaredNorm() > 0 ? std::clamp(flat.dot(p - a) / flat.squaredNorm(), 0.0, 1.0) : 0;
        const Vec3 q = a + t * step;
        // The earliest of equally near places: a line seen end-on repeats none.
        if (const double distance = across(q - p).norm(); distance < least * (1 - 1e-12)) {
            least = distance;
            best = {q, arc + t * step.norm()};
        }
        arc += step.norm();
    }
    return best;
}

} // namespace tapeline
