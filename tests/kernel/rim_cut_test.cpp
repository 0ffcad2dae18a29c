// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/rim_cut.h"
#include "kernel/topology.h"
#include "tests/support/moves.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double width = 83, edge = 20; // [mm]

/// A flat sheet of irregular triangles with a line of 200 mm in its middle, and the band around it.
struct Band {
    Model model =
        model_of(grid(30, 30, -300, 300, -300, 300, [](double, double) { return 0.0; }, Diagonals::random, {15}));
    FeatureLine line;
    RegionOptions options;
    Region region;
    RimCut cut;

    Band()
    {
        std::vector<int> vertices;
        for (int i = 10; i <= 20; ++i) {
            vertices.push_back(15 * 31 + i);
        }
        line = line_of(model, vertices);
        options.distance_mm = width;
        region = *make_region(model, line, {}, options);
        cut = cut_rim(model, line, {}, region, options);
    }

    double end(bool last) const { return model.mesh.V(last ? line.vertices.back() : line.vertices.front(), 0); }
    double distance(const Vec3& p) const
    {
        return std::hypot(std::max({0.0, end(false) - p.x(), p.x() - end(true)}), p.y());
    }
    static double area(const Model& model, const Region& region)
    {
        double sum = 0;
        for (const int t : region.faces) {
            sum += triangle_area(model.mesh, t);
        }
        return sum;
    }
    double worst(const Model& on, const Region& of) const
    {
        double farthest = 0;
        for (const int v : of.fixed_rim) {
            farthest = std::max(farthest, std::abs(distance(on.mesh.V.row(v)) - width));
        }
        return farthest;
    }
};

} // namespace

TEST(RimCut, RunsAlongTheLineOfEqualDistance)
{
    const Band band;
    EXPECT_GT(band.worst(band.model, band.region), 0.5 * edge);
    double longest = 0;
    const Topology topology(band.model.mesh.F, static_cast<int>(band.model.mesh.V.rows()));
    for (const MeshEdge& side : topology.edges()) {
        longest = std::max(longest, (band.model.mesh.V.row(side.a) - band.model.mesh.V.row(side.b)).norm());
    }
    // A tenth of an edge, and what the distances themselves are off.
    EXPECT_LT(band.worst(band.cut.model, band.cut.region), 0.1 * longest + 0.01 * width);
    const double exact = 2 * (band.end(true) - band.end(false)) * width + std::numbers::pi * width * width;
    EXPECT_NEAR(Band::area(band.cut.model, band.cut.region), exact, 0.01 * exact);
    EXPECT_LT(Band::area(band.model, band.region), 0.92 * exact);
}

TEST(RimCut, KeepsTheVerticesAndTheirOrderAndLeavesNoSliver)
{
    const Band band;
    const Eigen::Index before = band.model.mesh.V.rows();
    EXPECT_EQ(band.cut.model.mesh.V.topRows(before), band.model.mesh.V);
    EXPECT_EQ(band.cut.model.mesh.V.rows(), before + static_cast<Eigen::Index>(band.cut.appended.size()));
    EXPECT_GT(band.cut.appended.size(), 20u);
    for (size_t i = 0; i < band.cut.appended.size(); ++i) {
        const AppendedVertex& on = band.cut.appended[i];
        const Vec3 place = (1 - on.t) * band.model.mesh.V.row(on.a) + on.t * band.model.mesh.V.row(on.b);
        EXPECT_LE((Vec3(band.cut.model.mesh.V.row(before + static_cast<Eigen::Index>(i))) - place).norm(), 1e-12);
    }
    double all = 0, smallest = 1e9, smallest_before = 1e9;
    for (int t = 0; t < band.model.mesh.F.rows(); ++t) {
        smallest_before = std::min(smallest_before, triangle_area(band.model.mesh, t));
    }
    for (int t = 0; t < band.cut.model.mesh.F.rows(); ++t) {
        all += triangle_area(band.cut.model.mesh, t);
        smallest = std::min(smallest, triangle_area(band.cut.model.mesh, t));
    }
    EXPECT_NEAR(all, 600.0 * 600.0, 1e-6);
    EXPECT_GT(smallest, 0.0099 * smallest_before); // a tenth of two edges
    for (const int v : band.region.vertices) {
        const bool within = band.distance(band.model.mesh.V.row(v)) < 0.98 * width;
        EXPECT_TRUE(!within || std::ranges::binary_search(band.cut.region.vertices, v)) << v;
    }
}

TEST(RimCut, LeavesRegionsOfOtherKindsAsTheyAre)
{
    const Band band;
    RegionOptions box;
    box.box = Eigen::AlignedBox3d(Vec3(-200, -100, -1), Vec3(200, 100, 1));
    const Region region = *make_region(band.model, band.line, {}, box);
    const RimCut cut = cut_rim(band.model, band.line, {}, region, box);
    EXPECT_TRUE(cut.appended.empty());
    EXPECT_EQ(cut.region.faces, region.faces);
    EXPECT_EQ(cut.model.mesh.F, band.model.mesh.F);
}
