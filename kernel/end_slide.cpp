// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/end_slide.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapeline {

namespace {

/// The shift fades out along Lt over this many times its size.
constexpr double fading = 6;
/// Directions are taken of chords this many mean edges of the line long: those of single edges tell more of the facets
/// that they are laid on.
constexpr double chord = 3;
/// Of the least sum, what it has to fall by for the end to move at all.
constexpr double worth_it = 0.1;

/// One end of the line that may slide.
struct End {
    bool after;
    double inwards;   ///< sense of growing arc length of Lt towards the line's middle: 1 or -1
    double least = 0; ///< range of the slide [mm]
    double most = 0;
};

End end_of(const Correspondence& c, const TargetCurve& target, bool after, double length_mm)
{
    const double first = target.arc_length(c.parameters.front()), last = target.arc_length(c.parameters.back());
    const double sense = last > first ? 1 : -1, at = after ? last : first;
    End end{.after = after, .inwards = after ? -sense : sense};
    const double outwards = end.inwards > 0 ? at : target.length() - at;
    end.most = std::min(length_mm, std::abs(last - first) / fading);
    end.least = -std::min(end.most, outwards);
    return end;
}

Correspondence shifted(const Correspondence& c, const Positions& V, const TargetCurve& target, const End& end, double d)
{
    Correspondence result = c;
    const double from = target.arc_length(end.after ? c.parameters.back() : c.parameters.front());
    for (size_t k = 0; k < c.parameters.size(); ++k) {
        const double arc = target.arc_length(c.parameters[k]), x = std::abs(arc - from) / (fading * std::abs(d));
        if (!(x < 1)) {
            continue;
        }
        const double shift = d * (1 - x) * (1 - x) * (1 + 2 * x);
        result.parameters[k] = target.parameter_at(arc + end.inwards * shift);
        // What stood off Lt, at junctions, goes on standing off.
        const Vec3 off = c.targets[k] - target.point(c.parameters[k]);
        result.targets[k] = target.point(result.parameters[k]) + off;
        result.displacements[k] = result.targets[k] - Vec3(V.row(c.line.vertices[k]));
        result.tangents[k] = (c.reversed ? -1 : 1) * target.tangent(result.parameters[k]);
    }
    return result;
}

/// Σ |e_k - e_{k-1}|² / h over chords of two polylines whose points belong together, at even steps of the first one's
/// length, about `spacing` long.
double turning(const std::vector<Vec3>& rest, const std::vector<Vec3>& moved, double spacing)
{
    std::vector<double> way{0};
    for (size_t i = 1; i < rest.size(); ++i) {
        way.push_back(way.back() + (rest[i] - rest[i - 1]).norm());
    }
    const int steps = std::max(2, static_cast<int>(way.back() / spacing));
    const double h = way.back() / steps;
    std::array<Vec3, 2> last{rest.front(), moved.front()};
    Vec3 before = Vec3::Zero();
    double sum = 0;
    size_t i = 1;
    for (int k = 1; k <= steps; ++k) {
        while (i + 1 < way.size() && way[i] < k * h) {
            ++i;
        }
        const double share = std::min(1.0, (k * h - way[i - 1]) / (way[i] - way[i - 1]));
        const std::array<Vec3, 2> next{rest[i - 1] + share * (rest[i] - rest[i - 1]),
                                       moved[i - 1] + share * (moved[i] - moved[i - 1])};
        const Vec3 turned = (next[1] - last[1]).normalized() - (next[0] - last[0]).normalized();
        sum += k > 1 ? (turned - before).squaredNorm() / h : 0;
        before = turned;
        last = next;
    }
    return sum;
}

/// The sum that is minimised; infinite where the prolongation has no room.
double unevenness(const ExtendedLine& extended, const ExtensionTargets& prolongation, const TargetCurve& target,
                  const Correspondence& c, const End& end)
{
    const Positions& V = extended.model.mesh.V;
    const auto beyond = prolongation.beyond(c, end.after);
    if (!beyond) {
        return std::numeric_limits<double>::infinity();
    }
    std::vector<Vec3> rest, moved;
    const std::vector<int> entries = prolongation.entries(end.after);
    for (size_t i = entries.size(); i-- > 1;) {
        rest.push_back(V.row(extended.vertices[entries[i]]));
        moved.push_back((*beyond)[i]);
    }
    double way = 0;
    const size_t n = c.line.vertices.size();
    const double spacing = chord *
                           std::abs(target.arc_length(c.parameters.back()) - target.arc_length(c.parameters.front())) /
                           static_cast<double>(n);
    for (size_t i = 0; i < n && way <= fading * end.most; ++i) {
        const size_t k = end.after ? n - 1 - i : i;
        rest.push_back(V.row(c.line.vertices[k]));
        moved.push_back(c.targets[k]);
        way += i > 0 ? (rest.back() - rest[rest.size() - 2]).norm() : 0;
    }
    return turning(rest, moved, spacing);
}

/// The slide of least unevenness: the best of even samples, then halved in on.
template <class Unevenness>
double least_uneven(const End& end, const Unevenness& at)
{
    constexpr int samples = 8, halvings = 5;
    double best = 0, least = at(0);
    const double stay = least;
    const auto look = [&](double d) {
        if (d < end.least || d > end.most) {
            return;
        }
        if (const double found = at(d); found < least) {
            least = found;
            best = d;
        }
    };
    double step = (end.most - end.least) / samples;
    for (int i = 0; i <= samples; ++i) {
        look(end.least + i * step);
    }
    for (int i = 0; i < halvings; ++i) {
        step /= 2;
        const double middle = best;
        look(middle - step);
        look(middle + step);
    }
    return least < (1 - worth_it) * stay ? best : 0;
}

bool at_junction(const ExtendedLine& extended, int v)
{
    return std::ranges::any_of(extended.features, [v](const VertexPair& e) { return e[0] == v || e[1] == v; });
}

} // namespace

Result<EndSlide> slide_ends(ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                            const TargetCurve& target, const ExtensionOptions& options, double length_mm,
                            Correspondence& correspondence)
{
    EndSlide slide{0, 0};
    if (extended.closed || target.closed() || options.target == ExtensionTarget::free || !(length_mm > 0)) {
        return slide;
    }
    const Positions& V = extended.model.mesh.V;
    const ExtensionTargets prolongation(extended, rest, faces, options);
    for (const bool after : {false, true}) {
        const int v = after ? correspondence.line.vertices.back() : correspondence.line.vertices.front();
        const End end = end_of(correspondence, target, after, length_mm);
        if (prolongation.entries(after).size() < 2 || at_junction(extended, v) || !(end.most > end.least)) {
            continue;
        }
        const Correspondence& c = correspondence;
        const double d = least_uneven(end, [&](double shift) {
            return unevenness(extended, prolongation, target, shift == 0 ? c : shifted(c, V, target, end, shift), end);
        });
        if (d != 0) {
            correspondence = shifted(c, V, target, end, d);
            slide[after ? 1 : 0] = d;
        }
    }
    return set_targets(extended, prolongation, correspondence).map([&] { return slide; });
}

} // namespace tapeline
