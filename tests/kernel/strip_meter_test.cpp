// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/strip_meter.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tapeline::testing {
namespace {

/// The panel with everything near its crease shifted across it, unevenly.
Positions shifted(const Mesh& rest, double mm)
{
    Positions V = rest.V;
    for (Eigen::Index v = 0; v < V.rows(); ++v) {
        const double x = V(v, 0) / 400, y = V(v, 1) / 300;
        const double share = std::max(0.0, 1 - x * x) * std::max(0.0, 1 - y * y);
        V(v, 1) += mm * share;
        V(v, 2) += 0.1 * mm * share * std::sin(3 * x);
    }
    return V;
}

QualityInput input_of(const StripMeter& meter, const Positions& moved, bool all_faces)
{
    QualityInput input{meter.rest(), moved, crease_panel_line(24, 18), false, {}, {}, nullptr, 9};
    std::vector<int> faces;
    for (int t = 0; t < meter.rest().F.rows(); ++t) {
        const double x = meter.rest().V(meter.rest().F(t, 0), 0);
        if (all_faces || std::abs(x) < 250) {
            faces.push_back(t);
        }
    }
    const auto sides = sides_of_line(meter.rest(), faces, input.line, false);
    input.compressed_faces = sides.first;
    input.tension_faces = sides.second;
    return input;
}

void expect_same(const QualityReport& a, const QualityReport& b)
{
    EXPECT_EQ(a.bulge_max_mm, b.bulge_max_mm);
    EXPECT_EQ(a.bulge_rms_mm, b.bulge_rms_mm);
    EXPECT_EQ(a.slide_max_mm, b.slide_max_mm);
    EXPECT_EQ(a.crease_after, b.crease_after);
    EXPECT_EQ(a.crease_rms_difference, b.crease_rms_difference);
    for (const auto& [p, q] :
         {std::pair(a.compressed_sections, b.compressed_sections), std::pair(a.tension_sections, b.tension_sections)}) {
        EXPECT_EQ(p.inflections_after, q.inflections_after);
        EXPECT_EQ(p.turning_before, q.turning_before);
        EXPECT_EQ(p.turning_after, q.turning_after);
    }
}

TEST(StripMeter, GivesTheNumbersOfTheStripForEveryStepOfADrag)
{
    const StripMeter meter(crease_panel(24, 18, Diagonals::random));
    for (const bool all_faces : {true, false}) {
        for (const double mm : {0.0, 12.0, -30.0}) {
            const Positions moved = shifted(meter.rest(), mm);
            const QualityInput input = input_of(meter, moved, all_faces);
            const auto kept = meter.measure(input), anew = measure_strip(input), whole = measure_quality(input);
            ASSERT_TRUE(kept && anew && whole);
            expect_same(*kept, *anew);
            expect_same(*kept, *whole);
            EXPECT_EQ(kept->slide_max_mm > 1, mm != 0);
        }
    }
}

TEST(StripMeter, RefusesAnotherMeshAndWhatTheStripRefuses)
{
    const StripMeter meter(crease_panel(24, 18)), other(crease_panel(24, 18));
    const Positions moved = shifted(meter.rest(), 10), few = moved.topRows(5);
    EXPECT_FALSE(meter.measure(input_of(other, moved, true)));
    QualityInput wrong = input_of(meter, moved, true);
    wrong.line.front() = -1;
    const auto refused = meter.measure(wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, measure_strip(wrong).error().message);
    EXPECT_FALSE(meter.measure(input_of(meter, few, true)));
}

} // namespace
} // namespace tapeline::testing
