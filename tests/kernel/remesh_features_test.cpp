// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/remesh_features.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::vector<VertexPair> kept_of(const Mesh& mesh, double crease_angle)
{
    RemeshOptions options;
    options.max_edge_mm = 1;
    options.crease_angle = crease_angle;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    return kept_edges(model_of(mesh), topology, std::vector<char>(mesh.F.rows(), 1), options);
}

} // namespace

TEST(KeptEdges, AreNotTheFacetsOfATessellatedCylinder)
{
    // 64 facets turn by 5.6 degrees each, as round parts come in mesh files.
    constexpr int facets = 64;
    EXPECT_EQ(kept_of(cylinder(facets, 6, 10, 30), 5).size(), 2U * facets) << "the two rims and nothing else";
}

TEST(KeptEdges, AreCreasesThatStandOut)
{
    // A gentle arch with a kink of 12 degrees along y = 0.
    const auto arch = [](double, double y) { return -y * y / 1000 - std::abs(y) * std::tan(6 * M_PI / 180); };
    const Mesh mesh = grid(10, 8, 0, 100, -40, 40, arch);
    EXPECT_EQ(kept_of(mesh, 5).size(), 2U * (10 + 8) + 10U) << "the rim and the kink";
    EXPECT_EQ(kept_of(mesh, 20).size(), 2U * (10 + 8)) << "the rim only";
}
