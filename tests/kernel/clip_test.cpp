// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/clip.h"
#include "kernel/topology.h"
#include "tests/support/hand_made.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <gtest/gtest.h>
#include <numeric>

namespace tapeline::testing {
namespace {

std::vector<int> all_faces(const Mesh& mesh)
{
    std::vector<int> faces(mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

TEST(Clip, KeepsTheAreaInFrontOfThePlaneExactly)
{
    // A flat sheet of 4 × 3, cut obliquely: what stays is a trapezoid with parallel sides 2.5 and 1.
    const Mesh sheet = grid(
        7, 5, 0, 4, 0, 3, [](double, double) { return 0.0; }, Diagonals::random);
    const Vec3 along = Vec3(1, 0.5, 0).normalized();
    const auto clipped = clip_mesh(sheet, all_faces(sheet), {Vec3(1.5, 0, 0), along});
    ASSERT_TRUE(clipped) << clipped.error().message;
    // The cut runs from (1.5, 0) to (0, 3): in front of it lie widths from 2.5 at y = 0 to 4 at y = 3.
    EXPECT_NEAR(total_area(clipped->mesh), 0.5 * (2.5 + 4) * 3, 1e-12);
    for (int v = 0; v < clipped->mesh.V.rows(); ++v) {
        EXPECT_GE((Vec3(clipped->mesh.V.row(v)) - Vec3(1.5, 0, 0)).dot(along), -1e-12);
    }
}

TEST(Clip, LeavesWhatIsJoinedJoinedAndOpensOnlyAlongTheCut)
{
    const Mesh sphere = ball(24);
    const auto clipped = clip_mesh(sphere, all_faces(sphere), {Vec3(0.1, 0.03, 0.07), Vec3(1, 2, 3).normalized()});
    ASSERT_TRUE(clipped) << clipped.error().message;
    const SurfaceCount count = count_surface(clipped->mesh);
    EXPECT_EQ(count.bad_edges, 0);
    EXPECT_EQ(count.euler, 1) << "a cap of a sphere is a disk";
    const Topology topology(clipped->mesh.F, static_cast<int>(clipped->mesh.V.rows()));
    for (const MeshEdge& edge : topology.edges()) {
        if (edge.border()) {
            for (const int v : {edge.a, edge.b}) {
                const Vec3 p = clipped->mesh.V.row(v);
                EXPECT_NEAR((p - Vec3(0.1, 0.03, 0.07)).dot(Vec3(1, 2, 3).normalized()), 0, 1e-12);
            }
        }
    }
}

TEST(Clip, NamesTheOldVerticesThatStay)
{
    const Mesh sheet = grid(4, 4, -1, 1, -1, 1, [](double, double) { return 0.0; });
    const auto clipped = clip_mesh(sheet, all_faces(sheet), {Vec3::Zero(), Vec3::UnitX()});
    ASSERT_TRUE(clipped);
    for (int v = 0; v < sheet.V.rows(); ++v) {
        ASSERT_EQ(clipped->vertex[v] >= 0, sheet.V(v, 0) >= 0) << v;
        if (clipped->vertex[v] >= 0) {
            EXPECT_EQ(clipped->mesh.V.row(clipped->vertex[v]), sheet.V.row(v));
        }
    }
    EXPECT_NEAR(total_area(clipped->mesh), 2, 1e-12);
}

TEST(Clip, RefusesWhatIsNoPlaneOrNoTriangle)
{
    const Mesh sheet = grid(2, 2, 0, 1, 0, 1, [](double, double) { return 0.0; });
    EXPECT_FALSE(clip_mesh(sheet, all_faces(sheet), {Vec3::Zero(), Vec3(2, 0, 0)}));
    EXPECT_FALSE(clip_mesh(sheet, {0, 99}, {Vec3::Zero(), Vec3::UnitX()}));
    EXPECT_FALSE(clip_mesh(sheet, {-1}, {Vec3::Zero(), Vec3::UnitX()}));
}

} // namespace
} // namespace tapeline::testing
