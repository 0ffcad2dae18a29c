// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension.h"
#include "kernel/geodesic_path.h"
#include "tests/support/hand_made.h"
#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr int n = 40; ///< cells a side

int at(int i, int j) { return j * (n + 1) + i; }
Vec3 still(const Vec3&) { return Vec3::Zero(); }

Model plate(Diagonals diagonals = Diagonals::random)
{
    return model_of(grid(n, n, 0, n, 0, n, [](double, double) { return 0.0; }, diagonals, {n / 2}));
}

std::vector<int> middle_line(int from, int to)
{
    std::vector<int> line;
    for (int i = from; i <= to; ++i) {
        line.push_back(at(i, n / 2));
    }
    return line;
}

/// Smallest distance of the extension beyond the line's last vertex to a point.
double clearance(const ExtendedLine& e, const Vec3& p)
{
    double smallest = 1e9;
    for (size_t i = e.last + 1; i < e.vertices.size(); ++i) {
        smallest = std::min(smallest, (Vec3(e.model.mesh.V.row(e.vertices[i])) - p).norm());
    }
    return smallest;
}

} // namespace

TEST(Geodesic, RunsRoundAWallThroughItsEnd)
{
    const Model model = plate(Diagonals::alternating);
    std::vector<int> faces(model.mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    std::vector<VertexPair> wall; // from the top border down to the middle, at x = 20
    for (int j = 20; j < n; ++j) {
        wall.push_back(vertex_pair(at(20, j), at(20, j + 1)));
    }
    std::ranges::sort(wall);
    const auto path = geodesic_path(model.mesh, faces, at(10, 30), at(30, 30), wall);
    ASSERT_TRUE(path) << path.error().message;
    // By symmetry the way bends at the wall's lower end, (20, 20): twice √(10² + 10²).
    EXPECT_NEAR(path_length(model.mesh, *path), 2 * std::sqrt(200), 1e-9);
    const auto open = geodesic_path(model.mesh, faces, at(3, 5), at(30, 33), {});
    ASSERT_TRUE(open) << open.error().message;
    EXPECT_NEAR(path_length(model.mesh, *open), std::hypot(27, 28), 1e-9);
    EXPECT_FALSE(geodesic_path(model.mesh, std::vector<int>{0, 1}, at(3, 5), at(30, 33), {}));
}

TEST(Extension, PassesAHoleAndReachesTheOuterRim)
{
    const Model model = plate();
    const Vec3 hole(32, 20, 0);
    const auto faces = faces_where(model.mesh, [&](const Vec3& p) { return (p - hole).norm() > 3; });
    const auto line = middle_line(15, 25);
    const auto e = extend_line(model, hand_made_region(model.mesh, faces), hand_made_move(model.mesh, line, still));
    ASSERT_TRUE(e) << e.error().message;
    for (const int end : {e->vertices.front(), e->vertices.back()}) {
        const Vec3 p = e->model.mesh.V.row(end);
        EXPECT_NEAR(std::min({p.x(), p.y(), n - p.x(), n - p.y()}), 0, 1e-12);
    }
    EXPECT_GT(clearance(*e, hole), 3);
}

TEST(Extension, KeepsClearOfInnerFixedVertices)
{
    const Model model = plate();
    Region region = whole_mesh_region(model.mesh);
    for (int j = 16; j <= 24; ++j) {
        region.inner_fixed.push_back(at(32, j)); // a bar across the straight way
    }
    const auto e = extend_line(model, region, hand_made_move(model.mesh, middle_line(15, 25), still));
    ASSERT_TRUE(e) << e.error().message;
    const Topology topology(e->model.mesh.F, static_cast<int>(e->model.mesh.V.rows()));
    for (int i = e->last + 1; i < static_cast<int>(e->vertices.size()); ++i) {
        EXPECT_FALSE(std::ranges::binary_search(region.inner_fixed, e->vertices[i]));
    }
    for (size_t i = 1; i < region.inner_fixed.size(); ++i) {
        EXPECT_GE(topology.find_edge(region.inner_fixed[i - 1], region.inner_fixed[i]), 0) << "the bar was cut";
    }
}

TEST(Extension, GoesRoundAShortFeatureLineButCrossesALongOne)
{
    // A ridge of 17° on each side across the way, of which `half` vertices each way from the middle are there.
    for (const int half : {3, 40}) {
        const auto ridge = [&](double x, double y) {
            const double here = half > n ? 1 : std::clamp((half - std::abs(y - n / 2)) / 2, 0.0, 1.0);
            return 0.3 * here * std::max(0.0, 2 - std::abs(x - 32));
        };
        const Model model = model_of(grid(n, n, 0, n, 0, n, ridge));
        const auto e =
            extend_line(model, whole_mesh_region(model.mesh), hand_made_move(model.mesh, middle_line(15, 25), still));
        ASSERT_TRUE(e) << e.error().message;
        EXPECT_EQ(e->warnings.empty(), half == 3);
        EXPECT_EQ(e->model.mesh.V(e->vertices.back(), 0) == n, true);
    }
}

TEST(Extension, NeverMeetsTheLineOrItsOtherHalf)
{
    // A hook: the line's end points back at its own middle.
    const Model model = plate(Diagonals::alternating);
    std::vector<int> hook;
    for (int i = 10; i <= 30; ++i) {
        hook.push_back(at(i, 12));
    }
    for (int j = 13; j <= 24; ++j) {
        hook.push_back(at(30, j));
    }
    for (int i = 29; i >= 20; --i) {
        hook.push_back(at(i, 24));
    }
    for (int j = 23; j >= 18; --j) {
        hook.push_back(at(20, j));
    }
    for (const ExtensionPath path : {ExtensionPath::geodesic, ExtensionPath::edges}) {
        ExtensionOptions options;
        options.path = path;
        const auto e =
            extend_line(model, whole_mesh_region(model.mesh), hand_made_move(model.mesh, hook, still), options);
        ASSERT_TRUE(e) << e.error().message;
        std::vector<int> sorted = e->vertices;
        std::ranges::sort(sorted);
        EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
        EXPECT_EQ(count_surface(e->model.mesh).bad_edges, 0);
        EXPECT_NEAR(total_area(e->model.mesh), n * n, 1e-9);
    }
}

TEST(Extension, RefusesWhatCannotBeProlonged)
{
    const Model model = plate();
    const auto line = middle_line(15, 25);
    // The end is pushed beyond the rim.
    const auto too_far = extend_line(model, whole_mesh_region(model.mesh),
                                     hand_made_move(model.mesh, line, [](auto&) { return Vec3(30, 0, 0); }));
    ASSERT_FALSE(too_far);
    EXPECT_NE(too_far.error().message.find("enlarge the region"), std::string::npos);
    // The line leaves the region.
    const auto faces = faces_where(model.mesh, [](const Vec3& p) { return p.x() < 20.5; });
    EXPECT_FALSE(extend_line(model, hand_made_region(model.mesh, faces), hand_made_move(model.mesh, line, still)));
    // Not a line of the mesh, and no line at all.
    const Region region = whole_mesh_region(model.mesh);
    EXPECT_FALSE(extend_line(model, region, hand_made_move(model.mesh, {at(5, 5), at(9, 9)}, still)));
    EXPECT_FALSE(extend_line(model, region, hand_made_move(model.mesh, {at(5, 5)}, still)));
    Correspondence unknown = hand_made_move(model.mesh, line, still);
    unknown.after = {1 << 30};
    EXPECT_FALSE(extend_line(model, region, unknown));
}

TEST(Extension, OfAPartlyUsedLoopIsTheRestOfTheLoop)
{
    const Model model = plate(Diagonals::alternating);
    std::vector<int> loop;
    for (int i = 15; i < 25; ++i) {
        loop.push_back(at(i, 15));
    }
    for (int j = 15; j < 25; ++j) {
        loop.push_back(at(25, j));
    }
    for (int i = 25; i > 15; --i) {
        loop.push_back(at(i, 25));
    }
    for (int j = 25; j > 15; --j) {
        loop.push_back(at(15, j));
    }
    Correspondence c = hand_made_move(model.mesh, std::vector<int>(loop.begin(), loop.begin() + 10),
                                      [](auto&) { return Vec3(0, -1, 0); });
    c.after.assign(loop.begin() + 10, loop.end());
    c.before.assign(c.after.rbegin(), c.after.rend());
    const auto e = extend_line(model, whole_mesh_region(model.mesh), c);
    ASSERT_TRUE(e) << e.error().message;
    EXPECT_TRUE(e->closed);
    EXPECT_EQ(e->vertices, loop);
    EXPECT_EQ(e->last, 9);
    double last = 1;
    for (int i = 10; i < 24; ++i) {
        const double left = (e->targets[i] - Vec3(model.mesh.V.row(loop[i]))).norm();
        EXPECT_LE(left, last + 1e-12);
        last = left;
    }
    // 31 edges are not used; the arms meet after 15 of them, counted from the last used vertex.
    EXPECT_EQ(e->targets[24], Vec3(model.mesh.V.row(loop[24])));
}
