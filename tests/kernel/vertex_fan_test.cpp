// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/vertex_fan.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double pi = std::numbers::pi;

Topology topology_of(const Mesh& mesh) { return {mesh.F, static_cast<int>(mesh.V.rows())}; }

Mesh flat(Diagonals diagonals)
{
    return grid(
        8, 8, -4, 4, -4, 4, [](double, double) { return 0.0; }, diagonals);
}

Vec3 spoke(const Mesh& mesh, int v, int face)
{
    return mesh.V.row(mesh.F(face, (corner_of(mesh, face, v) + 1) % 3)) - mesh.V.row(v);
}

} // namespace

TEST(VertexFan, InsideAFlatMeshClosesAfterAFullTurn)
{
    const Mesh mesh = flat(Diagonals::random);
    const Topology topology = topology_of(mesh);
    for (int v = 0; v < topology.vertex_count(); ++v) {
        const auto fans = fans_at(mesh, topology, v);
        ASSERT_EQ(fans.size(), 1U);
        EXPECT_EQ(fans[0].closed, !topology.border_vertex(v));
        EXPECT_EQ(fans[0].faces.size(), topology.vertex_faces(v).size());
        if (fans[0].closed) {
            EXPECT_NEAR(fans[0].total(), 2 * pi, 1e-12);
        }
    }
}

TEST(VertexFan, FindsTheDirectionOfAnEdgeAtThatEdgesAngle)
{
    // On a cone too, where the angles around the tip do not fill the full turn.
    for (const double slope : {0.0, 0.8}) {
        const Mesh mesh =
            grid(2, 2, -1, 1, -1, 1, [&](double x, double y) { return slope * std::max(std::abs(x), std::abs(y)); });
        const Topology topology = topology_of(mesh);
        const VertexFan fan = fans_at(mesh, topology, 4).front();
        for (size_t k = 0; k < fan.faces.size(); ++k) {
            const auto angle = polar_angle(mesh, 4, fan, spoke(mesh, 4, fan.faces[k]));
            ASSERT_TRUE(angle);
            EXPECT_NEAR(std::remainder(*angle - fan.start[k], fan.total()), 0, slope > 0 ? 0.05 : 1e-9);
        }
    }
}

TEST(VertexFan, RefusesADirectionThatLeavesTheBorder)
{
    const Mesh mesh = flat(Diagonals::alternating);
    const Topology topology = topology_of(mesh);
    const int corner = 0; // at (-4, -4): the mesh lies between +x and +y
    const VertexFan fan = fans_at(mesh, topology, corner).front();
    EXPECT_FALSE(fan.closed);
    EXPECT_NEAR(fan.total(), pi / 2, 1e-12);
    for (int k = 0; k < 16; ++k) {
        const double a = k * pi / 8;
        const auto angle = polar_angle(mesh, corner, fan, {std::cos(a), std::sin(a), 0});
        EXPECT_EQ(angle.has_value(), k <= 4) << k;
        EXPECT_NEAR(angle.value_or(a), a, 1e-9);
    }
}

TEST(VertexFan, OfEachOfTwoSheetsThatTouchAtAVertex)
{
    Mesh mesh;
    mesh.V.resize(5, 3);
    mesh.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0;
    mesh.F.resize(2, 3);
    mesh.F << 0, 1, 2, 0, 3, 4;
    const auto fans = fans_at(mesh, topology_of(mesh), 0);
    ASSERT_EQ(fans.size(), 2U);
    const Vec3 into_second(-1, -1, 0);
    EXPECT_FALSE(polar_angle(mesh, 0, fans[0], into_second));
    const auto angle = polar_angle(mesh, 0, fans[1], into_second);
    ASSERT_TRUE(angle);
    EXPECT_NEAR(*angle, pi / 4, 1e-12);
}
