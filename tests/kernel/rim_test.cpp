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
