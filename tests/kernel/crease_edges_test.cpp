// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/crease_edges.h"
#include "kernel/curve.h"
#include "kernel/feature_lines.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// A panel of 40 × 8 cells on [0, 400] × [-80, 80] whose two halves are CAD faces 0 (y < 0) and 1, with CAD edge 7 on
/// the row between them from vertex column `from` to `to`.
Model two_faces(const std::function<double(double, double)>& z, int from = 0, int to = 40)
{
    Model model = model_of(grid(40, 8, 0, 400, -80, 80, z));
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        model.cad_face.push_back(t < model.mesh.F.rows() / 2 ? 0 : 1);
    }
    for (int i = from; i < to; ++i) {
        model.cad_edges.push_back({4 * 41 + i, 4 * 41 + i + 1, 7});
    }
    return model;
}

double roof(double, double y) { return -0.1 * std::abs(y); }

/// Exact faces that are planes through the query point with given normals.
class Planes final : public SurfaceProjector {
public:
    Planes(Vec3 n0, Vec3 n1) : normals_{n0.normalized(), n1.normalized()} {}
    int face_count() const override { return 2; }
    std::optional<SurfaceFoot> closest(int face, const Vec3& p) const override
    {
        return SurfaceFoot{p, normals_[face]};
    }
    std::optional<Vec3> closest_on_edge(int, const Vec3& p) const override { return p; }

private:
    Vec3 normals_[2];
};

/// Exact faces given by a rule for their normals, met in an exact edge that lies `rise` above its chords.
class NormalRule final : public SurfaceProjector {
public:
    NormalRule(std::function<Vec3(int, const Vec3&)> rule, double rise) : rule_(std::move(rule)), rise_(rise) {}
    int face_count() const override { return 2; }
    std::optional<SurfaceFoot> closest(int face, const Vec3& p) const override
    {
        return SurfaceFoot{p, rule_(face, p).normalized()};
    }
    std::optional<Vec3> closest_on_edge(int, const Vec3& p) const override { return p + Vec3(0, 0, rise_); }

private:
    std::function<Vec3(int, const Vec3&)> rule_;
    double rise_;
};

} // namespace

TEST(StandingOutAngle, IsTheWholeAngleBetweenFlatSides)
{
    const Mesh mesh = flat_roof(20, 10, Diagonals::random);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const int e = topology.find_edge(5 * 21 + 10, 5 * 21 + 11);
    EXPECT_NEAR(standing_out_angle(mesh, topology, e), crease_angle(mesh, topology, e), 1e-9);
}

TEST(StandingOutAngle, IsNothingOnATessellatedCylinder)
{
    const Mesh mesh = cylinder(24, 6, 10, 30);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const int e = topology.find_edge(3 * 24 + 5, 4 * 24 + 5);
    EXPECT_NEAR(crease_angle(mesh, topology, e), 15, 1e-9);
    EXPECT_NEAR(standing_out_angle(mesh, topology, e), 0, 1e-9);
}

TEST(StandingOutAngle, TakesHalfAFacetOffWhereAFlatSideMeetsACurvedOne)
{
    // Flat for x < 0; beyond, facets 10 wide that turn by 6 degrees each; 20 degrees of crease between them.
    const auto height = [](double x, double) {
        double z = 0;
        for (int k = 0; 10 * k < x - 1e-9; ++k) {
            z -= std::min(10.0, x - 10 * k) * std::tan((20 + 6 * k) * M_PI / 180);
        }
        return z;
    };
    const Mesh mesh = grid(12, 6, -60, 60, -30, 30, height);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const int e = topology.find_edge(2 * 13 + 6, 3 * 13 + 6);
    EXPECT_NEAR(crease_angle(mesh, topology, e), 20, 1e-9);
    EXPECT_NEAR(standing_out_angle(mesh, topology, e), 17, 0.5); // facets differ a little in true width
}

TEST(CreaseEdges, OnASmoothCadEdgeAreNone)
{
    const Model model = two_faces([](double, double y) { return -y * y / 500; });
    EXPECT_TRUE(find_feature_lines(model).empty());
}

TEST(CreaseEdges, KnowTheirCadEdge)
{
    const auto lines = find_feature_lines(two_faces(roof));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].cad_edges, std::vector<int>{7});
    EXPECT_EQ(lines[0].vertices.size(), 41U);
}

TEST(CreaseEdges, InsideACadFaceAreTessellation)
{
    Model model = two_faces(roof);
    model.cad_edges.clear();
    std::ranges::fill(model.cad_face, 0);
    EXPECT_TRUE(find_feature_lines(model).empty());
    EXPECT_EQ(find_feature_lines(model_of(model.mesh)).size(), 1U) << "the same triangles from a mesh file";
}

TEST(CreaseEdges, FollowTheExactFacesWhereTheyAreKnown)
{
    Model model = two_faces(roof);
    model.surface = std::make_shared<Planes>(Vec3(0, 0.01, 1), Vec3(0, -0.01, 1));
    EXPECT_TRUE(find_feature_lines(model).empty()) << "the faces meet at 1 degree";
    model.surface = std::make_shared<Planes>(Vec3(0, 0.2, 1), Vec3(0, -0.2, 1));
    EXPECT_EQ(find_feature_lines(model).size(), 1U);
}

TEST(CreaseEdges, FillADipOfASharpCadEdge)
{
    // The roof is flat for 150 < x < 200.
    const auto dented = [](double x, double y) {
        return -0.1 * std::abs(y) * std::clamp(std::abs(x - 175) / 10 - 2.5, 0.0, 1.0);
    };
    const auto with = find_feature_lines(two_faces(dented));
    ASSERT_EQ(with.size(), 1U);
    EXPECT_EQ(with[0].vertices.size(), 41U);
    EXPECT_LT(find_feature_lines(model_of(two_faces(dented).mesh))[0].length_mm, 225) << "nothing tells a mesh's dip";
}

TEST(CreaseEdges, DoNotFollowACadEdgeThatRunsOutSmooth)
{
    const auto fading = [](double x, double y) { return -0.1 * std::abs(y) * std::clamp((250 - x) / 10, 0.0, 1.0); };
    const auto lines = find_feature_lines(two_faces(fading));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0].length_mm, 250, 11);
}

TEST(CreaseEdges, OfAShortButWholeCadEdgeMakeALine)
{
    // Sharp only between x = 100 and 120, which is all of the CAD edge.
    const auto short_ridge = [](double x, double y) {
        return -0.2 * std::abs(y) * std::clamp(2 - std::abs(x - 110) / 10, 0.0, 1.0);
    };
    const auto lines = find_feature_lines(two_faces(short_ridge, 10, 12));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].vertices.size(), 3U);
}

TEST(CreaseEdges, AreNoneWhereSmoothFacesFoldBackOntoEachOther)
{
    Model model = two_faces(roof);
    model.surface = std::make_shared<Planes>(Vec3(0, 0.02, 1), Vec3(0, 0.02, -1));
    EXPECT_TRUE(find_feature_lines(model).empty()) << "one tangent plane but for 2.3 degrees";
    model.surface = std::make_shared<Planes>(Vec3(0, 0.2, 1), Vec3(0, 0.2, -1));
    EXPECT_EQ(find_feature_lines(model).size(), 1U) << "a thin edge of 157 degrees";
}

TEST(CreaseEdges, AreJudgedOnTheExactEdgeAndNotOnItsChord)
{
    // Half a millimetre below the edge the faces have bent by 45 degrees each.
    const auto lip = [](int face, const Vec3& p) {
        const double bent = std::clamp(1 - 2 * p.z(), 0.0, 1.0);
        return Vec3(0, face == 0 ? -bent : bent, 1);
    };
    Model model = two_faces(roof);
    model.surface = std::make_shared<NormalRule>(lip, 0.5);
    EXPECT_TRUE(find_feature_lines(model).empty());
    model.surface = std::make_shared<NormalRule>(lip, 0);
    EXPECT_EQ(find_feature_lines(model).size(), 1U) << "the same faces met below";
}

TEST(CreaseEdges, InsideACadFaceNeedAKinkAndNoTightBend)
{
    Model model = two_faces([](double, double y) { return -std::abs(y); });
    std::ranges::fill(model.cad_face, 0);
    const auto turning = [](double width) {
        return [width](int, const Vec3& p) { return Vec3(0, std::clamp(p.y() / width, -1.0, 1.0), 1); };
    };
    model.surface = std::make_shared<NormalRule>(turning(6), 0); // the triangles' centres are 6.7 mm from the row
    EXPECT_TRUE(find_feature_lines(model).empty());
    model.surface = std::make_shared<NormalRule>(turning(1e-6), 0);
    EXPECT_EQ(find_feature_lines(model).size(), 1U);
}
