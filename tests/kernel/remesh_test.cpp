// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/curve.h"
#include "kernel/remesh.h"
#include "kernel/remesh_renumber.h"
#include "tests/support/hand_made.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <numeric>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::vector<int> all_faces(const Mesh& mesh) { return whole_mesh_region(mesh).faces; }

RemeshOptions edge_length(double mm)
{
    RemeshOptions options;
    options.max_edge_mm = mm;
    return options;
}

/// A cylinder of radius 50 about z in exact form: face 0 is its side, edges 0 and 1 the circles at z = 0 and 100.
class Cylinder final : public SurfaceProjector {
public:
    int face_count() const override { return 1; }
    std::optional<SurfaceFoot> closest(int, const Vec3& p) const override
    {
        const Vec3 n = Vec3(p.x(), p.y(), 0).normalized();
        return SurfaceFoot{50 * n + Vec3(0, 0, std::clamp(p.z(), 0.0, 100.0)), n};
    }
    std::optional<Vec3> closest_on_edge(int edge, const Vec3& p) const override
    {
        return 50 * Vec3(p.x(), p.y(), 0).normalized() + Vec3(0, 0, edge * 100);
    }
};

/// The side of that cylinder in `n` flat strips of two long triangles each, as a CAD tessellation would have it.
Model faceted_cylinder(int n)
{
    Model model;
    model.mesh.V.resize(2 * n, 3);
    model.mesh.F.resize(2 * n, 3);
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        model.mesh.V.row(2 * i) << 50 * std::cos(angle), 50 * std::sin(angle), 0;
        model.mesh.V.row(2 * i + 1) << 50 * std::cos(angle), 50 * std::sin(angle), 100;
        const int next = 2 * ((i + 1) % n);
        model.mesh.F.row(2 * i) << 2 * i, next, 2 * i + 1;
        model.mesh.F.row(2 * i + 1) << 2 * i + 1, next, next + 1;
        for (const int side : {0, 1}) {
            model.cad_edges.push_back({std::min(2 * i, next) + side, std::max(2 * i, next) + side, side});
        }
    }
    std::ranges::sort(model.cad_edges);
    model.cad_face.assign(2 * n, 0);
    model.surface = std::make_shared<Cylinder>();
    return model;
}

void expect_conforming(const Mesh& mesh, const SurfaceCount& before)
{
    const SurfaceCount count = count_surface(mesh);
    EXPECT_EQ(count.euler, before.euler);
    EXPECT_EQ(count.bad_edges, 0);
    double smallest = std::numeric_limits<double>::infinity();
    for (int t = 0; t < mesh.F.rows(); ++t) {
        smallest = std::min(smallest, triangle_area(mesh, t));
    }
    EXPECT_GT(smallest, 0);
}

} // namespace

TEST(Remesh, KeepsAPlanesAreaAndOutlineAndGivesEvenTriangles)
{
    // Slivers: 2 × 40 cells on a square.
    const Model model = model_of(grid(2, 40, 0, 100, 0, 100, [](double, double) { return 0.0; }));
    const auto result = remesh_region(model, all_faces(model.mesh), edge_length(5));
    ASSERT_TRUE(result) << result.error().message;
    const Mesh& mesh = result->model.mesh;
    expect_conforming(mesh, count_surface(model.mesh));
    EXPECT_NEAR(total_area(mesh), 1e4, 1e-6);
    EXPECT_LT(mesh.V.col(2).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT(result->min_angle_before, 4);
    EXPECT_GT(result->min_angle_after, 13);
    EXPECT_DOUBLE_EQ(result->min_angle_after, min_angle(mesh, result->region_faces));
}

TEST(Remesh, KeepsACreaseExactly)
{
    const Model model = model_of(crease_panel(30, 20, Diagonals::random));
    const auto crease = crease_panel_line(30, 20);
    RemeshOptions options = edge_length(15);
    options.keep_lines = {crease};
    const auto result = remesh_region(model, all_faces(model.mesh), options);
    ASSERT_TRUE(result) << result.error().message;
    const std::vector<int>& line = result->kept_lines.at(0);
    EXPECT_EQ(line.size(), 2 * crease.size() - 1); // each edge of 26.7 mm was halved
    const Topology topology(result->model.mesh.F, static_cast<int>(result->model.mesh.V.rows()));
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec3 p = result->model.mesh.V.row(line[i]);
        if (i % 2 == 0) {
            EXPECT_EQ(result->old_vertex[line[i]], crease[i / 2]);
            EXPECT_EQ(p, Vec3(model.mesh.V.row(crease[i / 2])));
        }
        EXPECT_EQ(p.y(), 0);
        if (i > 0) {
            EXPECT_GE(topology.find_edge(line[i - 1], line[i]), 0);
        }
    }
    expect_conforming(result->model.mesh, count_surface(model.mesh));
}

TEST(Remesh, FindsTheCreaseWithoutBeingTold)
{
    const Model model = model_of(flat_roof(40, 20, Diagonals::random)); // 33° crease
    const auto result = remesh_region(model, all_faces(model.mesh), edge_length(60));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_NEAR(total_area(result->model.mesh), total_area(model.mesh), 1e-9 * total_area(model.mesh));
    for (int v = 0; v < result->model.mesh.V.rows(); ++v) {
        EXPECT_NEAR(result->model.mesh.V(v, 2), -0.3 * std::abs(result->model.mesh.V(v, 1)), 1e-9);
    }
}

TEST(Remesh, LeavesTheOutsideBitIdenticalAndTheSeamClosed)
{
    const Model model = model_of(crease_panel(40, 30, Diagonals::random));
    const auto faces = faces_where(model.mesh, [](const Vec3& p) { return std::abs(p.x()) < 250 && p.y() < 200; });
    const auto result = remesh_region(model, faces, edge_length(8));
    ASSERT_TRUE(result) << result.error().message;
    expect_conforming(result->model.mesh, count_surface(model.mesh));
    // The region's bottom edge is the panel's border: 25 cells of 20 mm or so are cut into pieces there.
    EXPECT_GT(count_surface(result->model.mesh).border_edges, count_surface(model.mesh).border_edges);
    std::vector<char> inside(model.mesh.F.rows(), 0), region(result->model.mesh.F.rows(), 0);
    for (const int t : faces) {
        inside[t] = 1;
    }
    for (const int t : result->region_faces) {
        region[t] = 1;
    }
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        for (int k = 0; k < 3 && !inside[t]; ++k) {
            const int v = model.mesh.F(t, k);
            EXPECT_EQ(result->old_vertex[v], v);
            EXPECT_EQ(result->model.mesh.V.row(v), model.mesh.V.row(v));
        }
    }
    double outside_before = 0, outside_after = 0;
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        outside_before += inside[t] ? 0 : triangle_area(model.mesh, t);
    }
    for (int t = 0; t < result->model.mesh.F.rows(); ++t) {
        outside_after += region[t] ? 0 : triangle_area(result->model.mesh, t);
    }
    EXPECT_NEAR(outside_after, outside_before, 1e-9 * outside_before);
}

TEST(Remesh, PutsNewVerticesOnTheExactCylinder)
{
    for (const int facets : {12, 48}) {
        const Model model = faceted_cylinder(facets);
        const auto result = remesh_region(model, all_faces(model.mesh), edge_length(6));
        ASSERT_TRUE(result) << result.error().message;
        const Mesh& mesh = result->model.mesh;
        expect_conforming(mesh, count_surface(model.mesh));
        for (int v = 0; v < mesh.V.rows(); ++v) {
            EXPECT_NEAR(mesh.V.row(v).head<2>().norm(), 50, 1e-12);
        }
        EXPECT_GT(result->projected, 0);
        EXPECT_TRUE(result->warnings.empty());
        EXPECT_GT(result->min_angle_after, 13);
        EXPECT_NEAR(total_area(mesh), 1e4 * std::numbers::pi, 100);
        // Both circles keep their tags on every edge, on the exact circle.
        EXPECT_EQ(result->model.cad_edges.size(), static_cast<size_t>(count_surface(mesh).border_edges));
        for (const CadEdgeTag& tag : result->model.cad_edges) {
            EXPECT_NEAR(mesh.V(tag.a, 2), tag.cad_edge * 100, 1e-12);
            EXPECT_NEAR(mesh.V(tag.b, 2), tag.cad_edge * 100, 1e-12);
        }
        EXPECT_EQ(result->model.cad_face, std::vector<int>(mesh.F.rows(), 0));
    }
}

TEST(Remesh, GivesTheSameBytesTwice)
{
    const Model model = faceted_cylinder(24);
    const auto one = remesh_region(model, all_faces(model.mesh), edge_length(5));
    const auto two = remesh_region(model, all_faces(model.mesh), edge_length(5));
    ASSERT_TRUE(one && two);
    EXPECT_EQ(one->model.mesh.V, two->model.mesh.V);
    EXPECT_EQ(one->model.mesh.F, two->model.mesh.F);
}

TEST(Remesh, CoarsensToo)
{
    const Model model = model_of(grid(40, 40, 0, 100, 0, 100, [](double, double) { return 0.0; }));
    const auto faces = faces_where(model.mesh, [](const Vec3& p) { return (p - Vec3(50, 50, 0)).norm() < 40; });
    const auto result = remesh_region(model, faces, edge_length(10));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_LT(result->model.mesh.V.rows(), model.mesh.V.rows());
    expect_conforming(result->model.mesh, count_surface(model.mesh));
    EXPECT_EQ(count_surface(result->model.mesh).border_edges, 160);
    for (int v = 0; v < result->model.mesh.V.rows(); ++v) {
        if (const int old = result->old_vertex[v]; old >= 0) {
            EXPECT_EQ(result->model.mesh.V.row(v), model.mesh.V.row(old));
        }
    }
}

TEST(Remesh, RefusesWhatItCannotDo)
{
    const Model model = model_of(grid(4, 4, 0, 1, 0, 1, [](double, double) { return 0.0; }));
    EXPECT_FALSE(remesh_region(model, {}, edge_length(1)));
    EXPECT_FALSE(remesh_region(model, {0, 99}, edge_length(1)));
    for (const double h : {0.0, -1.0, std::nan(""), 1e-9}) {
        EXPECT_FALSE(remesh_region(model, all_faces(model.mesh), edge_length(h))) << h;
    }
    Model flat = model;
    flat.mesh.V.row(flat.mesh.F(3, 0)) = flat.mesh.V.row(flat.mesh.F(3, 1));
    const auto refused = remesh_region(flat, all_faces(flat.mesh), edge_length(1));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("no area"), std::string::npos);
}

TEST(StableNumbers, FillGapsThenCloseThem)
{
    EXPECT_EQ(stable_numbers({0, 3, -1, -1, -1}, 4), (std::vector<int>{0, 3, 1, 2, 4}));
    EXPECT_EQ(stable_numbers({0, 3, 5, -1}, 6), (std::vector<int>{0, 2, 3, 1}));
    EXPECT_EQ(stable_numbers({}, 3), std::vector<int>());
}
