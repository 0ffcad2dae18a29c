// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/split.h"
#include "tests/support/moves.h"

#include <gtest/gtest.h>
#include <set>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 12, ny = 8;

ExtendedLine panel_cut()
{
    const Model model = model_of(crease_panel(nx, ny));
    const FeatureLine line = line_of(model, crease_panel_line(nx, ny));
    return already_extended(model, sends(model, line, std::vector<Vec3>(line.vertices.size(), Vec3::Zero())));
}

} // namespace

TEST(Split, PutsEveryRegionTriangleOnExactlyOneSide)
{
    const ExtendedLine extended = panel_cut();
    const auto sides = split_along(extended);
    ASSERT_TRUE(sides) << sides.error().message;
    std::multiset<int> faces;
    for (const SideMesh& side : *sides) {
        faces.insert(side.global_faces.begin(), side.global_faces.begin() + side.inner_faces);
    }
    EXPECT_EQ(std::vector<int>(faces.begin(), faces.end()), extended.region.faces);
}

TEST(Split, PutsTheLeftOfTheLineFirst)
{
    const auto sides = split_along(panel_cut());
    ASSERT_TRUE(sides);
    // The line runs along +x on a panel that faces +z, so its left is +y.
    EXPECT_GE((*sides)[0].mesh.V.col(1).minCoeff(), 0);
    EXPECT_LE((*sides)[1].mesh.V.col(1).maxCoeff(), 0);
}

TEST(Split, FixesTheRimButNotTheLine)
{
    const auto sides = split_along(panel_cut());
    ASSERT_TRUE(sides);
    for (const SideMesh& side : *sides) {
        // Three sides of the half panel, without the two line ends.
        EXPECT_EQ(side.fixed.size(), static_cast<size_t>(nx + 1 + 2 * (ny / 2 - 1)));
        EXPECT_EQ(side.line.size(), static_cast<size_t>(nx + 1));
    }
}

TEST(Split, RefusesALineThatDoesNotPartTheRegion)
{
    const Model model = model_of(crease_panel(nx, ny));
    std::vector<int> part = crease_panel_line(nx, ny);
    part.resize(part.size() - 3);
    const FeatureLine line = line_of(model, part);
    const auto sides =
        split_along(already_extended(model, sends(model, line, std::vector<Vec3>(part.size(), Vec3::Zero()))));
    ASSERT_FALSE(sides);
    EXPECT_EQ(sides.error().kind, ErrorKind::rejected);
    EXPECT_NE(sides.error().message.find("does not part the region"), std::string::npos) << sides.error().message;
}

TEST(Split, KeepsOneRingOutsideTheRimInTheEnergy)
{
    const Model model = model_of(crease_panel(nx, ny));
    ExtendedLine extended = panel_cut();
    // A region that leaves out the outermost cells at y = ±300.
    std::vector<int> faces;
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        double reach = 0;
        for (int k = 0; k < 3; ++k) {
            reach = std::max(reach, std::abs(model.mesh.V(model.mesh.F(t, k), 1)));
        }
        if (reach < 299) {
            faces.push_back(t);
        }
    }
    extended.region = region_of_faces(model, faces, false, {});
    const auto without = split_along(extended, 0), with = split_along(extended, 1);
    ASSERT_TRUE(without);
    ASSERT_TRUE(with);
    EXPECT_EQ((*without)[0].mesh.F.rows(), (*without)[0].inner_faces);
    EXPECT_EQ((*with)[0].mesh.F.rows(), (*with)[0].inner_faces + 2 * nx);
    EXPECT_GT((*with)[0].fixed.size(), (*without)[0].fixed.size());
}

TEST(Sew, WritesFreeVerticesAndLeavesFixedOnesAlone)
{
    const ExtendedLine extended = panel_cut();
    const auto sides = split_along(extended);
    ASSERT_TRUE(sides);
    const SideMesh& side = (*sides)[0];
    Positions V = extended.model.mesh.V;
    Positions moved = side.mesh.V;
    moved.array() += 1;
    sew(side, moved, V);
    for (size_t i = 0; i < side.to_global.size(); ++i) {
        const bool fixed = std::ranges::count(side.fixed, static_cast<int>(i)) > 0;
        const auto before = extended.model.mesh.V.row(side.to_global[i]);
        EXPECT_EQ(V.row(side.to_global[i]) == before, fixed);
    }
}
