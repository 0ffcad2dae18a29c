// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension.h"
#include "kernel/extension_target.h"
#include "tests/support/hand_made.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

Vec3 still(const Vec3&) { return Vec3::Zero(); }

/// Flat square [0, 100]² with a line of 5 edges in the middle row that ends inside at both ends.
struct Plane {
    Model model;
    std::vector<int> line;
    explicit Plane(Diagonals diagonals = Diagonals::random, int n = 20)
        : model(model_of(grid(n, n, 0, 100, 0, 100, [](double, double) { return 0.0; }, diagonals, {n / 2})))
    {
        for (int i = n / 2 - 3; i <= n / 2 + 2; ++i) {
            line.push_back(n / 2 * (n + 1) + i);
        }
    }
};

/// Every two neighbours of L̂0 are joined by a mesh edge, the ends lie on the rim, nothing between them does, and the
/// used line is where first and last say.
void expect_sound(const ExtendedLine& e, const std::vector<int>& used)
{
    const Topology topology(e.model.mesh.F, static_cast<int>(e.model.mesh.V.rows()));
    const auto on_rim = [&](int v) { return std::ranges::binary_search(e.region.fixed_rim, v); };
    for (size_t i = 1; i < e.vertices.size(); ++i) {
        EXPECT_GE(topology.find_edge(e.vertices[i - 1], e.vertices[i]), 0) << i;
    }
    for (size_t i = 0; i < e.vertices.size(); ++i) {
        EXPECT_EQ(on_rim(e.vertices[i]), i == 0 || i + 1 == e.vertices.size()) << i;
    }
    ASSERT_EQ(e.last - e.first + 1, static_cast<int>(used.size()));
    EXPECT_TRUE(std::equal(used.begin(), used.end(), e.vertices.begin() + e.first));
    EXPECT_EQ(e.targets.size(), e.vertices.size());
}

/// The cut changed neither the surface nor its topology, and appended vertices are where they say.
void expect_same_surface(const Model& before, const ExtendedLine& e)
{
    const Mesh& mesh = e.model.mesh;
    const auto n = before.mesh.V.rows();
    ASSERT_EQ(mesh.V.rows(), n + static_cast<int>(e.appended.size()));
    EXPECT_EQ(mesh.V.topRows(n), before.mesh.V);
    for (size_t i = 0; i < e.appended.size(); ++i) {
        const AppendedVertex& p = e.appended[i];
        const Vec3 expected = (1 - p.t) * before.mesh.V.row(p.a) + p.t * before.mesh.V.row(p.b);
        EXPECT_EQ(Vec3(mesh.V.row(n + static_cast<int>(i))), expected);
        EXPECT_GE(std::min(p.t, 1 - p.t), 0.05 - 1e-12);
    }
    EXPECT_NEAR(total_area(mesh), total_area(before.mesh), 1e-9 * total_area(before.mesh));
    const SurfaceCount old_count = count_surface(before.mesh), count = count_surface(mesh);
    EXPECT_EQ(count.euler, old_count.euler);
    EXPECT_EQ(count.border_edges, old_count.border_edges);
    EXPECT_EQ(count.bad_edges, 0);
}

} // namespace

TEST(Extension, OnAPlaneIsTheStraightLineAheadToTheRim)
{
    const Plane plane(Diagonals::alternating);
    // The region ends at x = 80 only, so the ways have different lengths.
    const Region region =
        hand_made_region(plane.model.mesh, faces_where(plane.model.mesh, [](const Vec3& p) { return p.x() < 81; }));
    const auto e = extend_line(plane.model, region, hand_made_move(plane.model.mesh, plane.line, still));
    ASSERT_TRUE(e) << e.error().message;
    expect_sound(*e, plane.line);
    EXPECT_EQ(Vec3(e->model.mesh.V.row(e->vertices.front())), Vec3(0, 50, 0));
    EXPECT_EQ(Vec3(e->model.mesh.V.row(e->vertices.back())), Vec3(80, 50, 0));
    for (const int v : e->vertices) {
        EXPECT_NEAR(e->model.mesh.V(v, 1), 50, 1e-9);
    }
    EXPECT_TRUE(e->appended.empty());
}

TEST(Extension, CutsTrianglesAlongTheGeodesicWithoutChangingTheSurface)
{
    // A slanted line: the straight way ahead crosses triangles.
    const Plane plane;
    const auto at = [](int i, int j) { return j * 21 + i; };
    const std::vector<int> line{at(8, 9), at(9, 10), at(10, 10), at(11, 11), at(12, 11), at(13, 12)};
    const auto topology = Topology(plane.model.mesh.F, static_cast<int>(plane.model.mesh.V.rows()));
    std::vector<int> joined{line[0]};
    for (size_t i = 1; i < line.size(); ++i) {
        if (topology.find_edge(joined.back(), line[i]) < 0) {
            joined.push_back(line[i] - 1); // go round the corner where the diagonal runs the other way
        }
        joined.push_back(line[i]);
    }
    const auto e =
        extend_line(plane.model, whole_mesh_region(plane.model.mesh), hand_made_move(plane.model.mesh, joined, still));
    ASSERT_TRUE(e) << e.error().message;
    expect_sound(*e, joined);
    expect_same_surface(plane.model, *e);
    EXPECT_GT(e->appended.size(), 4U);
    // On a plane the geodesic is the chord; snapping takes the way off it by at most a quarter of an edge (7.5 mm).
    for (const auto& [from, to] :
         {std::pair{0, e->first}, std::pair{e->last, static_cast<int>(e->vertices.size()) - 1}}) {
        const Vec3 a = e->model.mesh.V.row(e->vertices[from]), b = e->model.mesh.V.row(e->vertices[to]);
        for (int i = from; i <= to; ++i) {
            const Vec3 p = Vec3(e->model.mesh.V.row(e->vertices[i])) - a;
            EXPECT_LT(p.cross((b - a).normalized()).norm(), 2.0);
        }
    }
}

TEST(Extension, AlongEdgesAppendsNothing)
{
    const Plane plane;
    ExtensionOptions options;
    options.path = ExtensionPath::edges;
    const auto e = extend_line(plane.model, whole_mesh_region(plane.model.mesh),
                               hand_made_move(plane.model.mesh, plane.line, still), options);
    ASSERT_TRUE(e) << e.error().message;
    expect_sound(*e, plane.line);
    EXPECT_TRUE(e->appended.empty());
    EXPECT_EQ(e->model.mesh.F, plane.model.mesh.F);
}

TEST(Extension, FollowsTheRestOfTheCreaseToThePanelsBorder)
{
    const Model panel = model_of(crease_panel(60, 40));
    const auto crease = crease_panel_line(60, 40);
    Correspondence c =
        hand_made_move(panel.mesh, std::vector<int>(crease.begin() + 15, crease.end() - 15), [](auto& p) {
            const double w = std::cos(std::numbers::pi * p.x() / 400);
            return Vec3(0, 100 * w * w, crease_panel_height(p.x(), 100 * w * w) - p.z());
        });
    c.before.assign(crease.rend() - 15, crease.rend());
    c.after.assign(crease.end() - 15, crease.end());
    const auto e = extend_line(panel, whole_mesh_region(panel.mesh), c);
    ASSERT_TRUE(e) << e.error().message;
    EXPECT_EQ(e->vertices, crease);
    EXPECT_TRUE(e->appended.empty());
    for (size_t i = 0; i < crease.size(); ++i) {
        const double x = std::abs(panel.mesh.V(crease[i], 0));
        if (x >= 200) {
            EXPECT_LT((e->targets[i] - Vec3(panel.mesh.V.row(crease[i]))).norm(), 1e-9);
        }
    }
}

TEST(Extension, LeavesTheCreasesOwnEndByAGeodesic)
{
    // The feature line goes on for three more vertices beyond each end of the used part, then ends inside.
    const Plane plane;
    Correspondence c = hand_made_move(plane.model.mesh, {plane.line[2], plane.line[3]}, still);
    c.before = {plane.line[1], plane.line[0]};
    c.after = {plane.line[4], plane.line[5]};
    const auto e = extend_line(plane.model, whole_mesh_region(plane.model.mesh), c);
    ASSERT_TRUE(e) << e.error().message;
    expect_sound(*e, c.line.vertices);
    EXPECT_TRUE(std::equal(plane.line.begin(), plane.line.end(), e->vertices.begin() + e->first - 2));
    EXPECT_LT(e->model.mesh.V(e->vertices.front(), 0), 1e-9);
    EXPECT_GT(e->model.mesh.V(e->vertices.back(), 0), 100 - 1e-9);
}

TEST(Extension, FadesTheEndDisplacementMonotonicallyToZeroAtTheRim)
{
    const Plane plane;
    const Vec3 slide(0, 12, 0);
    const auto e = extend_line(plane.model, whole_mesh_region(plane.model.mesh),
                               hand_made_move(plane.model.mesh, plane.line, [&](auto&) { return slide; }));
    ASSERT_TRUE(e) << e.error().message;
    const auto size = [&](size_t i) { return (e->targets[i] - Vec3(e->model.mesh.V.row(e->vertices[i]))).norm(); };
    EXPECT_EQ(size(0), 0);
    EXPECT_EQ(size(e->vertices.size() - 1), 0);
    for (size_t i = 1; i < e->vertices.size(); ++i) {
        if (static_cast<int>(i) <= e->first) {
            EXPECT_GE(size(i), size(i - 1));
        } else if (static_cast<int>(i) > e->last) {
            EXPECT_LE(size(i), size(i - 1));
        }
        EXPECT_LE(size(i), 12 + 1e-12);
        EXPECT_NEAR(e->targets[i].z(), 0, 1e-12);
    }
}

TEST(Extension, LeavesAFreeExtensionWithoutTargetsButHoldsTheRim)
{
    const Plane plane;
    ExtensionOptions options;
    options.target = ExtensionTarget::free;
    const auto e = extend_line(plane.model, whole_mesh_region(plane.model.mesh),
                               hand_made_move(plane.model.mesh, plane.line, still), options);
    ASSERT_TRUE(e) << e.error().message;
    for (int i = 1; i + 1 < static_cast<int>(e->vertices.size()); ++i) {
        EXPECT_EQ(e->targets[i].allFinite(), i >= e->first && i <= e->last) << i;
    }
    EXPECT_EQ(e->targets.front(), Vec3(e->model.mesh.V.row(e->vertices.front())));
    EXPECT_EQ(e->targets.back(), Vec3(e->model.mesh.V.row(e->vertices.back())));
}

TEST(Extension, LeavesALoopAndEndsOnTheBorderAsTheyAre)
{
    const Plane plane(Diagonals::alternating);
    const Region region = whole_mesh_region(plane.model.mesh);
    const auto at = [](int i, int j) { return j * 21 + i; };
    Correspondence loop = hand_made_move(plane.model.mesh, {at(9, 9), at(10, 9), at(10, 10), at(9, 10)}, still);
    loop.line.closed = true;
    const auto closed = extend_line(plane.model, region, loop);
    ASSERT_TRUE(closed) << closed.error().message;
    EXPECT_TRUE(closed->closed);
    EXPECT_EQ(closed->vertices, loop.line.vertices);
    EXPECT_EQ(closed->last, 3);
    EXPECT_EQ(closed->model.mesh.F, plane.model.mesh.F);

    std::vector<int> row;
    for (int i = 0; i <= 20; ++i) {
        row.push_back(at(i, 10));
    }
    const auto across = extend_line(plane.model, region, hand_made_move(plane.model.mesh, row, still));
    ASSERT_TRUE(across) << across.error().message;
    EXPECT_EQ(across->vertices, row);
    EXPECT_EQ(across->first, 0);
    EXPECT_EQ(across->last, 20);
}

TEST(Taper, FallsMonotonicallyWhateverTheSlope)
{
    for (const double slope : {-1e9, -10.0, -0.03, 0.0, 0.5, 1e9}) {
        double last = 1;
        for (int i = 0; i <= 1000; ++i) {
            const double h = taper(0.1 * i, 100, slope);
            EXPECT_LE(h, last + 1e-15);
            EXPECT_GE(h, 0);
            last = h;
        }
        EXPECT_EQ(taper(0, 100, slope), 1);
        EXPECT_EQ(taper(100, 100, slope), 0);
    }
    // Within the limits the slope at the line's end is matched.
    EXPECT_NEAR((taper(1e-6, 100, -0.02) - 1) / 1e-6, -0.02, 1e-6);
}

TEST(Taper, ThatEndsWithTheSurfaceBendsLeast)
{
    for (const double slope : {-0.05, -0.03, -0.01, 0.0}) {
        const auto h = [&](double s) { return taper(s, 100, slope, TaperEnd::natural); };
        const auto bending = [&](TaperEnd end) {
            double sum = 0;
            for (int i = 1; i < 1000; ++i) {
                const double s = 0.1 * i;
                const double second =
                    (taper(s - 0.1, 100, slope, end) - 2 * taper(s, 100, slope, end) + taper(s + 0.1, 100, slope, end));
                sum += second * second;
            }
            return sum;
        };
        for (int i = 1; i <= 1000; ++i) {
            EXPECT_LE(h(0.1 * i), h(0.1 * (i - 1)) + 1e-15);
        }
        EXPECT_EQ(h(0), 1);
        EXPECT_EQ(h(100), 0);
        EXPECT_NEAR(h(98) - 2 * h(99) + h(100), 0, 1e-3 * (1 - 2 * h(1) + h(2)) + 2e-5) << "straight at the border";
        EXPECT_NEAR((h(1e-6) - 1) / 1e-6, std::max(slope, -0.03), 1e-6);
        if (slope == 0) {
            // ∫ h"² is 3 / L³ against 12 / L³.
            EXPECT_NEAR(bending(TaperEnd::natural), bending(TaperEnd::clamped) / 4, 5e-3 * bending(TaperEnd::natural));
        }
    }
}
