// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/rim_band.h"

#include "kernel/geodesic_distance.h"

#include <algorithm>
#include <iterator>

namespace tapeline {

namespace {

/// Of the distance to what moves, so that a third of the way from rim to line belongs to the band.
constexpr double share_of_way = 0.5;

std::vector<double> distances_from(const Mesh& mesh, const Topology& topology, const std::vector<int>& vertices)
{
    std::vector<DistanceSeed> seeds;
    for (const int v : vertices) {
        seeds.push_back({v, 0, mesh.V.row(v)});
    }
    return geodesic_distance(mesh, topology, seeds);
}

} // namespace

std::vector<int> rim_band(const SideMesh& part, const std::vector<int>& line, const std::vector<int>& rim,
                          const std::vector<int>& tilting, double width_mm)
{
    const Mesh inner{part.mesh.V, part.mesh.F.topRows(part.inner_faces)};
    const Topology topology(inner.F, static_cast<int>(inner.V.rows()));
    std::vector<int> tangent, held;
    for (const int v : part.fixed) {
        const int global = part.to_global[v];
        if (!std::ranges::binary_search(rim, global)) {
            if (!topology.vertex_faces(v).empty()) {
                held.push_back(v);
            }
        } else if (!std::ranges::binary_search(tilting, global)) {
            tangent.push_back(v);
        }
    }
    // Where the line ends on the rim, the rim holds, not the line.
    std::ranges::copy_if(line, std::back_inserter(held),
                         [&](int v) { return !std::ranges::binary_search(rim, part.to_global[v]); });
    std::vector<int> band;
    if (tangent.empty()) {
        return band;
    }
    const std::vector<double> to_rim = distances_from(inner, topology, tangent),
                              to_line = distances_from(inner, topology, held);
    std::vector<char> given(inner.V.rows(), 0);
    for (const std::vector<int>* list : {&part.fixed, &part.line, &part.guided}) {
        for (const int v : *list) {
            given[v] = 1;
        }
    }
    for (int v = 0; v < inner.V.rows(); ++v) {
        if (!given[v] && to_rim[v] <= share_of_way * to_line[v] && (width_mm == 0 || to_rim[v] < width_mm)) {
            band.push_back(v);
        }
    }
    return band;
}

PlateSupport outside_band(const SideMesh& part, const std::vector<int>& band, const Positions& moved)
{
    PlateSupport support;
    std::vector<char> free(moved.rows(), 0);
    for (const int v : band) {
        free[v] = 1;
    }
    for (int v = 0; v < moved.rows(); ++v) {
        if (!free[v]) {
            support.constrained.push_back(v);
        }
    }
    support.targets.resize(static_cast<Eigen::Index>(support.constrained.size()), 3);
    for (size_t i = 0; i < support.constrained.size(); ++i) {
        support.targets.row(static_cast<Eigen::Index>(i)) = moved.row(support.constrained[i]);
    }
    support.free_slope = part.line;
    return support;
}

} // namespace tapeline
