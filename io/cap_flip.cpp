// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cap_flip.h"

#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <set>

namespace tapeline {

namespace {

double altitude_ratio(const Positions& V, int a, int b, int c)
{
    const Vec3 p = V.row(a), q = V.row(b), r = V.row(c);
    const double longest = std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
    return longest > 0 ? (q - p).cross(r - p).norm() / longest : 0;
}

/// The side (k, k+1) of a cap that its third corner lies on; empty when the triangle has area or two corners coincide.
std::optional<int> cap_side(const Mesh& mesh, int t)
{
    constexpr double flat = 1e-9; // altitude over longest side
    if (altitude_ratio(mesh.V, mesh.F(t, 0), mesh.F(t, 1), mesh.F(t, 2)) > flat) {
        return std::nullopt;
    }
    int longest = 0;
    double square[3];
    for (int k = 0; k < 3; ++k) {
        square[k] = (mesh.V.row(mesh.F(t, (k + 1) % 3)) - mesh.V.row(mesh.F(t, k))).squaredNorm();
        longest = square[k] > square[longest] ? k : longest;
    }
    const double shortest = *std::ranges::min_element(square);
    return shortest > flat * flat * square[longest] ? std::optional(longest) : std::nullopt;
}

} // namespace

int flip_caps(Model& model)
{
    Triangles& F = model.mesh.F;
    int found = 0, left = 0;
    for (int pass = 0; pass < 100; ++pass) {
        std::vector<std::pair<int, int>> caps; // triangle, side
        for (int t = 0; t < F.rows(); ++t) {
            if (const auto side = cap_side(model.mesh, t)) {
                caps.emplace_back(t, *side);
            }
        }
        left = static_cast<int>(caps.size());
        found = pass == 0 ? left : found;
        if (caps.empty()) {
            break;
        }
        const Topology topology(F, static_cast<int>(model.mesh.V.rows()));
        std::set<int> touched;
        for (const auto& [t, side] : caps) {
            const int x = F(t, side), y = F(t, (side + 1) % 3), m = F(t, (side + 2) % 3);
            const int e = topology.find_edge(x, y);
            const int other = e < 0 ? -1 : topology.face_across(t, e);
            const CadEdgeTag first_tag{std::min(x, y), std::max(x, y), -1};
            const auto tag = std::ranges::lower_bound(model.cad_edges, first_tag);
            const bool on_cad_edge = tag != model.cad_edges.end() && tag->a == first_tag.a && tag->b == first_tag.b;
            if (other < 0 || on_cad_edge || touched.contains(t) || touched.contains(other) ||
                (!model.cad_face.empty() && model.cad_face[t] != model.cad_face[other])) {
                continue;
            }
            int d = -1;
            for (int k = 0; k < 3; ++k) {
                d = F(other, k) != x && F(other, k) != y ? F(other, k) : d;
            }
            if (d < 0 || d == m || topology.find_edge(m, d) >= 0) {
                continue;
            }
            F.row(t) << m, x, d;
            F.row(other) << m, d, y;
            touched.insert({t, other});
        }
        if (touched.empty()) {
            break;
        }
    }
    return found - left;
}

} // namespace tapeline
