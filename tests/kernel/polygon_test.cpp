// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polygon.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <numeric>

using namespace tapeline;

namespace {

using Triangle = std::array<int, 3>;

std::vector<int> in_order(std::size_t n)
{
    std::vector<int> polygon(n);
    std::iota(polygon.begin(), polygon.end(), 0);
    return polygon;
}

/// Vector area of triangles or of a closed outline: does not depend on how the outline is filled.
Vec3 vector_area(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& [a, b, c] : triangles) {
        sum += 0.5 * (points[b] - points[a]).cross(points[c] - points[a]);
    }
    return sum;
}
Vec3 vector_area(const std::vector<Vec3>& points, const std::vector<int>& polygon)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        sum += 0.5 * points[polygon[k]].cross(points[polygon[(k + 1) % polygon.size()]]);
    }
    return sum;
}

/// Filling an outline: the triangles' border, with direction, is the outline, and n corners give n - 2 triangles.
void expect_fills(const std::vector<Vec3>& points, const std::vector<int>& polygon)
{
    const auto triangles = triangulate_polygon(points, polygon);
    ASSERT_TRUE(triangles);
    EXPECT_EQ(triangles->size(), polygon.size() - 2);
    std::map<std::pair<int, int>, int> border;
    for (const auto& t : *triangles) {
        for (int k = 0; k < 3; ++k) {
            ++border[{t[k], t[(k + 1) % 3]}];
            --border[{t[(k + 1) % 3], t[k]}];
        }
    }
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const int a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        --border[{a, b}];
        ++border[{b, a}];
    }
    for (const auto& [side, balance] : border) {
        EXPECT_EQ(balance, 0) << side.first << "-" << side.second;
    }
    const Vec3 whole = vector_area(points, polygon);
    EXPECT_LT((vector_area(points, *triangles) - whole).norm(), 1e-12 * whole.norm() + 1e-300);
    for (const auto& t : *triangles) {
        EXPECT_GE(vector_area(points, std::vector<Triangle>{t}).dot(whole), 0);
    }
}

/// A closed outline in a plane that is parallel to no axis, far from the origin.
std::vector<Vec3> tilted(const std::vector<std::pair<double, double>>& outline)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    std::vector<Vec3> points;
    for (const auto& [x, y] : outline) {
        points.emplace_back(turn * Vec3(x, y, 0) + Vec3(10, -20, 30));
    }
    return points;
}

} // namespace

TEST(Polygon, FillsConvexAndConcaveOutlines)
{
    std::vector<std::pair<double, double>> star, circle;
    for (int i = 0; i < 40; ++i) {
        const double angle = 2 * std::numbers::pi * i / 40;
        const double r = i % 2 == 0 ? 1 : 0.2;
        circle.emplace_back(std::cos(angle), std::sin(angle));
        star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    expect_fills(tilted(circle), in_order(40));
    expect_fills(tilted(star), in_order(40));
    expect_fills(tilted({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}), in_order(8));
}

TEST(Polygon, CutsAQuadrilateralAtItsReflexCornerOrAlongTheShorterDiagonal)
{
    expect_fills(tilted({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), in_order(4));
    expect_fills(tilted({{4, 0}, {1, 1}, {0, 4}, {0, 0}}), in_order(4));
    expect_fills(tilted({{0, 0}, {1, 0}, {2, 0}, {0, 1}}), in_order(4)); // a straight corner
    const auto sheared = triangulate_polygon(tilted({{0, 0}, {1, 0}, {3, 1}, {2, 1}}), in_order(4));
    ASSERT_TRUE(sheared);
    EXPECT_EQ(sheared->front(), (Triangle{1, 2, 3}));
    const auto square = triangulate_polygon(tilted({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), in_order(4));
    EXPECT_EQ(square->front(), (Triangle{0, 1, 2}));
}

TEST(Polygon, KeepsCornersOnStraightSidesForTheNeighbours)
{
    std::vector<std::pair<double, double>> outline;
    for (int i = 0; i < 10; ++i) {
        outline.emplace_back(0.1 * i, 0);
    }
    outline.insert(outline.end(), {{1, 0}, {1, 1}, {0, 1}});
    expect_fills(tilted(outline), in_order(outline.size()));
}

TEST(Polygon, FillsAroundAHoleThatADoubleEdgeJoinsToTheOutline)
{
    const auto points = tilted({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {3, 6}, {6, 6}, {6, 3}});
    expect_fills(points, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
}

TEST(Polygon, FillsAWarpedOutline)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24;
        points.emplace_back(std::cos(angle), std::sin(angle), 0.2 * std::sin(3 * angle));
    }
    const auto triangles = triangulate_polygon(points, in_order(24));
    ASSERT_TRUE(triangles);
    EXPECT_EQ(triangles->size(), 22u);
    EXPECT_LT((vector_area(points, *triangles) - vector_area(points, in_order(24))).norm(), 1e-12);
}

TEST(Polygon, DropsCornersNamedTwiceInARow)
{
    const auto points = tilted({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    EXPECT_EQ(triangulate_polygon(points, std::vector{0, 1, 1, 2, 2, 0})->size(), 1u);
    EXPECT_TRUE(triangulate_polygon(points, std::vector{0, 1, 0, 1})->size() <= 2);
    EXPECT_TRUE(triangulate_polygon(points, std::vector{0, 1, 1, 0})->empty());
    EXPECT_TRUE(triangulate_polygon(points, std::vector<int>{})->empty());
}

TEST(Polygon, WithoutAreaStillJoinsItsNeighbours)
{
    const auto points = tilted({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}});
    EXPECT_EQ(triangulate_polygon(points, in_order(5))->size(), 3u);
}

TEST(Polygon, ThatCrossesItselfOrRunsRoundTwiceIsRefused)
{
    EXPECT_FALSE(triangulate_polygon(tilted({{0, 0}, {2, 1}, {2, 0}, {0, 1.5}}), in_order(4)));
    EXPECT_FALSE(triangulate_polygon(tilted({{0, 0}, {2, 2}, {2, 0}, {0, 3}, {-1, 1}}), in_order(5)));
    const auto square = tilted({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    EXPECT_FALSE(triangulate_polygon(square, std::vector{0, 1, 2, 3, 0, 1, 2, 3}));
    const auto coincident = tilted({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}, {0.5, 0.2}});
    EXPECT_FALSE(triangulate_polygon(coincident, in_order(6)));
}
