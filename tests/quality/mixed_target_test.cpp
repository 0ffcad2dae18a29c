// SPDX-License-Identifier: GPL-3.0-or-later
// A target that changes gradually changes the surface gradually: from along the surface to off it, and from one side of
// the line into a zigzag. What a step of the target's own changes is no jump, so second differences are looked at.
#include "tests/support/moves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>
#include <vector>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double slide = 60; // [mm]
constexpr int nx = 32, ny = 24;

/// Largest second difference of a vertex's place over three steps of the target [mm]: twice a jump's size at most. The
/// line's own places are given by the target, whose kink where it crosses a crease is none of the method's.
class Jumps {
public:
    explicit Jumps(Method method) : model_(model_of(crease_panel(nx, ny)))
    {
        options_.method = method;
        options_.correspondence.mode = CorrespondenceMode::arc_length;
        options_.tolerance_mm = 1e-3;
        const std::vector<int> whole = crease_panel_line(nx, ny);
        line_ = std::vector(whole.begin() + nx / 4, whole.begin() + 3 * nx / 4 + 1);
        region_ = whole_model(model_);
    }

    MoveResult move(const TargetCurve& target) const
    {
        auto moved = move_feature_line(model_, line_of(model_, line_), target, region_, options_);
        if (!moved) {
            throw std::runtime_error(moved.error().message);
        }
        return std::move(*moved);
    }

    double largest(const std::function<ParametricCurve(double)>& target, double from, double to, double step) const
    {
        std::vector<Positions> places;
        double worst = 0;
        for (int i = 0; from + i * step <= to + 1e-9; ++i) {
            places.push_back(move(target(from + i * step)).V.topRows(model_.mesh.V.rows()));
            for (const int v : line_) {
                places[i].row(v).setZero();
            }
            if (i >= 2) {
                worst = std::max(worst, (places[i] - 2 * places[i - 1] + places[i - 2]).rowwise().norm().maxCoeff());
            }
        }
        return worst;
    }

private:
    Model model_;
    MoveOptions options_;
    std::vector<int> line_;
    Region region_;
};

constexpr double w = std::numbers::pi / 400;

/// The panel's slide by `along` with a normal part of `off`, both fading to zero at the used part's ends.
ParametricCurve mixed(double along, double off)
{
    const ParametricCurve on = crease_slide_target(along);
    return {[=](double x) -> Vec3 { return on.point(x) + Vec3(0, 0, off * std::cos(w * x) * std::cos(w * x)); },
            [=](double x) -> Vec3 { return on.derivative(x) - Vec3(0, 0, off * w * std::sin(2 * w * x)); }, -200, 200};
}

/// On the surface, from a slide to one side (share 0) to one that swings as far to both sides (1).
ParametricCurve swinging(double share)
{
    const auto y = [=](double x) {
        return slide * std::cos(w * x) * std::cos(w * x) * (1 - share + 1.5 * share * std::sin(w * x));
    };
    const auto rise = [=](double x) {
        const double c = std::cos(w * x), s = std::sin(w * x);
        return slide * w * c * (1.5 * share * c * c - 2 * s * (1 - share + 1.5 * share * s));
    };
    const double slope = std::tan(6 * std::numbers::pi / 180);
    return {[=](double x) -> Vec3 { return Vec3(x, y(x), crease_panel_height(x, y(x))); },
            [=](double x) -> Vec3 {
                return Vec3(1, rise(x), -x / 6000 - y(x) * rise(x) / 3000 - (y(x) < 0 ? -slope : slope) * rise(x));
            },
            -200, 200};
}

class MixedTarget : public ::testing::TestWithParam<Method> {};

} // namespace

TEST_P(MixedTarget, ChangesTheSurfaceGraduallyAsItsNormalPartGrows)
{
    const Jumps jumps(GetParam());
    const auto target = [](double share) { return mixed(slide, share * slide); };
    // The paper's verdict turns here.
    EXPECT_EQ(jumps.move(target(0.90)).placement.verdict, Placement::on_surface);
    EXPECT_EQ(jumps.move(target(0.94)).placement.verdict, Placement::off_surface);
    EXPECT_LE(jumps.largest(target, 0.90, 0.94, 0.01), 0.002 * slide);
    for (const double share : {0.0, 0.5, 1.98}) {
        EXPECT_LE(jumps.largest(target, share, share + 0.02, 0.01), 0.002 * slide) << share;
    }
}

TEST_P(MixedTarget, ChangesTheSurfaceGraduallyUntilItRisesStraight)
{
    const Jumps jumps(GetParam());
    const auto target = [](double angle) {
        return mixed(slide * std::cos(angle / 180 * std::numbers::pi),
                     slide * std::sin(angle / 180 * std::numbers::pi));
    };
    // Here the region's deformation in one piece comes in, until it is all.
    EXPECT_EQ(jumps.move(target(60)).placement.whole_share, 0);
    EXPECT_EQ(jumps.move(target(88)).placement.whole_share, 1);
    for (const double angle : {66.0, 70.0, 74.0}) {
        EXPECT_LE(jumps.largest(target, angle, angle + 0.5, 0.25), 0.003 * slide) << angle;
    }
    EXPECT_TRUE(jumps.move(target(88)).appended.empty());
}

TEST_P(MixedTarget, ChangesTheSurfaceGraduallyIntoAZigzag)
{
    const Jumps jumps(GetParam());
    // Where the line passes from one side to the other, where the tension side begins to give way, where a round of
    // evening out the compression no longer helps, where thin plates take over from asan-fl and where the displacements
    // begin to cancel. With switches in their place vertices went 9 (plate-fl) and 12 mm at once, with steep ramps 1.3.
    for (const double share : {0.4, 0.47, 0.53, 0.64, 0.68, 0.77, 0.83}) {
        EXPECT_LE(jumps.largest(swinging, share, share + 0.02, 0.01), 0.002 * slide) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, MixedTarget, ::testing::Values(Method::plate_fl, Method::asan_fl),
                         [](const auto& entry) { return entry.param == Method::plate_fl ? "PlateFl" : "AsanFl"; });
