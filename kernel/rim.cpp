// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/rim.h"

#include "kernel/crease_edges.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tapeline {

namespace {

/// Calls `visit` with each rim edge, borders of the model included, and whether it is a crease.
void visit_rim(const Model& model, const Region& region, double crease_angle,
               const std::function<void(const MeshEdge&, bool)>& visit)
{
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    std::vector<char> inside(model.mesh.F.rows(), 0);
    for (const int t : region.faces) {
        inside[t] = 1;
    }
    const std::vector<CreaseLevel> creases = crease_edges(model, topology, crease_angle, crease_angle);
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        const bool left = edge.left >= 0 && inside[edge.left], right = edge.right >= 0 && inside[edge.right];
        if (left != right) {
            visit(edge, creases[e] != CreaseLevel::none);
        }
    }
}

} // namespace

std::vector<int> tilting_rim(const Model& model, const Region& region, RimControl control, double crease_angle)
{
    if (control != RimControl::automatic) {
        return control == RimControl::position ? region.fixed_rim : std::vector<int>{};
    }
    std::vector<int> tilting;
    visit_rim(model, region, crease_angle, [&](const MeshEdge& edge, bool crease) {
        if (edge.face_count != 2 || crease) {
            tilting.push_back(edge.a);
            tilting.push_back(edge.b);
        }
    });
    std::ranges::sort(tilting);
    tilting.erase(std::unique(tilting.begin(), tilting.end()), tilting.end());
    std::erase_if(tilting, [&](int v) { return !std::ranges::binary_search(region.fixed_rim, v); });
    return tilting;
}

RimChanges rim_changes(const Model& rest, const Positions& moved, const Region& region, double crease_angle)
{
    const Mesh after{moved, rest.mesh.F};
    RimChanges changes;
    double smooth_length = 0, creased_length = 0;
    visit_rim(rest, region, crease_angle, [&](const MeshEdge& edge, bool crease) {
        if (edge.left < 0 || edge.right < 0) {
            return;
        }
        RimChange& change = crease ? changes.creased : changes.smooth;
        const double angle = signed_bend(rest.mesh, edge);
        const double difference = std::abs(std::remainder(signed_bend(after, edge) - angle, 360));
        const double length = (rest.mesh.V.row(edge.b) - rest.mesh.V.row(edge.a)).norm();
        (crease ? creased_length : smooth_length) += length;
        change.mean += length * difference;
        change.at_rest += length * std::abs(angle);
        change.max = std::max(change.max, difference);
    });
    for (auto [change, length] : {std::pair{&changes.smooth, smooth_length}, {&changes.creased, creased_length}}) {
        change->mean /= std::max(length, 1e-300);
        change->at_rest /= std::max(length, 1e-300);
    }
    return changes;
}

} // namespace tapeline
