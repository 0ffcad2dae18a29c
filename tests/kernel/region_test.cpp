// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/region.h"
#include "kernel/topology.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <set>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// A flat sheet on [-200, 200] × [-100, 100], cells of 5 mm; the line is the middle row from x = -50 to 50.
struct Sheet {
    explicit Sheet(Diagonals diagonals = Diagonals::alternating)
        : model(model_of(grid(80, 40, -200, 200, -100, 100, [](double, double) { return 0.0; }, diagonals, {20})))
    {
        std::vector<int> row(21);
        std::iota(row.begin(), row.end(), 20 * 81 + 30);
        line = *line_through(model, row);
    }
    std::vector<Vec3> moved_by(const Vec3& u) const
    {
        std::vector<Vec3> targets;
        for (const int v : line.vertices) {
            targets.emplace_back(Vec3(model.mesh.V.row(v)) + u);
        }
        return targets;
    }
    Model model;
    FeatureLine line;
};

/// Distance of a point of the sheet to the segment y = `offset`, |x| ≤ 50.
double to_segment(const Mesh& mesh, int v, double offset)
{
    return std::hypot(std::max(0.0, std::abs(mesh.V(v, 0)) - 50), mesh.V(v, 1) - offset);
}

RegionOptions by_distance(double mm)
{
    RegionOptions options;
    options.distance_mm = mm;
    return options;
}

/// Number of vertices around which the region's triangles do not form one fan.
int pinched_vertices(const Mesh& mesh, const Region& region)
{
    Triangles F(static_cast<Eigen::Index>(region.faces.size()), 3);
    for (size_t i = 0; i < region.faces.size(); ++i) {
        F.row(static_cast<Eigen::Index>(i)) = mesh.F.row(region.faces[i]);
    }
    const Topology topology(F, static_cast<int>(mesh.V.rows()));
    int pinched = 0;
    for (int v = 0; v < topology.vertex_count(); ++v) {
        int borders = 0;
        for (const int e : topology.vertex_edges(v)) {
            borders += topology.edge(e).border() ? 1 : 0;
        }
        pinched += borders > 2 ? 1 : 0;
    }
    return pinched;
}

} // namespace

TEST(Region, IsTheBandWithinTheDistanceOfLineAndTarget)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const Sheet sheet(diagonals);
        const auto region = make_region(sheet.model, sheet.line, sheet.moved_by({0, 20, 0}), by_distance(32));
        ASSERT_TRUE(region) << region.error().message;
        EXPECT_EQ(region->distance_mm, 32);
        std::set<int> inside(region->faces.begin(), region->faces.end());
        for (int t = 0; t < sheet.model.mesh.F.rows(); ++t) {
            double farthest = 0;
            for (int k = 0; k < 3; ++k) {
                const int v = sheet.model.mesh.F(t, k);
                farthest = std::max(farthest,
                                    std::min(to_segment(sheet.model.mesh, v, 0), to_segment(sheet.model.mesh, v, 20)));
            }
            if (farthest < 31.5) {
                EXPECT_TRUE(inside.contains(t)) << t;
            }
            // Tidying may add a triangle at a notch, never more than one edge beyond the band.
            if (farthest > 32 + 10) {
                EXPECT_FALSE(inside.contains(t)) << t;
            }
        }
        EXPECT_EQ(pinched_vertices(sheet.model.mesh, *region), 0);
    }
}

TEST(Region, HasAsRimAllVerticesThatItSharesWithTheOutside)
{
    const Sheet sheet(Diagonals::random);
    const auto region = make_region(sheet.model, sheet.line, {}, by_distance(40));
    ASSERT_TRUE(region);
    EXPECT_TRUE(std::ranges::is_sorted(region->faces));
    EXPECT_TRUE(std::ranges::is_sorted(region->vertices));
    EXPECT_TRUE(std::ranges::is_sorted(region->fixed_rim));
    std::set<int> outside, shared;
    for (int t = 0; t < sheet.model.mesh.F.rows(); ++t) {
        if (!std::ranges::binary_search(region->faces, t)) {
            outside.insert(sheet.model.mesh.F.row(t).begin(), sheet.model.mesh.F.row(t).end());
        }
    }
    for (const int v : region->vertices) {
        if (outside.contains(v)) {
            shared.insert(v);
        }
    }
    EXPECT_EQ(std::set<int>(region->fixed_rim.begin(), region->fixed_rim.end()), shared);
}

TEST(Region, ChoosesAWidthThatLeavesRoomForTheMove)
{
    const Sheet sheet;
    const auto region = make_region(sheet.model, sheet.line, sheet.moved_by({0, 15, 0}));
    ASSERT_TRUE(region);
    EXPECT_DOUBLE_EQ(region->distance_mm, 45);
    const auto still = make_region(sheet.model, sheet.line, sheet.moved_by({0, 1, 0}));
    ASSERT_TRUE(still);
    EXPECT_DOUBLE_EQ(still->distance_mm, 35);
}

TEST(Region, FixesOpenBordersUnlessTheyAreFreed)
{
    const Sheet sheet;
    RegionOptions options = by_distance(120); // reaches y = ±100
    const auto fixed = make_region(sheet.model, sheet.line, {}, options);
    options.free_borders = true;
    const auto free = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_TRUE(fixed && free);
    EXPECT_EQ(fixed->faces, free->faces);
    const int on_border = 40; // x = 0, y = -100
    EXPECT_TRUE(std::ranges::binary_search(fixed->fixed_rim, on_border));
    EXPECT_FALSE(std::ranges::binary_search(free->fixed_rim, on_border));
    EXPECT_LT(free->fixed_rim.size(), fixed->fixed_rim.size());
}

TEST(Region, ByBoxHoldsTheTrianglesWithAllCornersInIt)
{
    const Sheet sheet;
    RegionOptions options;
    options.box.emplace(Vec3(-71, -41, -1), Vec3(71, 56, 1));
    const auto region = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_EQ(region->faces.size(), 2U * 28 * 19); // |x| ≤ 70, -40 ≤ y ≤ 55
    EXPECT_EQ(region->distance_mm, 0);
}

TEST(Region, ByCadFacesHoldsTheirPartAroundTheLine)
{
    Sheet sheet;
    // Stripes of CAD faces along x, 10 cells wide in y: faces 0 to 3. The line lies between 1 and 2.
    for (int t = 0; t < sheet.model.mesh.F.rows(); ++t) {
        sheet.model.cad_face.push_back(t / (2 * 80 * 10));
    }
    RegionOptions options;
    options.cad_faces = {1, 2};
    const auto region = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_EQ(region->faces.size(), 2U * 80 * 20);
    options.cad_faces = {0, 1};
    const auto one_side = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_FALSE(one_side);
    EXPECT_NE(one_side.error().message.find("CAD faces on both sides"), std::string::npos) << one_side.error().message;
    options.cad_faces = {1, 9};
    EXPECT_NE(make_region(sheet.model, sheet.line, {}, options).error().message.find("no CAD face 9"),
              std::string::npos);
}

TEST(Region, ByBoundingLinesIsWhatTheyAndTheBordersEnclose)
{
    const Sheet sheet;
    std::vector<int> lower(81), upper(81);
    std::iota(lower.begin(), lower.end(), 12 * 81);
    std::iota(upper.begin(), upper.end(), 31 * 81);
    RegionOptions options;
    options.bounding_lines = {lower, upper};
    const auto region = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_EQ(region->faces.size(), 2U * 80 * 19);
    EXPECT_TRUE(region->warnings.empty());

    options.bounding_lines = {lower, {upper.begin(), upper.begin() + 40}};
    const auto leaking = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_TRUE(leaking);
    ASSERT_FALSE(leaking->warnings.empty());
    EXPECT_NE(leaking->warnings[0].find("do not close"), std::string::npos);
}

TEST(Region, AroundACircleIsARing)
{
    const Model model = model_of(cylinder(48, 60, 10, 60));
    std::vector<int> circle(49);
    std::iota(circle.begin(), circle.end(), 30 * 48);
    circle.back() = circle.front();
    const auto line = line_through(model, circle);
    ASSERT_TRUE(line && line->closed);
    const auto region = make_region(model, *line, {}, by_distance(12.5));
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_EQ(region->faces.size(), 2U * 48 * 24);
    EXPECT_EQ(region->fixed_rim.size(), 2U * 48);
    EXPECT_TRUE(region->warnings.empty());
}

TEST(Region, OfItselfIsNarrowedWhereItWouldCloseRoundTheModel)
{
    // A line along a slender cylinder: three displacements reach round to its other side.
    const Model model = model_of(cylinder(48, 60, 10, 60));
    std::vector<int> up(31);
    std::vector<Vec3> targets;
    for (int j = 0; j < 31; ++j) {
        up[j] = (15 + j) * 48;
        targets.push_back(model.mesh.V.row(up[j] + 8)); // a sixth of the way round, 10.5 mm
    }
    const auto line = line_through(model, up);
    const auto region = make_region(model, *line, targets);
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_LT(region->distance_mm, 30);
    ASSERT_EQ(region->warnings.size(), 1U);
    EXPECT_NE(region->warnings[0].find("narrowed"), std::string::npos);
    // Given by hand it is taken as it is, with a word about its form.
    const auto wide = make_region(model, *line, targets, by_distance(28));
    ASSERT_TRUE(wide);
    ASSERT_FALSE(wide->warnings.empty());
    EXPECT_NE(wide->warnings.back().find("not a disk"), std::string::npos);
}

TEST(Region, CompletesAGivenListOfTriangles)
{
    const Sheet sheet;
    std::vector<int> faces;
    for (int j = 15; j < 25; ++j) {
        for (int i = 59; i >= 20; --i) {
            faces.push_back(2 * (j * 80 + i) + 1);
            faces.push_back(2 * (j * 80 + i));
        }
    }
    const int inner = 18 * 81 + 40;
    const Region region = region_of_faces(sheet.model, faces, false, {inner, 0});
    EXPECT_EQ(region.faces.size(), 800U);
    EXPECT_TRUE(std::ranges::is_sorted(region.faces));
    EXPECT_EQ(region.vertices.size(), 41U * 11);
    EXPECT_EQ(region.fixed_rim.size(), 2U * 40 + 2 * 10);
    EXPECT_EQ(region.inner_fixed, std::vector<int>{inner});
}

TEST(RegionByFaces, FixedCadFacesHoldAllTheirVertices)
{
    Sheet sheet;
    sheet.model.cad_face.assign(sheet.model.mesh.F.rows(), 0);
    for (Eigen::Index t = 0; t < sheet.model.mesh.F.rows(); ++t) {
        const Vec3 middle =
            (sheet.model.mesh.V.row(sheet.model.mesh.F(t, 0)) + sheet.model.mesh.V.row(sheet.model.mesh.F(t, 1)) +
             sheet.model.mesh.V.row(sheet.model.mesh.F(t, 2))) /
            3;
        sheet.model.cad_face[t] = middle.y() > 30 ? 7 : 0;
    }
    RegionOptions options;
    options.distance_mm = 60;
    options.fixed_cad_faces = {7};
    const auto region = make_region(sheet.model, sheet.line, sheet.moved_by({0, 5, 0}), options);
    ASSERT_TRUE(region) << region.error().message;
    EXPECT_GT(region->inner_fixed.size(), 50U);
    for (const int v : region->vertices) {
        const bool held =
            std::ranges::binary_search(region->inner_fixed, v) || std::ranges::binary_search(region->fixed_rim, v);
        EXPECT_TRUE(held || sheet.model.mesh.V(v, 1) < 30);
    }
    options.fixed_cad_faces = {9};
    const auto unknown = make_region(sheet.model, sheet.line, {}, options);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("CAD face 9"), std::string::npos);
}
