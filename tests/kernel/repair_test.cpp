// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/repair.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

Mesh mesh_of(std::vector<Vec3> points, std::vector<std::array<int, 3>> triangles)
{
    Mesh mesh;
    mesh.V.resize(static_cast<int>(points.size()), 3);
    mesh.F.resize(static_cast<int>(triangles.size()), 3);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        mesh.V.row(v) = points[v];
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        mesh.F.row(t) << triangles[t][0], triangles[t][1], triangles[t][2];
    }
    return mesh;
}

/// Tetrahedra seen from outside, the k-th over the four corners listed; outside when the listed order is right-handed.
Mesh tetrahedra(const std::vector<Vec3>& points, const std::vector<std::array<int, 4>>& corners)
{
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c, d] : corners) {
        triangles.insert(triangles.end(), {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}});
    }
    return mesh_of(points, triangles);
}

std::vector<int> all_faces(const Mesh& mesh)
{
    std::vector<int> faces(mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

Result<void> check(const Mesh& mesh)
{
    return check_faces(mesh, Topology(mesh.F, static_cast<int>(mesh.V.rows())), all_faces(mesh));
}

/// A strip of 2n triangles closed to a ring, with or without half a turn.
Mesh ring(int n, bool half_turn)
{
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n, tilt = half_turn ? angle / 2 : 0;
        const Vec3 centre(std::cos(angle), std::sin(angle), 0);
        const Vec3 across = 0.3 * (std::cos(tilt) * Vec3::UnitZ() + std::sin(tilt) * centre);
        points.push_back(centre - across);
        points.push_back(centre + across);
        const bool last = i + 1 == n;
        const int a = 2 * i, b = 2 * i + 1, c = last ? half_turn : 2 * i + 2, d = last ? !half_turn : 2 * i + 3;
        triangles.insert(triangles.end(), {{a, c, b}, {b, c, d}});
    }
    return mesh_of(points, triangles);
}

const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

} // namespace

TEST(Repair, LeavesASoundMeshBitByBit)
{
    const Mesh mesh = crease_panel(8, 6, Diagonals::random);
    const RepairedMesh repaired = repair_mesh(mesh);
    EXPECT_EQ(repaired.mesh.V, mesh.V);
    EXPECT_EQ(repaired.mesh.F, mesh.F);
    EXPECT_EQ(repaired.source_face, all_faces(mesh));
    EXPECT_EQ(repaired.report.components, 1);
    EXPECT_EQ(repaired.report.border_edges, 2 * (8 + 6));
    EXPECT_TRUE(repaired.report.warnings.empty());
    EXPECT_TRUE(check(repaired.mesh));
}

TEST(Repair, RemovesDegenerateAndDuplicateTrianglesAndKeepsTheOrder)
{
    const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}},
                              {{0, 1, 1}, {0, 1, 2}, {2, 0, 1}, {0, 2, 3}, {3, 2, 0}, {2, 2, 2}});
    const RepairedMesh repaired = repair_mesh(mesh);
    EXPECT_EQ(repaired.mesh.F, (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished());
    EXPECT_EQ(repaired.source_face, (std::vector<int>{1, 3}));
    EXPECT_EQ(repaired.report.degenerate_faces, 2);
    EXPECT_EQ(repaired.report.duplicate_faces, 2);
    EXPECT_EQ(repaired.report.isolated_vertices, 1);
    EXPECT_EQ(repaired.mesh.V, mesh.V);
}

TEST(Repair, TurnsTheMinorityOfEachPieceRound)
{
    Mesh panel = crease_panel(6, 4);
    const Triangles sound = panel.F;
    for (const int t : {0, 7, 8, 20, 47}) {
        std::swap(panel.F(t, 1), panel.F(t, 2));
    }
    const RepairedMesh repaired = repair_mesh(panel);
    EXPECT_EQ(repaired.mesh.F, sound);
    EXPECT_EQ(repaired.report.flipped_faces, 5);
    EXPECT_TRUE(check(repaired.mesh));
    EXPECT_FALSE(check(panel));
}

TEST(Repair, TellsAOneSidedStripFromARing)
{
    Mesh band = ring(12, false);
    std::swap(band.F(5, 0), band.F(5, 1));
    const RepairedMesh two_sided = repair_mesh(band);
    EXPECT_EQ(two_sided.report.non_orientable_components, 0);
    EXPECT_EQ(two_sided.report.flipped_faces, 1);
    EXPECT_EQ(two_sided.report.border_edges, 24);

    const Mesh moebius = ring(12, true);
    const RepairedMesh one_sided = repair_mesh(moebius);
    EXPECT_EQ(one_sided.report.non_orientable_components, 1);
    EXPECT_EQ(one_sided.report.flipped_faces, 0);
    EXPECT_EQ(one_sided.report.border_edges, 24);
    EXPECT_EQ(one_sided.mesh.F, moebius.F);
    ASSERT_EQ(one_sided.report.warnings.size(), 1u);
    const auto refusal = check(one_sided.mesh);
    ASSERT_FALSE(refusal);
    EXPECT_NE(refusal.error().message.find("disagree"), std::string::npos);
}

TEST(Repair, SplitsTwoSolidsThatTouchAlongAnEdge)
{
    auto points = corner;
    points.insert(points.end(), {{-1, 0, 0}, {0, -1, 0}});
    const Mesh mesh = tetrahedra(points, {{0, 1, 2, 3}, {0, 4, 5, 3}});
    const RepairedMesh repaired = repair_mesh(mesh);
    EXPECT_EQ(repaired.report.non_manifold_edges, 1);
    EXPECT_EQ(repaired.report.non_manifold_edges_left, 0);
    EXPECT_EQ(repaired.report.non_manifold_vertices, 0);
    EXPECT_EQ(repaired.report.border_edges, 0);
    ASSERT_EQ(repaired.mesh.V.rows(), mesh.V.rows() + 2);
    EXPECT_EQ(repaired.mesh.V.topRows(6), mesh.V);
    EXPECT_EQ(repaired.mesh.F.topRows(4), mesh.F.topRows(4));
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(repaired.mesh.V.row(6 + i), mesh.V.row(repaired.source_vertex[i]));
    }
    EXPECT_TRUE(check(repaired.mesh));
}

TEST(Repair, SplitsTwoSolidsThatTouchInAPoint)
{
    auto points = corner;
    points.insert(points.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
    const RepairedMesh repaired = repair_mesh(tetrahedra(points, {{0, 1, 2, 3}, {0, 5, 4, 6}}));
    EXPECT_EQ(repaired.report.non_manifold_edges, 0);
    EXPECT_EQ(repaired.report.non_manifold_vertices, 1);
    EXPECT_EQ(repaired.mesh.V.rows(), 8);
    EXPECT_EQ(repaired.source_vertex, std::vector<int>{0});
}

TEST(Repair, KeepsARibOnAPanelAndRefusesItWhereTouched)
{
    // Two triangles in the plane and a third that stands on their common edge.
    const Mesh mesh =
        mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    const RepairedMesh repaired = repair_mesh(mesh);
    EXPECT_EQ(repaired.mesh.F, mesh.F);
    EXPECT_EQ(repaired.mesh.V, mesh.V);
    EXPECT_EQ(repaired.report.non_manifold_edges, 1);
    EXPECT_EQ(repaired.report.non_manifold_edges_left, 1);
    const auto refusal = check(repaired.mesh);
    ASSERT_FALSE(refusal);
    EXPECT_NE(refusal.error().message.find("edge 0-1 at (0.5, 0, 0) mm"), std::string::npos) << refusal.error().message;
}

TEST(Repair, KeepsATriangleWithoutAreaThatFillsAGap)
{
    // The side 0-1 of the lower triangle has a middle vertex 2 for the upper two; 0 1 2 closes the gap.
    const Mesh mesh =
        mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 4, 1}, {0, 1, 2}, {0, 2, 3}, {2, 1, 3}});
    const RepairedMesh repaired = repair_mesh(mesh);
    EXPECT_EQ(repaired.mesh.F, mesh.F);
    EXPECT_EQ(repaired.report.zero_area_faces, 1);
    EXPECT_EQ(repaired.report.border_edges, 4);
    const auto refusal = check(repaired.mesh);
    ASSERT_FALSE(refusal);
    EXPECT_NE(refusal.error().message.find("no area"), std::string::npos);
}

TEST(Repair, JoinsBordersOnlyWhereExactlyTwoCoincide)
{
    const Mesh whole = crease_panel(6, 4);
    Mesh opened = whole; // every triangle with its own vertices
    opened.V.resize(3 * whole.F.rows(), 3);
    for (int t = 0; t < whole.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            opened.V.row(3 * t + k) = whole.V.row(whole.F(t, k));
            opened.F(t, k) = 3 * t + k;
        }
    }
    const RepairedMesh repaired = repair_mesh(opened);
    const Topology topology(whole.F, static_cast<int>(whole.V.rows()));
    EXPECT_EQ(repaired.report.border_edges, 2 * (6 + 4));
    EXPECT_EQ(repaired.report.sewn_edges, topology.edge_count() - 2 * (6 + 4));
    EXPECT_EQ(repaired.mesh.V, opened.V);
    EXPECT_EQ(repair_mesh(opened, {.sew_borders = false}).report.border_edges, 3 * whole.F.rows());

    // Three loose triangles on one edge: nobody can tell which two belong together.
    const Mesh fan =
        mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                {{0, 1, 2}, {4, 3, 5}, {6, 7, 8}});
    EXPECT_EQ(repair_mesh(fan).report.sewn_edges, 0);
}

TEST(Repair, JoinsBordersThatDifferByRoundingButNotByAGap)
{
    for (const double unit : {1e-6, 1.0, 1e6}) {
        for (const double gap : {1e-16, 1e-7, 1e-5}) {
            Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0, 0, gap}, {1, -gap, 0}, {0.5, -1, 0}},
                                {{0, 1, 2}, {4, 3, 5}});
            mesh.V *= unit;
            EXPECT_EQ(repair_mesh(mesh).report.sewn_edges, gap < 1e-6 ? 1 : 0);
        }
    }
}

TEST(Repair, DropsIsolatedVerticesOnRequest)
{
    const Mesh mesh = mesh_of({{9, 9, 9}, {0, 0, 0}, {8, 8, 8}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}}, {{4, 1, 3}});
    const Mesh compact = without_isolated_vertices(mesh);
    EXPECT_EQ(compact.F, (Triangles(1, 3) << 2, 0, 1).finished());
    EXPECT_EQ(compact.V, (Positions(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished());
}

TEST(Repair, DoesNotDependOnTheUnit)
{
    for (const double unit : {1e-6, 1.0, 1e6}) {
        Mesh mesh = crease_panel(6, 4, Diagonals::random);
        mesh.V *= unit;
        EXPECT_EQ(repair_mesh(mesh).report.zero_area_faces, 0);
        mesh.V.row(9) = 0.5 * (mesh.V.row(8) + mesh.V.row(10));
        mesh.V.row(16) = mesh.V.row(9);
        EXPECT_GT(repair_mesh(mesh).report.zero_area_faces, 0);
    }
}
