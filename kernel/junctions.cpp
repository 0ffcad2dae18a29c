// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/junctions.h"

#include "kernel/feature_rails.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace tapeline {

namespace {

constexpr double most_off = 0.5;   ///< share of a displacement by which a line may lie off its way
constexpr double most_way = 0.85;  ///< share of a line's piece that a junction may run along
constexpr double fade_length = 10; ///< per size of the correction

/// The other lines as rails that begin at the vertices of the moving one.
FeatureRails rails_from(const Mesh& mesh, const std::vector<VertexPair>& features, const std::vector<int>& line)
{
    std::vector<char> given(mesh.V.rows(), 0);
    for (const int v : line) {
        given[v] = 1;
    }
    return {mesh, features, given};
}

/// New target of the junction at v; nothing where no line runs its way. `beyond`: unit tangent along which the target
/// may be prolonged, or zero.
Result<std::optional<Vec3>> carried(const Mesh& mesh, const FeatureRails& rails, int v, const Vec3& target,
                                    const Vec3& beyond)
{
    const Vec3 rest = mesh.V.row(v);
    const double size = (target - rest).norm();
    std::optional<Vec3> best;
    double least = most_off * size;
    for (const RailPiece& piece : rails.pieces(v)) {
        const RailFoot foot = nearest_on(piece, target, beyond);
        const double off = (foot.point - target).norm();
        if (!(off < least) || foot.arc == 0) {
            continue;
        }
        if (foot.arc > most_way * piece.length()) {
            return fail(ErrorKind::rejected,
                        fmt::format("the line's vertex {} at ({:.6g}, {:.6g}, {:.6g}) mm would slide {:.4g} mm along "
                                    "another feature line that ends or turns after {:.4g} mm: shorten the slide there",
                                    v, rest.x(), rest.y(), rest.z(), size, piece.length()));
        }
        least = off;
        best = foot.point;
    }
    return best;
}

/// Lays the target near a junction on its shifted place: arc length s from the junction, correction c.
double fade(double s, double reach)
{
    const double x = std::clamp(s / reach, 0.0, 1.0);
    return (1 - x) * (1 - x) * (1 + 2 * x);
}

} // namespace

Result<void> carry_junctions(const Mesh& mesh, const std::vector<VertexPair>& features, const TargetCurve& target,
                             Correspondence& c)
{
    const std::vector<int>& line = c.line.vertices;
    const FeatureRails rails = rails_from(mesh, features, line);
    const int n = static_cast<int>(line.size());
    if (rails.empty() || n < 2) {
        return {};
    }
    std::vector<double> arc{0};
    for (int i = 1; i < n; ++i) {
        arc.push_back(arc.back() + (mesh.V.row(line[i]) - mesh.V.row(line[i - 1])).norm());
    }
    std::vector<std::pair<int, Vec3>> corrections;
    for (int i = 0; i < n; ++i) {
        const Vec3 along = (c.targets[std::min(i + 1, n - 1)] - c.targets[std::max(i - 1, 0)]).normalized();
        const auto place = carried(mesh, rails, line[i], c.targets[i], along);
        if (!place) {
            return tl::unexpected(place.error());
        }
        if (*place) {
            corrections.emplace_back(i, **place - c.targets[i]);
        }
    }
    for (size_t k = 0; k < corrections.size(); ++k) {
        const auto& [at, shift] = corrections[k];
        const double before = k > 0 ? 0.5 * (arc[at] - arc[corrections[k - 1].first]) : arc[at];
        const double after =
            k + 1 < corrections.size() ? 0.5 * (arc[corrections[k + 1].first] - arc[at]) : arc.back() - arc[at];
        for (int i = 0; i < n; ++i) {
            const double room = i < at ? before : after, s = std::abs(arc[i] - arc[at]);
            const double left = i == at ? 1 : fade(s, std::min(room, fade_length * shift.norm()));
            if (!(left > 0) || (i != at && !(room > 0))) {
                continue;
            }
            const Vec3 shifted = c.targets[i] + left * shift;
            const CurveFoot foot = target.foot(shifted);
            c.targets[i] = i == at || foot.at_end ? shifted : foot.point;
            c.displacements[i] = c.targets[i] - Vec3(mesh.V.row(line[i]));
        }
    }
    return {};
}

Result<void> carry_extension(ExtendedLine& extended)
{
    const Mesh& mesh = extended.model.mesh;
    const FeatureRails rails = rails_from(mesh, extended.features, extended.vertices);
    for (int i = 0; i < static_cast<int>(extended.vertices.size()) && !rails.empty(); ++i) {
        const bool used = i >= extended.first && i <= extended.last;
        if (used || !extended.targets[i].allFinite()) {
            continue;
        }
        const auto place = carried(mesh, rails, extended.vertices[i], extended.targets[i], Vec3::Zero());
        if (!place) {
            return tl::unexpected(place.error());
        }
        extended.targets[i] = place->value_or(extended.targets[i]);
    }
    return {};
}

} // namespace tapeline
