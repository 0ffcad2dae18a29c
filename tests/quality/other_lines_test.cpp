// SPDX-License-Identifier: GPL-3.0-or-later
// A line that ends on corners of several sharp edges: the edges of a cube.
#include "kernel/feature_rails.h"
#include "kernel/junctions.h"
#include "tests/support/moves.h"
#include "tests/support/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int cells = 16;

/// An edge of the cube with side 2, and the direction across it in one of its two faces.
struct CubeEdge {
    Model model = model_of(cube(cells));
    FeatureLine line = find_feature_lines(model).front();
    Vec3 from = model.mesh.V.row(line.vertices.front()), to = model.mesh.V.row(line.vertices.back());
    Vec3 across;

    explicit CubeEdge(bool left)
    {
        const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
        const int a = line.vertices[0], b = line.vertices[1];
        const int t = left ? topology.face_left_of(a, b) : topology.face_left_of(b, a);
        across = triangle_normal(model.mesh, t).cross(to - from).normalized() * (left ? 1 : -1);
    }

    /// The edge shifted by `slide`, and beyond its ends by `more`.
    ParametricCurve target(const Vec3& slide, double more = 0) const
    {
        const Vec3 along = (to - from).normalized();
        const Vec3 first = from + slide - more * along, last = to + slide + more * along;
        return {[=](double t) -> Vec3 { return first + t * (last - first); },
                [=](double) -> Vec3 { return last - first; }, 0, 1};
    }
};

std::vector<Vec3> targets_of(const CubeEdge& edge, const Vec3& slide)
{
    std::vector<Vec3> targets;
    for (const int v : edge.line.vertices) {
        targets.emplace_back(Vec3(edge.model.mesh.V.row(v)) + slide);
    }
    return targets;
}

} // namespace

TEST(OtherLines, ACubesEdgeSlidesWithItsCornersAlongTheNeighbouringEdges)
{
    for (const bool left : {true, false}) {
        const CubeEdge edge(left);
        const Vec3 slide = 0.3 * edge.across;
        RegionOptions options;
        options.distance_mm = 1;
        const auto region = make_region(edge.model, edge.line, targets_of(edge, slide), options);
        ASSERT_TRUE(region) << region.error().message;
        const ParametricCurve target = edge.target(slide);
        const auto moved = move_feature_line(edge.model, edge.line, target, *region);
        ASSERT_TRUE(moved) << moved.error().message;
        EXPECT_EQ(moved->retraction.flipped, 0);
        EXPECT_EQ(moved->placement.compressed, left ? LineSide::left : LineSide::right);
        for (size_t i = 0; i < edge.line.vertices.size(); ++i) {
            const Vec3 goal = Vec3(edge.model.mesh.V.row(edge.line.vertices[i])) + slide;
            EXPECT_LT((Vec3(moved->V.row(edge.line.vertices[i])) - goal).norm(), 1e-9) << i;
        }
        const bool compressed_left = moved->placement.compressed == LineSide::left;
        const auto& compressed = compressed_left ? moved->left_faces : moved->right_faces;
        const auto& tense = compressed_left ? moved->right_faces : moved->left_faces;
        const auto quality = measure_quality(
            {moved->rest.mesh, moved->V, moved->correspondence.line.vertices, false, compressed, tense, &target, 9});
        ASSERT_TRUE(quality);
        EXPECT_LT(std::abs(quality->bulge_max_mm), 1e-6 * 0.3);
        EXPECT_EQ(quality->flipped, 0);
        EXPECT_GT(quality->squash, 0.5);
        // The compressed side is still the cube's surface, its other edges included.
        for (const int t : compressed) {
            for (int k = 0; k < 3; ++k) {
                const int v = moved->rest.mesh.F(t, k);
                const Vec3 p = moved->rest.mesh.V.row(v), q = moved->V.row(v);
                for (int axis = 0; axis < 3; ++axis) {
                    // A corner of the moving line takes another of the cube's edges instead of its own.
                    if (std::abs(p[axis]) == 1 && std::ranges::count(moved->extended_line, v) == 0) {
                        EXPECT_NEAR(q[axis], p[axis], 1e-7);
                    }
                }
            }
        }
    }
}

TEST(OtherLines, AJunctionFollowsTheNeighbouringLineWhereTheTargetEndsBeforeOrBehindIt)
{
    const CubeEdge edge(true);
    const std::vector<VertexPair> features = other_feature_edges(edge.model, edge.line.vertices, false);
    const Vec3 slide = 0.3 * edge.across;
    for (const double more : {-0.05, 0.05}) {
        const ParametricCurve target = edge.target(slide, more);
        std::vector<Vec3> u;
        for (const int v : edge.line.vertices) {
            u.emplace_back(target.foot(edge.model.mesh.V.row(v)).point - Vec3(edge.model.mesh.V.row(v)));
        }
        Correspondence c = sends(edge.model, edge.line, u);
        ASSERT_TRUE(carry_junctions(edge.model.mesh, features, target, c));
        EXPECT_LT((c.targets.front() - edge.from - slide).norm(), 1e-12);
        EXPECT_LT((c.targets.back() - edge.to - slide).norm(), 1e-12);
        for (size_t i = 0; i < c.targets.size(); ++i) {
            EXPECT_LT((c.targets[i] - edge.from - slide).cross(edge.to - edge.from).norm(), 1e-12);
            EXPECT_TRUE(i == 0 || (c.targets[i] - c.targets[i - 1]).dot(edge.to - edge.from) > 0);
        }
    }
}

TEST(OtherLines, AJunctionOffTheTargetIsWarnedOfWithTheDistance)
{
    const CubeEdge edge(true);
    const Vec3 slide = 0.3 * edge.across;
    RegionOptions options;
    options.distance_mm = 1;
    const auto region = make_region(edge.model, edge.line, targets_of(edge, slide), options);
    ASSERT_TRUE(region) << region.error().message;
    for (const double missing : {0.0, 0.05}) {
        const ParametricCurve target = edge.target(slide, -missing);
        const auto moved = move_feature_line(edge.model, edge.line, target, *region);
        ASSERT_TRUE(moved) << moved.error().message;
        const bool warned = std::ranges::any_of(moved->warnings, [](const std::string& warning) {
            return warning.find("follows it, 0.05 mm off the target") != std::string::npos;
        });
        EXPECT_EQ(warned, missing > 0);
    }
}

TEST(OtherLines, AJunctionIsNotSentPastTheEndOfTheNeighbouringLine)
{
    const CubeEdge edge(true);
    const std::vector<VertexPair> features = other_feature_edges(edge.model, edge.line.vertices, false);
    const Vec3 slide = 1.9 * edge.across;
    Correspondence c = sends(edge.model, edge.line, std::vector<Vec3>(edge.line.vertices.size(), slide));
    const auto carried = carry_junctions(edge.model.mesh, features, edge.target(slide), c);
    ASSERT_FALSE(carried);
    EXPECT_NE(carried.error().message.find("ends or turns after 2 mm"), std::string::npos) << carried.error().message;
}
