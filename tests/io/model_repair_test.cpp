// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cap_flip.h"
#include "io/model_repair.h"
#include "kernel/topology.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

Model flat_grid(int n)
{
    Model model = model_of(grid(n, n, 0, n, 0, n, [](double, double) { return 0.0; }));
    model.cad_face.assign(model.mesh.F.rows(), 0);
    return model;
}

/// Every edge has at most two triangles, which run along it in opposite senses.
bool manifold_and_oriented(const Mesh& mesh)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    for (const MeshEdge& edge : topology.edges()) {
        if (edge.face_count > 2 || (edge.face_count == 2 && (edge.left < 0 || edge.right < 0))) {
            return false;
        }
    }
    return true;
}

double area(const Mesh& mesh)
{
    double sum = 0;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        sum += triangle_area(mesh, t);
    }
    return sum;
}

} // namespace

TEST(ModelRepair, LeavesASoundMeshAlone)
{
    Model model = flat_grid(6);
    const Model before = model;
    const RepairCounts counts = repair_model(model);
    EXPECT_TRUE(model.mesh.V == before.mesh.V);
    EXPECT_TRUE(model.mesh.F == before.mesh.F);
    EXPECT_EQ(counts.degenerate_faces + counts.duplicate_faces + counts.flipped_faces + counts.non_manifold_edges +
                  counts.non_manifold_vertices + counts.isolated_vertices,
              0);
    EXPECT_EQ(counts.border_edges, 24);
}

TEST(ModelRepair, TurnsTheFewTrianglesThatDisagree)
{
    Model model = flat_grid(6);
    for (const int t : {3, 17, 18, 40}) {
        std::swap(model.mesh.F(t, 0), model.mesh.F(t, 1));
    }
    EXPECT_EQ(repair_model(model).flipped_faces, 4);
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        EXPECT_GT(triangle_normal(model.mesh, t).z(), 0);
    }
}

TEST(ModelRepair, DropsDegenerateAndRepeatedTrianglesAndLooseVertices)
{
    Model model = flat_grid(3);
    const Mesh sound = model.mesh;
    const int m = static_cast<int>(sound.F.rows()), n = static_cast<int>(sound.V.rows());
    model.mesh.F.conservativeResize(m + 3, 3);
    model.mesh.F.row(m) << 0, 0, 1;
    model.mesh.F.row(m + 1) = sound.F.row(5);
    model.mesh.F.row(m + 2) << sound.F(7, 2), sound.F(7, 1), sound.F(7, 0);
    model.mesh.V.conservativeResize(n + 1, 3);
    model.mesh.V.row(n) << 1, 2, 3;
    model.cad_face.assign(m + 3, 4);
    const RepairCounts counts = repair_model(model);
    EXPECT_EQ(counts.degenerate_faces, 1);
    EXPECT_EQ(counts.duplicate_faces, 2);
    EXPECT_EQ(counts.isolated_vertices, 1);
    EXPECT_TRUE(model.mesh.F == sound.F);
    EXPECT_TRUE(model.mesh.V == sound.V);
    EXPECT_EQ(model.cad_face.size(), static_cast<size_t>(m));
}

TEST(ModelRepair, CutsThreeSheetsApartAtTheirCommonEdge)
{
    // Three triangles along the edge (0, 1), which is CAD edge 7.
    Model model;
    model.mesh.V.resize(5, 3);
    model.mesh.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1;
    model.mesh.F.resize(3, 3);
    model.mesh.F << 0, 1, 2, 1, 0, 3, 0, 1, 4;
    model.cad_face = {0, 1, 2};
    model.cad_edges = {{0, 1, 7}, {0, 2, 3}};
    const double before = area(model.mesh);
    const RepairCounts counts = repair_model(model);
    EXPECT_EQ(counts.non_manifold_edges, 1);
    EXPECT_TRUE(manifold_and_oriented(model.mesh));
    EXPECT_DOUBLE_EQ(area(model.mesh), before);
    EXPECT_EQ(model.mesh.V.rows(), 9);
    EXPECT_EQ(std::ranges::count(model.cad_edges, 7, &CadEdgeTag::cad_edge), 3);
    EXPECT_EQ(std::ranges::count(model.cad_edges, 3, &CadEdgeTag::cad_edge), 1);
    EXPECT_TRUE(std::ranges::is_sorted(model.cad_edges));
}

TEST(ModelRepair, GivesTwoFansAtOneVertexAVertexEach)
{
    Model model;
    model.mesh.V.resize(5, 3);
    model.mesh.V << 0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0;
    model.mesh.F.resize(2, 3);
    model.mesh.F << 0, 1, 2, 0, 3, 4;
    const RepairCounts counts = repair_model(model);
    EXPECT_EQ(counts.non_manifold_vertices, 1);
    EXPECT_EQ(model.mesh.V.rows(), 6);
    EXPECT_EQ(counts.border_edges, 6);
}

TEST(ModelRepair, OpensAMoebiusStrip)
{
    constexpr int n = 30;
    Model model;
    model.mesh.V.resize(2 * n, 3);
    model.mesh.F.resize(2 * n, 3);
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n;
        for (int side = 0; side < 2; ++side) {
            const double w = side == 0 ? -0.3 : 0.3, r = 1 + w * std::cos(a / 2);
            model.mesh.V.row(2 * i + side) << r * std::cos(a), r * std::sin(a), w * std::sin(a / 2);
        }
        const bool last = i + 1 == n; // the strip comes back upside down
        const int c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
        model.mesh.F.row(2 * i) << 2 * i, c, d;
        model.mesh.F.row(2 * i + 1) << 2 * i, d, 2 * i + 1;
    }
    const double before = area(model.mesh);
    EXPECT_GE(repair_model(model).one_sided_edges, 1);
    EXPECT_TRUE(manifold_and_oriented(model.mesh));
    EXPECT_DOUBLE_EQ(area(model.mesh), before);
}

TEST(ModelRepair, TurnsAClosedBodyOutwardButNotTheCavityOfASolid)
{
    // Two tetrahedra inside out; the second and third belong together as a body with a cavity.
    const auto tetrahedron = [](Model& model, double size, bool outward) {
        const int v = static_cast<int>(model.mesh.V.rows()), t = static_cast<int>(model.mesh.F.rows());
        model.mesh.V.conservativeResize(v + 4, 3);
        model.mesh.V.bottomRows(4) << -1, -1, -1, 1, -1, -1, 0, 1, -1, 0, 0, 1;
        model.mesh.V.bottomRows(4) *= size;
        model.mesh.F.conservativeResize(t + 4, 3);
        model.mesh.F.bottomRows(4) << v, v + 2, v + 1, v, v + 1, v + 3, v + 1, v + 2, v + 3, v + 2, v, v + 3;
        if (!outward) {
            model.mesh.F.bottomRows(4).col(1).swap(model.mesh.F.bottomRows(4).col(2));
        }
    };
    Model model;
    tetrahedron(model, 1, false);
    tetrahedron(model, 5, true);
    tetrahedron(model, 2, false);
    EXPECT_EQ(turn_outward(model, {-1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0}), 4);
    EXPECT_EQ(turn_outward(model, {}), 4) << "without solids the cavity is a body of its own";
}

TEST(CapFlip, RemovesATriangleWithoutAreaAndKeepsTheArea)
{
    // Vertex 2 lies on the edge (0, 1) of the triangle below it.
    Model model;
    model.mesh.V.resize(5, 3);
    model.mesh.V << 0, 0, 0, 4, 0, 0, 1, 0, 0, 2, 3, 0, 2, -3, 0;
    model.mesh.F.resize(4, 3);
    model.mesh.F << 0, 1, 2, 2, 1, 3, 0, 2, 3, 1, 0, 4;
    const double before = area(model.mesh);
    EXPECT_EQ(flip_caps(model), 1);
    EXPECT_DOUBLE_EQ(area(model.mesh), before);
    EXPECT_TRUE(manifold_and_oriented(model.mesh));
    for (int t = 0; t < 4; ++t) {
        EXPECT_GT(triangle_normal(model.mesh, t).z(), 0.99);
    }
}
