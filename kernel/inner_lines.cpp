// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/inner_lines.h"

#include "kernel/feature_rails.h"
#include "kernel/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace tapeline {

namespace {

/// Number of the named line nearest to the middle of an edge, if that is nearer than the edge is long.
int id_of(const Vec3& a, const Vec3& b, const std::vector<NamedLine>& names)
{
    const Vec3 middle = 0.5 * (a + b);
    double least = 0.5 * (b - a).norm();
    int id = -1;
    for (const NamedLine& name : names) {
        for (size_t i = 1; i < name.points.size(); ++i) {
            if (const double d = distance_to_segment(middle, name.points[i - 1], name.points[i]); d < least) {
                least = d;
                id = name.id;
            }
        }
    }
    return id;
}

class Measurer {
public:
    Measurer(const MoveResult& move, const std::vector<NamedLine>& names)
        : move_(move), names_(names),
          topology_(move.rest.mesh.F, static_cast<int>(move.rest.mesh.V.rows())), moved_{move.V, move.rest.mesh.F},
          inside_(move.rest.mesh.F.rows(), 0), compressed_(inside_.size(), 0)
    {
        for (const int t : move.region.faces) {
            inside_[t] = 1;
        }
        const bool slides = move.retraction.applied && move.retraction.mode == RetractionMode::harmonic;
        const bool left = move.placement.compressed == LineSide::left;
        for (const int t : slides ? (left ? move.left_faces : move.right_faces) : std::vector<int>{}) {
            compressed_[t] = 1;
        }
        edges_ = other_feature_edges(move.rest, move.extended_line, move.correspondence.line.closed);
        edges_.insert(edges_.end(), move.region.kept_edges.begin(), move.region.kept_edges.end());
        std::ranges::sort(edges_);
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    }

    std::vector<InnerLine> measure()
    {
        std::map<std::pair<int, InnerLineRole>, std::vector<int>> groups;
        for (const VertexPair& edge : edges_) {
            const int e = topology_.find_edge(edge[0], edge[1]);
            const MeshEdge& found = topology_.edge(e);
            if (found.face_count == 2 && inside_[found.left] && inside_[found.right]) {
                groups[{id_of(at(edge[0]), at(edge[1]), names_), role(found)}].push_back(e);
            }
        }
        std::vector<InnerLine> lines;
        for (const auto& [key, group] : groups) {
            lines.push_back(measured(key.first, key.second, group));
        }
        return lines;
    }

private:
    Vec3 at(int v) const { return move_.rest.mesh.V.row(v); }

    InnerLineRole role(const MeshEdge& edge) const
    {
        const auto held = [&](int v) { return std::ranges::binary_search(move_.region.inner_fixed, v); };
        const auto rim = [&](int v) { return std::ranges::binary_search(move_.region.fixed_rim, v); };
        const bool fixed = (held(edge.a) || rim(edge.a)) && (held(edge.b) || rim(edge.b));
        return fixed ? InnerLineRole::held
                     : (compressed_[edge.left] && compressed_[edge.right] ? InnerLineRole::slides
                                                                          : InnerLineRole::follows);
    }

    InnerLine measured(int id, InnerLineRole role, const std::vector<int>& group) const
    {
        InnerLine line{.id = id, .role = role};
        std::set<int> vertices;
        for (const int e : group) {
            const MeshEdge& edge = topology_.edge(e);
            const double length = (at(edge.a) - at(edge.b)).norm();
            const double before = crease_angle(move_.rest.mesh, topology_, e);
            const double after = crease_angle(moved_, topology_, e);
            line.length_mm += length;
            line.crease_before += length * before;
            line.crease_after += length * after;
            line.crease_change_max = std::max(line.crease_change_max, std::abs(after - before));
            vertices.insert({edge.a, edge.b});
        }
        line.crease_before /= line.length_mm;
        line.crease_after /= line.length_mm;
        for (const int v : vertices) {
            const Vec3 p = move_.V.row(v);
            double least = p == at(v) ? 0 : std::numeric_limits<double>::infinity();
            for (size_t i = 0; i < edges_.size() && least > 0; ++i) {
                least = std::min(least, distance_to_segment(p, at(edges_[i][0]), at(edges_[i][1])));
            }
            line.off_line_mm = std::max(line.off_line_mm, least);
        }
        return line;
    }

    const MoveResult& move_;
    const std::vector<NamedLine>& names_;
    Topology topology_;
    Mesh moved_;
    std::vector<char> inside_, compressed_;
    std::vector<VertexPair> edges_;
};

} // namespace

std::vector<InnerLine> measure_inner_lines(const MoveResult& move, const std::vector<NamedLine>& names)
{
    return Measurer(move, names).measure();
}

} // namespace tapeline
