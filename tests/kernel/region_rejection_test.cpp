// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/region.h"
#include "kernel/region_shape.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::vector<int> row_part(int nx, int j, int from, int to)
{
    std::vector<int> row(to - from + 1);
    std::iota(row.begin(), row.end(), j * (nx + 1) + from);
    return row;
}

/// A flat sheet on [-200, 200] × [-100, 100], cells of 10 mm; the line is the middle row from x = -50 to 50.
struct Sheet {
    Model model = model_of(grid(40, 20, -200, 200, -100, 100, [](double, double) { return 0.0; }));
    FeatureLine line = *line_through(model, row_part(40, 10, 15, 25));

    std::vector<Vec3> moved(const std::function<Vec3(const Vec3&)>& u) const
    {
        std::vector<Vec3> targets;
        for (const int v : line.vertices) {
            const Vec3 p = model.mesh.V.row(v);
            targets.emplace_back(p + u(p));
        }
        return targets;
    }
};

void expect_refused(const Result<Region>& region, ErrorKind kind, const std::vector<std::string>& words)
{
    ASSERT_FALSE(region);
    EXPECT_EQ(region.error().kind, kind);
    for (const std::string& word : words) {
        EXPECT_NE(region.error().message.find(word), std::string::npos) << region.error().message;
    }
}

} // namespace

TEST(RegionRejection, OfATargetThatStartsFartherAwayThanTheWidth)
{
    const Sheet sheet;
    RegionOptions options;
    options.distance_mm = 30;
    expect_refused(
        make_region(sheet.model, sheet.line, sheet.moved([](const Vec3&) { return Vec3(0, 55, 0); }), options),
        ErrorKind::rejected, {"starts 55 mm away", "vertex 425 at (-50, 0, 0)", "width of 30 mm"});
    expect_refused(make_region(sheet.model, sheet.line,
                               sheet.moved([](const Vec3& p) { return Vec3(0, p.x() < -45 ? 31 : 10, 0); }), options),
                   ErrorKind::rejected, {"starts 31 mm away", "vertex 425"});
    expect_refused(make_region(sheet.model, sheet.line,
                               sheet.moved([](const Vec3& p) { return Vec3(0, 0, std::abs(p.x()) < 5 ? 31 : 10); }),
                               options),
                   ErrorKind::rejected, {"31 mm off the surface", "(0, 0, 31)"});
}

TEST(RegionRejection, OfATargetThatCrossesTheRim)
{
    const Sheet sheet;
    RegionOptions options;
    options.box.emplace(Vec3(-105, -55, -1), Vec3(105, 55, 1));
    const auto bulging = [](double height) {
        return [height](const Vec3& p) { return Vec3(0, height * std::cos(p.x() / 50 * M_PI / 2), 0); };
    };
    EXPECT_TRUE(make_region(sheet.model, sheet.line, sheet.moved(bulging(40)), options));
    expect_refused(make_region(sheet.model, sheet.line, sheet.moved(bulging(70)), options), ErrorKind::rejected,
                   {"crosses the region's fixed rim", "goal of line vertex"});
    expect_refused(
        make_region(sheet.model, sheet.line, sheet.moved([](const Vec3&) { return Vec3(0, 80, 0); }), options),
        ErrorKind::rejected, {"lies outside the region", "80 mm"});
    // Beyond the model's own border, the nearest surface point is on the border.
    expect_refused(make_region(sheet.model, sheet.line, sheet.moved(bulging(120))), ErrorKind::rejected,
                   {"crosses the region's fixed rim", "goal of line vertex"});
}

TEST(RegionRejection, OfALineThatLeavesTheRegionOrRunsOnItsRim)
{
    const Sheet sheet;
    RegionOptions options;
    options.box.emplace(Vec3(-35, -55, -1), Vec3(105, 55, 1));
    expect_refused(make_region(sheet.model, sheet.line, {}, options), ErrorKind::rejected,
                   {"does not hold", "vertex 425", "enlarge the box"});
    const auto border = line_through(sheet.model, row_part(40, 0, 15, 25));
    expect_refused(make_region(sheet.model, *border, {}), ErrorKind::rejected, {"open border", "vertex 15 at"});
    // Up the border, along an inner edge, and on: the line touches the border in between.
    const auto touching = line_through(sheet.model, {43, 2, 44});
    ASSERT_TRUE(touching) << touching.error().message;
    expect_refused(make_region(sheet.model, *touching, {}), ErrorKind::rejected,
                   {"touches the region's fixed rim", "vertex 2 at"});
}

TEST(RegionRejection, LeavesALineAloneThatEndsOnTheBorder)
{
    const Sheet sheet;
    const auto whole = line_through(sheet.model, row_part(40, 10, 0, 40));
    std::vector<Vec3> targets;
    for (const int v : whole->vertices) {
        targets.emplace_back(sheet.model.mesh.V.row(v) + Eigen::RowVector3d(0, 12, 0));
    }
    const auto region = make_region(sheet.model, *whole, targets);
    EXPECT_TRUE(region) << region.error().message;
}

TEST(RegionRejection, OfTrianglesThatTheMethodCannotUse)
{
    Sheet flat;
    flat.model.mesh.V.row(8 * 41 + 20) = flat.model.mesh.V.row(8 * 41 + 21);
    expect_refused(make_region(flat.model, flat.line, {}), ErrorKind::rejected, {"has no area", "triangle"});
    Sheet fin;
    const auto faces = fin.model.mesh.F.rows();
    fin.model.mesh.F.conservativeResize(faces + 1, 3);
    fin.model.mesh.F.row(faces) << 8 * 41 + 20, 8 * 41 + 21, 0;
    expect_refused(make_region(fin.model, fin.line, {}), ErrorKind::rejected, {"3 triangles meet", "vertex 348 at"});
    // Outside the region the same fin is nobody's business.
    RegionOptions options;
    options.distance_mm = 15;
    EXPECT_TRUE(make_region(fin.model, fin.line, {}, options));
}

TEST(RegionRejection, OfAClosedSurfaceWithoutRim)
{
    const Model model = model_of(ball(24));
    std::vector<int> equator(24);
    std::iota(equator.begin(), equator.end(), 5 * 24);
    equator.push_back(equator.front());
    RegionOptions options;
    options.distance_mm = 10;
    expect_refused(make_region(model, *line_through(model, equator), {}, options), ErrorKind::rejected,
                   {"no fixed rim", "smaller region"});
}

TEST(RegionRejection, OfOptionsThatMakeNoSense)
{
    const Sheet sheet;
    RegionOptions two;
    two.distance_mm = 30;
    two.box.emplace(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    expect_refused(make_region(sheet.model, sheet.line, {}, two), ErrorKind::usage, {"only one"});
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        RegionOptions options;
        options.distance_mm = bad;
        expect_refused(make_region(sheet.model, sheet.line, {}, options), ErrorKind::usage, {"distance"});
    }
    RegionOptions fixed;
    fixed.fixed_vertices = {5, 426};
    expect_refused(make_region(sheet.model, sheet.line, {}, fixed), ErrorKind::rejected, {"vertex 426", "moves"});
    fixed.fixed_vertices = {100000};
    expect_refused(make_region(sheet.model, sheet.line, {}, fixed), ErrorKind::rejected, {"100000"});
    RegionOptions faces;
    faces.cad_faces = {0};
    expect_refused(make_region(sheet.model, sheet.line, {}, faces), ErrorKind::rejected, {"without them"});
    RegionOptions lines;
    lines.bounding_lines = {{0, 5}};
    expect_refused(make_region(sheet.model, sheet.line, {}, lines), ErrorKind::rejected, {"0 and 5"});
}

TEST(RegionShape, TidyingLeavesNoVertexWhereTheRegionTouchesItself)
{
    // Random holes punched into a sheet, half of the triangles: a nasty lace.
    const Sheet sheet;
    const Mesh& mesh = sheet.model.mesh;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const auto keep = faces_along(topology, sheet.line);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 sequence(seed);
        FaceSet lace(mesh.F.rows());
        for (char& inside : lace) {
            inside = sequence() % 10 < 4 + seed % 4;
        }
        for (const int t : keep) {
            lace[t] = 1;
        }
        const FaceSet region = tidy(mesh, topology, lace, keep);
        EXPECT_EQ(connected_part(topology, region, {keep.front()}), region) << "one part";
        for (const int t : keep) {
            EXPECT_TRUE(region[t]);
        }
        for (int v = 0; v < topology.vertex_count(); ++v) {
            int turns = 0;
            for (const int e : topology.vertex_edges(v)) {
                const MeshEdge& edge = topology.edge(e);
                turns += (edge.left >= 0 && region[edge.left]) != (edge.right >= 0 && region[edge.right]) ? 1 : 0;
            }
            EXPECT_LE(turns, 2) << "vertex " << v << " seed " << seed;
        }
    }
}
