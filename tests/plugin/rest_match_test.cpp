// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/rest_match.h"
#include "tests/support/shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tapeline::testing {
namespace {

/// The panel with its middle lifted: most vertices stay.
Mesh lifted(Mesh mesh)
{
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double r2 = mesh.V.row(v).head<2>().squaredNorm();
        mesh.V(v, 2) += r2 < 100 * 100 ? 20 * (1 - r2 / 1e4) : 0.0;
    }
    return mesh;
}

/// The mesh with vertex n put on the edge (a, b) at t; the two triangles there are cut.
Mesh cut_edge(const Mesh& mesh, int a, int b, double t)
{
    Mesh cut = mesh;
    const auto n = mesh.V.rows();
    cut.V.conservativeResize(n + 1, 3);
    cut.V.row(n) = (1 - t) * mesh.V.row(a) + t * mesh.V.row(b);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int p = mesh.F(f, k), q = mesh.F(f, (k + 1) % 3);
            if ((p == a && q == b) || (p == b && q == a)) {
                const Eigen::Index last = cut.F.rows();
                cut.F.conservativeResize(last + 1, 3);
                cut.F.row(last) << static_cast<int>(n), q, mesh.F(f, (k + 2) % 3);
                cut.F(f, (k + 1) % 3) = static_cast<int>(n);
            }
        }
    }
    return cut;
}

TEST(RestMatch, TakesThePositionsOfTheSameTriangles)
{
    const Mesh before = crease_panel(12, 8);
    const RestMatch match = match_rest(lifted(before), before, {});
    ASSERT_TRUE(match.found);
    EXPECT_EQ(match.V, before.V);
}

TEST(RestMatch, FollowsTrianglesWhoseVerticesAreNumberedAnew)
{
    const Mesh before = crease_panel(12, 8);
    Mesh moved = lifted(before);
    const auto n = static_cast<int>(before.V.rows());
    const Positions V = moved.V;
    for (int v = 0; v < n; ++v) {
        moved.V.row(n - 1 - v) = V.row(v);
    }
    moved.F = (n - 1 - before.F.array()).matrix();
    const RestMatch match = match_rest(moved, before, {});
    ASSERT_TRUE(match.found);
    EXPECT_EQ(match.V, Positions(before.V.colwise().reverse()));
}

TEST(RestMatch, PutsAppendedVerticesOnTheEdgesThatWereCut)
{
    const Mesh before = crease_panel(12, 8);
    const int a = before.F(90, 0), b = before.F(90, 1);
    const Mesh rest = cut_edge(before, a, b, 0.3);
    const RestMatch told = match_rest(lifted(rest), before, {{a, b, 0.3}});
    ASSERT_TRUE(told.found);
    EXPECT_TRUE(told.exact);
    EXPECT_EQ(told.V, rest.V);
    const RestMatch found = match_rest(rest, before, {});
    ASSERT_TRUE(found.found);
    EXPECT_FALSE(found.exact);
    EXPECT_LT((found.V - rest.V).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(RestMatch, SaysThatUnrelatedMeshesDoNotMatch)
{
    const Mesh before = crease_panel(12, 8);
    EXPECT_FALSE(match_rest(flat_roof(12, 9), before, {}).found);
    Mesh other = flat_roof(12, 8, Diagonals::random);
    const RestMatch match = match_rest(other, before, {});
    EXPECT_FALSE(match.found);
    EXPECT_EQ(match.how, "the two meshes have different triangles");
}

TEST(RestMatch, RefusesAppendedVerticesThatLieNowhere)
{
    const Mesh before = crease_panel(12, 8);
    Mesh moved = before;
    moved.V.conservativeResize(before.V.rows() + 1, 3);
    moved.V.row(before.V.rows()).setZero();
    EXPECT_FALSE(match_rest(moved, before, {}).found);
    EXPECT_FALSE(match_rest(moved, before, {{-1, 4, 0.5}}).found);
    EXPECT_FALSE(match_rest(moved, before, {{0, 1000000, 0.5}}).found);
}

} // namespace
} // namespace tapeline::testing
