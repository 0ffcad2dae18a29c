// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/border_slide.h"
#include "tests/support/moves.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 8, ny = 20;

struct Case {
    Model model = model_of(grid(nx, ny, 0, 80, -100, 100, [](double, double) { return 0.0; }));
    Topology topology{model.mesh.F, static_cast<int>(model.mesh.V.rows())};
    Region region = whole_model(model);
    int end = ny / 2 * (nx + 1); ///< on the border x = 0, at y = 0
};

} // namespace

TEST(BorderSlide, StretchesOneSideAndSqueezesTheOtherLinearly)
{
    const Case c;
    const auto slide = slide_border(c.model.mesh, c.topology, c.region, c.end, Vec3(0, 30, 0));
    ASSERT_TRUE(slide) << slide.error().message;
    // Both ways to the corners, without the end and without the corners.
    EXPECT_EQ(slide->vertices.size(), static_cast<size_t>(ny - 2));
    for (size_t i = 0; i < slide->vertices.size(); ++i) {
        const double y = c.model.mesh.V(slide->vertices[i], 1);
        const double wanted = y + 30 * (1 - std::abs(y) / 100);
        EXPECT_NEAR(slide->targets[i].y(), wanted, 1e-12);
        EXPECT_NEAR(slide->targets[i].x(), 0, 1e-12);
    }
}

TEST(BorderSlide, FadesWhatLiesOffTheBorder)
{
    const Case c;
    const auto slide = slide_border(c.model.mesh, c.topology, c.region, c.end, Vec3(-5, 30, 0));
    ASSERT_TRUE(slide);
    for (size_t i = 0; i < slide->vertices.size(); ++i) {
        const double y = c.model.mesh.V(slide->vertices[i], 1);
        EXPECT_NEAR(slide->targets[i].x(), -5 * (1 - std::abs(y) / 100), 1e-12);
    }
}

TEST(BorderSlide, RefusesATargetBeyondTheCorner)
{
    const Case c;
    const auto slide = slide_border(c.model.mesh, c.topology, c.region, c.end, Vec3(0, 120, 0));
    ASSERT_FALSE(slide);
    EXPECT_NE(slide.error().message.find("widen the region"), std::string::npos) << slide.error().message;
}
