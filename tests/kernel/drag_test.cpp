// SPDX-License-Identifier: GPL-3.0-or-later
// A drag where another feature line lies on the side that makes room.
#include "kernel/drag.h"
#include "tests/support/moves.h"
#include "tests/support/side.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tapeline::testing {
namespace {

constexpr int nx = 40, ny = 40;

/// A panel of 600 × 600 mm, bent along y = 0, with a fold along y = 150 that falls off behind.
double height(double, double y) { return -0.1 * std::max(0.0, -y) - 0.5 * std::max(0.0, y - 150); }

/// The line y = 0 slid by up to `size` towards the fold.
ParametricCurve bell(double size)
{
    const double k = std::numbers::pi / 600;
    return {[=](double x) { return Vec3(x, size * std::pow(std::cos(x * k), 2), 0); },
            [=](double x) { return Vec3(1, -size * k * std::sin(2 * x * k), 0); }, -300, 300};
}

Result<DragStep> dragged(double size, bool rails)
{
    const Mesh mesh = grid(nx, ny, -300, 300, -300, 300, height);
    DragStart start;
    start.extended = line_across(mesh, grid_row(nx, ny / 2));
    if (rails) {
        start.extended.features = other_feature_edges(start.extended.model, start.extended.vertices, false);
    }
    start.V = start.extended.model.mesh.V;
    start.slide.stiff_direction = Vec3::UnitY();
    start.slide.stiffness_ratio = 100;
    start.plate = {1};
    const FeatureLine line = line_of(start.extended.model, start.extended.vertices);
    return Drag::create(std::move(start)).and_then([&](const Drag& drag) {
        return drag.step(line, bell(size), {}, Placement::on_surface, LineSide::left);
    });
}

/// How far vertices of the fold have left it [mm].
double off_the_fold(const Positions& V)
{
    double off = 0;
    for (const int v : grid_row(nx, 3 * ny / 4)) {
        off = std::max({off, std::abs(V(v, 1) - 150), std::abs(V(v, 2))});
    }
    return off;
}

TEST(Drag, LeavesAnotherFeatureLineWhereItIsAndItsSidesApart)
{
    const Mesh rest = grid(nx, ny, -300, 300, -300, 300, height);
    const auto step = dragged(60, true);
    ASSERT_TRUE(step) << step.error().message;
    EXPECT_LT(off_the_fold(step->V), 1e-9);
    for (int v = 0; v < rest.V.rows(); ++v) {
        EXPECT_EQ(rest.V(v, 1) < 150, step->V(v, 1) < 150 && rest.V(v, 1) != 150) << v;
        if (rest.V(v, 1) > 0) {
            EXPECT_NEAR(step->V(v, 2), height(step->V(v, 0), step->V(v, 1)), 1e-9);
        }
    }
    // What lies before the fold makes room, evenly.
    const int between = 5 * ny / 8 * (nx + 1) + nx / 2;
    EXPECT_NEAR(step->V(between, 1), 75 + 30, 5);
    // Without the rail the fold is dragged along.
    const auto free = dragged(60, false);
    ASSERT_TRUE(free);
    EXPECT_GT(off_the_fold(free->V), 5);
}

TEST(Drag, KeepsTheLineOnItsTargetWithAndWithoutOtherLines)
{
    for (const bool rails : {true, false}) {
        const auto step = dragged(-40, rails);
        ASSERT_TRUE(step);
        const auto& [line, targets] = std::pair(step->correspondence.line.vertices, step->correspondence.targets);
        for (size_t i = 0; i < line.size(); ++i) {
            EXPECT_EQ(Vec3(step->V.row(line[i])), targets[i]);
        }
    }
}

} // namespace
} // namespace tapeline::testing
