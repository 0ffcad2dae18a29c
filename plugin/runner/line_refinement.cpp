// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/line_refinement.h"

#include "kernel/curve.h"
#include "kernel/edge_split.h"

#include <algorithm>

namespace tapeline {

namespace {

double edge_length(const Mesh& mesh, int a, int b) { return (mesh.V.row(a) - mesh.V.row(b)).norm(); }

/// Puts the vertices from number `first` on back onto the exact CAD edges that they lie on.
void project_new_vertices(Model& model, int first)
{
    if (!model.surface) {
        return;
    }
    for (const CadEdgeTag& tag : model.cad_edges) {
        // b is the larger number of the two, and new vertices are never neighbours of each other.
        if (tag.b >= first) {
            const Vec3 p = model.mesh.V.row(tag.b);
            if (const auto foot = model.surface->closest_on_edge(tag.cad_edge, p)) {
                model.mesh.V.row(tag.b) = *foot;
            }
        }
    }
}

} // namespace

double longest_edge(const Mesh& mesh, const FeatureLine& line)
{
    double longest = 0;
    const std::size_t n = line.vertices.size();
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < n; ++k) {
        longest = std::max(longest, edge_length(mesh, line.vertices[k], line.vertices[(k + 1) % n]));
    }
    return longest;
}

Result<RefinedLine> refine_line(const Model& model, const FeatureLine& line, double longest)
{
    constexpr int most_rounds = 12;
    RefinedLine refined{model, line};
    std::vector<int> chain = line.vertices;
    if (line.closed) {
        chain.push_back(chain.front());
    }
    for (int round = 0; round < most_rounds; ++round) {
        const int first_new = static_cast<int>(refined.model.mesh.V.rows());
        std::vector<EdgePoint> points;
        std::vector<int> next = {chain.front()};
        for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
            if (edge_length(refined.model.mesh, chain[k], chain[k + 1]) > longest) {
                next.push_back(first_new + static_cast<int>(points.size()));
                points.push_back({chain[k], chain[k + 1], 0.5});
            }
            next.push_back(chain[k + 1]);
        }
        if (points.empty()) {
            break;
        }
        refined.model = split_edges(refined.model, points).model;
        project_new_vertices(refined.model, first_new);
        chain = std::move(next);
    }
    return line_through(refined.model, std::move(chain)).map([&](FeatureLine whole) {
        whole.id = line.id;
        refined.line = std::move(whole);
        return std::move(refined);
    });
}

bool remeshes(const Model& model, const RemeshSettings& settings)
{
    const bool asked = !model.cad_face.empty() || settings.max_edge > 0;
    return settings.remesh == "on" || (settings.remesh == "auto" && asked);
}

Result<std::optional<RefinedLine>> refine_before_choice(const Model& model, const FeatureLine& whole,
                                                        const RemeshSettings& settings)
{
    constexpr double least_edges = 20, wanted_edges = 60;
    if (!remeshes(model, settings) || longest_edge(model.mesh, whole) <= whole.length_mm / least_edges) {
        return std::nullopt;
    }
    const double longest = settings.max_edge > 0 ? settings.max_edge : whole.length_mm / wanted_edges;
    return refine_line(model, whole, longest).map([](RefinedLine refined) {
        return std::optional<RefinedLine>(std::move(refined));
    });
}

} // namespace tapeline
