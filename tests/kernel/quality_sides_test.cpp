// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles count as compressed: a whole side, or, under a zigzag, the side that the line runs into at each place.
#include "kernel/quality.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int nx = 40, ny = 20;

/// The crease panel with its crease moved by u(x) across it, positive to the left.
struct Moved {
    Mesh rest = crease_panel(nx, ny);
    std::vector<int> line = crease_panel_line(nx, ny);
    std::pair<std::vector<int>, std::vector<int>> sides;
    std::vector<Vec3> displacements;

    explicit Moved(const std::function<double(double)>& u)
    {
        std::vector<int> all(rest.F.rows());
        std::iota(all.begin(), all.end(), 0);
        sides = sides_of_line(rest, all, line, false);
        for (const int v : line) {
            displacements.emplace_back(0, u(rest.V(v, 0)), 0);
        }
    }
    StrainedParts parts(LineSide compressed) const
    {
        return strained_parts(rest, sides, line, false, displacements, compressed);
    }
    Vec3 centre(int t) const
    {
        return (rest.V.row(rest.F(t, 0)) + rest.V.row(rest.F(t, 1)) + rest.V.row(rest.F(t, 2))) / 3;
    }
};

} // namespace

TEST(StrainedParts, AreTheTwoSidesWhenTheLineGoesOneWay)
{
    const Moved moved([](double x) { return 20 * std::pow(std::cos(x / 255), 2); });
    const StrainedParts parts = moved.parts(LineSide::left);
    EXPECT_EQ(parts.compressed, moved.sides.first);
    EXPECT_EQ(parts.tension, moved.sides.second);
}

TEST(StrainedParts, FollowTheLineWhereItSwingsToTheOtherSide)
{
    const Moved moved([](double x) { return 20 * std::sin(x / 127.3); });
    for (const LineSide usual : {LineSide::left, LineSide::right}) {
        const StrainedParts parts = moved.parts(usual);
        EXPECT_EQ(parts.compressed.size() + parts.tension.size(), static_cast<size_t>(moved.rest.F.rows()));
        for (const int t : parts.compressed) {
            const Vec3 c = moved.centre(t);
            if (std::abs(c.x()) > 30 && std::abs(c.x()) < 370) { // away from where the sides change
                EXPECT_GT(c.x() * c.y(), 0) << c.transpose();
            }
        }
    }
}

TEST(StrainedParts, KeepTheUsualSideWhereTheLineHardlyMoves)
{
    const Moved moved([](double x) { return x > 0 ? 20.0 : -0.1; });
    EXPECT_EQ(moved.parts(LineSide::left).compressed, moved.sides.first);
}
