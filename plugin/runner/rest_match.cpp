// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/rest_match.h"

#include "kernel/closest_point.h"
#include "kernel/parallel.h"
#include "kernel/topology.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// Same triangles in the same order: each vertex of `moved` is the one at the same corner before.
bool match_corners(const Mesh& moved, const Mesh& before, Positions& V)
{
    if (moved.F.rows() != before.F.rows() || moved.V.rows() != before.V.rows()) {
        return false;
    }
    std::vector<int> partner(moved.V.rows(), -1), back(before.V.rows(), -1);
    for (Eigen::Index t = 0; t < moved.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int v = moved.F(t, k), w = before.F(t, k);
            if ((partner[v] >= 0 && partner[v] != w) || (back[w] >= 0 && back[w] != v)) {
                return false;
            }
            partner[v] = w;
            back[w] = v;
        }
    }
    V.resize(moved.V.rows(), 3);
    for (Eigen::Index v = 0; v < V.rows(); ++v) {
        V.row(v) = before.V.row(partner[v] >= 0 ? partner[v] : v);
    }
    return true;
}

bool same_place(const Mesh& moved, const Mesh& before, int v) { return moved.V.row(v) == before.V.row(v); }

/// Most vertices of a move do not move; two meshes that only happen to have equal counts agree nowhere.
bool numbered_alike(const Mesh& moved, const Mesh& before)
{
    int same = 0;
    const int n = static_cast<int>(before.V.rows());
    for (int v = 0; v < n; ++v) {
        same += same_place(moved, before, v) ? 1 : 0;
    }
    return same >= std::max(3, n / 50);
}

/// The two ends of the removed edge on which an appended vertex was put: neighbours that were joined before and are
/// not any more. The first such pair in ascending order.
AppendedVertex removed_edge(const Mesh& moved, const Topology& now, const Topology& then, int v)
{
    std::vector<int> old;
    for (const int e : now.vertex_edges(v)) {
        const int w = now.other_end(e, v);
        if (w < then.vertex_count()) {
            old.push_back(w);
        }
    }
    std::ranges::sort(old);
    for (std::size_t j = 0; j < old.size(); ++j) {
        for (std::size_t k = j + 1; k < old.size(); ++k) {
            if (then.find_edge(old[j], old[k]) >= 0 && now.find_edge(old[j], old[k]) < 0) {
                const double to_a = (moved.V.row(v) - moved.V.row(old[j])).norm();
                const double to_b = (moved.V.row(v) - moved.V.row(old[k])).norm();
                return {old[j], old[k], to_a / std::max(to_a + to_b, 1e-300)};
            }
        }
    }
    return {};
}

/// Rest positions with the first rows copied and the appended ones put on their edges.
bool match_appended(const Mesh& moved, const Mesh& before, const std::vector<AppendedVertex>& appended,
                    RestMatch& match)
{
    const auto n = before.V.rows();
    const auto added = moved.V.rows() - n;
    const bool told = static_cast<Eigen::Index>(appended.size()) == added;
    const Topology now(moved.F, static_cast<int>(moved.V.rows()));
    const Topology then(before.F, static_cast<int>(n));
    match.V.resize(moved.V.rows(), 3);
    match.V.topRows(n) = before.V;
    for (Eigen::Index k = 0; k < added; ++k) {
        const AppendedVertex from = told ? appended[k] : removed_edge(moved, now, then, static_cast<int>(n + k));
        if (from.a < 0 || from.b < 0 || from.a >= n + k || from.b >= n + k) {
            match.how = fmt::format("vertex {} of the moved mesh lies on no edge of the mesh before", n + k);
            return false;
        }
        match.V.row(n + k) = (1 - from.t) * match.V.row(from.a) + from.t * match.V.row(from.b);
    }
    match.exact = told;
    return true;
}

} // namespace

Model with_cad_faces(Mesh rest, const Model& before)
{
    Model model{std::move(rest), {}, {}, before.surface};
    if (!before.surface || before.cad_face.empty()) {
        return model;
    }
    const Triangles& F = model.mesh.F;
    if (F.rows() == before.mesh.F.rows() && F == before.mesh.F) {
        model.cad_face = before.cad_face;
        return model;
    }
    const ClosestPoint triangles(before.mesh);
    model.cad_face.resize(F.rows());
    parallel_for(static_cast<int>(F.rows()), [&](int t) {
        const Positions& V = model.mesh.V;
        const Vec3 centre = (V.row(F(t, 0)) + V.row(F(t, 1)) + V.row(F(t, 2))) / 3;
        const int face = triangles.closest(centre).face;
        model.cad_face[t] = face < 0 ? -1 : before.cad_face[face];
    });
    return model;
}

RestMatch match_rest(const Mesh& moved, const Mesh& before, const std::vector<AppendedVertex>& appended)
{
    RestMatch match;
    if (match_corners(moved, before, match.V)) {
        match.found = true;
        match.how = "same triangles before and after";
        return match;
    }
    if (moved.V.rows() < before.V.rows() || !numbered_alike(moved, before)) {
        match.how = "the two meshes have different triangles";
        return match;
    }
    if (!match_appended(moved, before, appended, match)) {
        return match;
    }
    match.found = true;
    const auto added = moved.V.rows() - before.V.rows();
    match.how = added == 0 ? "same vertices before and after"
                           : fmt::format("{} vertices were appended where the line's extension cuts triangles{}", added,
                                         match.exact ? "" : "; their places before are estimated (--stats gives them)");
    return match;
}

} // namespace tapeline
