// SPDX-License-Identifier: GPL-3.0-or-later
// The tangent plane at the rim under every method: whatever crease its own energy leaves where the region ends is taken
// up by a band inside the region.
#include "kernel/geodesic_distance.h"
#include "plugin/runner/measures.h"
#include "tests/support/moves.h"
#include "tests/support/wide_panel.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double slide = 60; // [mm]

MeasuredMove slide_panel(const WidePanel& panel, MoveOptions options)
{
    options.rings = 3;
    const ParametricCurve target = crease_slide_target(slide);
    MoveResult moved = move_line(panel, target, options);
    auto quality = measure_quality(quality_input(moved, target));
    if (!quality) {
        throw std::runtime_error(quality.error().message);
    }
    return {std::move(moved), *quality};
}

MoveOptions options_for(Method method, RimControl rim, double width = 0)
{
    MoveOptions options;
    options.method = method;
    options.rim = rim;
    options.rim_width_mm = width;
    return options;
}

class RimOfMethod : public ::testing::TestWithParam<Method> {};

} // namespace

TEST_P(RimOfMethod, KeepsItsTangentPlaneWhenAsked)
{
    const WidePanel panel(Diagonals::alternating, 50, 40);
    const auto [own_move, own] = slide_panel(panel, options_for(GetParam(), RimControl::position));
    const auto [move, quality] = slide_panel(panel, options_for(GetParam(), RimControl::tangent));
    EXPECT_TRUE(move.converged());
    const bool buckles = GetParam() == Method::arap || GetParam() == Method::arap_sr;
    // Where a bulge of some 80 mm starts at the rim, the band itself curves by degrees from edge to edge.
    EXPECT_LE(quality.rim_crease_mean_change, buckles ? 0.65 * own.rim_crease_mean_change : 0.5);
    EXPECT_LE(quality.rim_crease_max_change, buckles ? 0.7 * own.rim_crease_max_change : 1.5);
    EXPECT_LE(quality.rim_crease_max_change, own.rim_crease_max_change + 1e-9);
    EXPECT_LE(quality.flipped, own.flipped);
    EXPECT_LE(quality.line_error_max_mm, 1e-9);
    if (method_info(GetParam()).splits) {
        EXPECT_NEAR(quality.bulge_max_mm, own.bulge_max_mm, 1e-3);
        EXPECT_NEAR(quality.squash, own.squash, 1e-5);
    }
}

TEST(RimOfSpokesAndRims, CurvesLikeASmoothSurfaceWhenTheMeshIsFiner)
{
    double last = 0;
    for (const int cells : {50, 100}) {
        const WidePanel panel(Diagonals::alternating, cells, cells * 4 / 5);
        const auto [move, quality] = slide_panel(panel, options_for(Method::arap_sr, RimControl::tangent));
        if (last > 0) {
            EXPECT_LE(quality.rim_crease_mean_change, 0.6 * last);
        }
        last = quality.rim_crease_mean_change;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, RimOfMethod,
                         ::testing::Values(Method::asan_fl, Method::asan_fl_paper, Method::asan_fl_sequential,
                                           Method::plate_fl, Method::asan, Method::arap, Method::arap_sr,
                                           Method::arap_n, Method::sr_arap, Method::lri),
                         [](const auto& entry) {
                             std::string name(method_info(entry.param).name);
                             std::erase(name, '-');
                             return name;
                         });

TEST(RimControlByDefault, IsTangentForAsanFlAndLeavesTheOthersAsTheyAre)
{
    const WidePanel panel(Diagonals::alternating, 50, 40);
    for (const Method method : {Method::asan_fl, Method::asan_fl_paper, Method::asan}) {
        const Positions usual = slide_panel(panel, options_for(method, RimControl::automatic)).move.V;
        const bool tangent = method == Method::asan_fl;
        const RimControl same = tangent ? RimControl::tangent : RimControl::position;
        EXPECT_EQ(usual, slide_panel(panel, options_for(method, same)).move.V) << method_info(method).name;
    }
}

TEST(RimWidth, IsHowFarTheTransitionReaches)
{
    const WidePanel panel(Diagonals::alternating, 50, 40);
    constexpr double width = 60;
    for (const Method method : {Method::asan_fl, Method::plate_fl, Method::asan}) {
        const Positions own = slide_panel(panel, options_for(method, RimControl::position)).move.V;
        const auto [move, quality] = slide_panel(panel, options_for(method, RimControl::tangent, width));
        double farthest = 0;
        for (int v = 0; v < own.rows(); ++v) {
            const Vec3 p = move.rest.mesh.V.row(v);
            if (own.row(v) != move.V.row(v)) {
                farthest = std::max(farthest, std::min(400 - std::abs(p.x()), 300 - std::abs(p.y())));
            }
        }
        EXPECT_GT(farthest, width / 3) << method_info(method).name;
        EXPECT_LT(farthest, width) << method_info(method).name;
        EXPECT_LE(quality.rim_crease_mean_change, 0.5) << method_info(method).name;
    }
}
