// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/rim.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// The part of the crease panel with |x| < 200 and 0 < y < 200: its rim runs along the crease, and inside the panel
/// elsewhere.
struct CreaseRim {
    Model model = model_of(crease_panel(40, 30));
    Region region;
    CreaseRim()
    {
        std::vector<int> faces;
        for (int t = 0; t < model.mesh.F.rows(); ++t) {
            Vec3 centre = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                centre += model.mesh.V.row(model.mesh.F(t, k)) / 3;
            }
            if (std::abs(centre.x()) < 200 && centre.y() > 0 && centre.y() < 200) {
                faces.push_back(t);
            }
        }
        region = region_of_faces(model, faces, false, {});
    }
};

} // namespace

TEST(Rim, TiltsByDefaultOnlyOnTheExistingCrease)
{
    const CreaseRim rim;
    const std::vector<int> tilting = tilting_rim(rim.model, rim.region, RimControl::automatic, 5);
    ASSERT_FALSE(tilting.empty());
    for (const int v : rim.region.fixed_rim) {
        EXPECT_EQ(std::ranges::binary_search(tilting, v), rim.model.mesh.V(v, 1) == 0) << v;
    }
    // Where the lower threshold lies above the crease's 12 degrees, it is no feature line.
    EXPECT_TRUE(tilting_rim(rim.model, rim.region, RimControl::automatic, 15).empty());
}

TEST(Rim, TiltsOnOpenBorders)
{
    const Model model = model_of(crease_panel(12, 10));
    const Region region = line_across(model.mesh, crease_panel_line(12, 10)).region;
    EXPECT_EQ(tilting_rim(model, region, RimControl::automatic, 5), region.fixed_rim);
}

TEST(Rim, TiltsEverywhereOrNowhereWhenAsked)
{
    const CreaseRim rim;
    EXPECT_EQ(tilting_rim(rim.model, rim.region, RimControl::position, 5), rim.region.fixed_rim);
    EXPECT_TRUE(tilting_rim(rim.model, rim.region, RimControl::tangent, 5).empty());
}

TEST(Rim, TellsTheCreaseThatItRanAlongFromNewOnes)
{
    const CreaseRim rim;
    const Mesh& rest = rim.model.mesh;
    const double slope = std::tan(3 * M_PI / 180);
    // Tilts the surface about the crease by 3 degrees in the middle, and meets the other three sides of the rim smoothly.
    Positions moved = rest.V;
    for (int v = 0; v < moved.rows(); ++v) {
        const double x = moved(v, 0) / 200, y = moved(v, 1) / 200;
        if (std::abs(x) < 1 && y > 0 && y < 1) {
            moved(v, 2) += slope * 200 * y * std::pow(1 - y, 2) * std::pow(1 - x * x, 2);
        }
    }
    const RimChanges changes = rim_changes(rim.model, moved, rim.region, 5);
    EXPECT_NEAR(changes.creased.at_rest, 12, 0.6);
    const double first_row = std::pow(1 - 0.1, 2); // a tenth of the way across
    EXPECT_NEAR(changes.creased.max, 3 * first_row, 0.1);
    EXPECT_NEAR(changes.creased.mean, 3 * first_row * 8 / 15, 0.05); // the mean of (1 - x²)²
    EXPECT_LT(changes.smooth.max, 0.6);
    EXPECT_LT(changes.smooth.at_rest, 1);
    // Where a crease must be sharper than this one, all of it is the surface's own.
    const RimChanges blunt = rim_changes(rim.model, moved, rim.region, 15);
    EXPECT_EQ(blunt.creased.max, 0);
    EXPECT_EQ(blunt.smooth.max, changes.creased.max);
}
