// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/mesh_grading.h"
#include "kernel/remesh.h"
#include "tests/support/hand_made.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// A flat ring between radius 2 and 50 mm, as a CAD tessellation has it: n long slivers from circle to circle.
Mesh plate_with_hole(int n)
{
    Mesh mesh;
    mesh.V.resize(2 * n, 3);
    mesh.F.resize(2 * n, 3);
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        mesh.V.row(2 * i) << 2 * std::cos(angle), 2 * std::sin(angle), 0;
        mesh.V.row(2 * i + 1) << 50 * std::cos(angle), 50 * std::sin(angle), 0;
        const int next = 2 * ((i + 1) % n);
        mesh.F.row(2 * i) << 2 * i, 2 * i + 1, next + 1;
        mesh.F.row(2 * i + 1) << 2 * i, next + 1, next;
    }
    return mesh;
}

} // namespace

TEST(MeshGrading, LeavesNoSliversBesideAFinelyDividedHole)
{
    const Model model = model_of(plate_with_hole(72)); // hole edges of 0.17 mm in a mesh of 8 mm
    RemeshOptions options;
    options.max_edge_mm = 8;
    const auto result = remesh_region(model, whole_mesh_region(model.mesh).faces, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_LT(result->min_angle_before, 1);
    EXPECT_GT(result->min_angle_after, 20);
    EXPECT_TRUE(result->warnings.empty());
    const Mesh& mesh = result->model.mesh;
    EXPECT_NEAR(total_area(mesh), total_area(model.mesh), 1e-9 * total_area(model.mesh));
    EXPECT_EQ(count_surface(mesh).euler, 0);
    EXPECT_EQ(count_surface(mesh).bad_edges, 0);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        EXPECT_GT(triangle_normal(mesh, t).z(), 0.999);
    }
}

TEST(MeshGrading, UnfoldsATriangleThatLiesUpsideDown)
{
    // The middle vertex of a fan was dragged out over its border.
    GradedMesh graded;
    graded.mesh = grid(2, 2, 0, 2, 0, 2, [](double, double) { return 0.0; });
    const Mesh flat = graded.mesh;
    graded.mesh.V.row(4) << 2.5, 1, 0;
    graded.part.assign(8, 0);
    graded.movable.assign(9, 0);
    graded.movable[4] = 1;
    std::vector<VertexPair> kept;
    const Topology topology(flat.F, 9);
    for (const MeshEdge& e : topology.edges()) {
        if (e.border()) {
            kept.push_back({e.a, e.b});
        }
    }
    grade_triangles(graded, kept, 10, PartSurface(flat, graded.part));
    for (int t = 0; t < graded.mesh.F.rows(); ++t) {
        EXPECT_GT(triangle_normal(graded.mesh, t).z(), 0.999);
    }
    EXPECT_EQ(total_area(graded.mesh), 4);
}
