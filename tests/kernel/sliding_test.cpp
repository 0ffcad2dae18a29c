// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/sliding.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

constexpr double pi = std::numbers::pi;

Mesh flat(Diagonals diagonals)
{
    return grid(
        20, 16, -100, 100, -80, 80, [](double, double) { return 0.0; }, diagonals);
}

Topology topology_of(const Mesh& mesh) { return {mesh.F, static_cast<int>(mesh.V.rows())}; }

Vec3 slid(const Mesh& mesh, int v, const Vec3& u)
{
    const MeshPoint end = slide(mesh, topology_of(mesh), v, u);
    EXPECT_GE(end.face, 0);
    EXPECT_GE(end.barycentric.minCoeff(), 0);
    EXPECT_NEAR(end.barycentric.sum(), 1, 1e-12);
    return position_of(mesh, end);
}

int nearest_vertex(const Mesh& mesh, const Vec3& p)
{
    Eigen::Index best;
    (mesh.V.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&best);
    return static_cast<int>(best);
}

} // namespace

TEST(Sliding, OnAPlaneGoesStraight)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const Mesh mesh = flat(diagonals);
        const int v = nearest_vertex(mesh, {3, -5, 0});
        for (int k = 0; k < 48; ++k) {
            const Vec3 u = 61.7 * Vec3(std::cos(k * pi / 24), std::sin(k * pi / 24), 0);
            EXPECT_LT((slid(mesh, v, u) - Vec3(mesh.V.row(v).transpose() + u)).norm(), 1e-10) << k;
        }
    }
}

TEST(Sliding, IgnoresTheNormalPartOfTheDisplacement)
{
    const Mesh mesh = flat(Diagonals::random);
    const int v = nearest_vertex(mesh, {0, 0, 0});
    EXPECT_LT((slid(mesh, v, {20, 10, 500}) - Vec3(mesh.V.row(v).transpose() + Vec3(20, 10, 0))).norm(), 1e-10);
    EXPECT_EQ(slid(mesh, v, {0, 0, 7}), Vec3(mesh.V.row(v)));
}

TEST(Sliding, OnACylinderFollowsTheHelix)
{
    // Unrolled, a prism of n faces is a plane: the path is a straight line in arc length and height, exactly.
    const int n = 90;
    const double R = 100, step = pi / n, chord = 2 * R * std::sin(step / 2);
    Mesh mesh = grid(
        n, 40, 0, n, -150, 150, [](double, double) { return 0.0; }, Diagonals::random);
    Mesh plane = mesh;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        // Vertices stay on the prism's ruled edges, so that its faces are flat.
        const double k = std::round(mesh.V(v, 0)), y = mesh.V(v, 1);
        mesh.V.row(v) << -R * std::cos(k * step), y, R * std::sin(k * step);
        plane.V.row(v) << k * chord, y, 0;
    }
    const int v = nearest_vertex(plane, {10 * chord, -60, 0});
    // Direction as seen in the tangent plane of the vertex, which halves the dihedral angle of the prism.
    const double phi = 10 * step;
    const Vec3 around(std::sin(phi), 0, std::cos(phi));
    const double half = std::cos(step / 2);
    const Vec3 u = 120 * around + Vec3(0, 90, 0);
    const Vec3 normal = vertex_normals(mesh).row(v);
    const MeshPoint end = slide(mesh, topology_of(mesh), v, u);
    const Vec3 unrolled = position_of(plane, end) - Vec3(plane.V.row(v));
    // In each face the path is straight and as long as asked; its slope differs by the tilt of the faces only.
    EXPECT_NEAR(unrolled.norm(), (u - normal * normal.dot(u)).norm(), 1e-9);
    EXPECT_NEAR(unrolled.x(), 120, 120 * 5 * (1 - half));
    const MeshPoint ring = slide(mesh, topology_of(mesh), v, 120 * around);
    EXPECT_NEAR((position_of(plane, ring) - Vec3(plane.V.row(v))).y(), 0, 1e-2);
}

TEST(Sliding, OnAConeFollowsTheStraightLineOfItsDevelopment)
{
    // Polar grid: radius 50..350 along the cone's generators, unrolled angle 0..200 deg in all.
    const int n = 100, rings = 30;
    const double opening = 200 * pi / 180, lean = opening / (2 * pi);
    Mesh cone = grid(n, rings, 0, n, 0, rings, [](double, double) { return 0.0; });
    Mesh plane = cone;
    for (int v = 0; v < cone.V.rows(); ++v) {
        const double angle = cone.V(v, 0) / n * opening, around = cone.V(v, 0) / n * 2 * pi;
        const double radius = 50 + 10 * (rings - cone.V(v, 1));
        cone.V.row(v) << radius * lean * std::cos(around), radius * lean * std::sin(around),
            -radius * std::sqrt(1 - lean * lean);
        plane.V.row(v) << radius * std::cos(angle), radius * std::sin(angle), 0;
    }
    const int v = 15 * (n + 1) + 30;
    const double around = 2 * pi * 30 / n, angle = opening * 30 / n;
    const Vec3 u = 150 * Vec3(-std::sin(around), std::cos(around), 0);
    const Vec3 end = position_of(plane, slide(cone, topology_of(cone), v, u));
    const Vec3 expected = Vec3(plane.V.row(v)) + 150 * Vec3(-std::sin(angle), std::cos(angle), 0);
    EXPECT_LT((end - expected).norm(), 0.2);
}

TEST(Sliding, StopsAtABorder)
{
    const Mesh mesh = flat(Diagonals::random);
    const int v = nearest_vertex(mesh, {0, 0, 0});
    const Vec3 p = mesh.V.row(v);
    const Vec3 end = slid(mesh, v, {300, 30, 0});
    EXPECT_NEAR(end.x(), 100, 1e-9);
    EXPECT_NEAR(end.y(), p.y() + 30 * (100 - p.x()) / 300, 1e-9);
}

TEST(Sliding, FromABorderGoesInwardsStraightAndOutwardsNotAtAll)
{
    const Mesh mesh = flat(Diagonals::alternating);
    for (const int v : {0, 20, 5, 8 * 21}) {
        const Vec3 p = mesh.V.row(v);
        const Vec3 inwards = -p.normalized() * 50 + Vec3(3, 1, 0);
        EXPECT_LT((slid(mesh, v, inwards) - p - inwards).norm(), 1e-10);
        EXPECT_EQ(slid(mesh, v, -inwards), p);
    }
    // Along the border: from a corner to the next one, and no farther.
    EXPECT_LT((slid(mesh, 0, {70, 0, 0}) - Vec3(-30, -80, 0)).norm(), 1e-10);
    EXPECT_LT((slid(mesh, 0, {700, 0, 0}) - Vec3(100, -80, 0)).norm(), 1e-10);
}

TEST(Sliding, MovesAndScalesWithTheMesh)
{
    const Mesh mesh = crease_panel(20, 16, Diagonals::random);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Vec3 shift(1000, -300, 20);
    const Mesh moved{transformed(mesh.V, 2.5, R, shift), mesh.F};
    for (const int v : {30, 100, 170, 200, 300}) {
        const Vec3 u(37, 91, -12);
        const Vec3 expected = 2.5 * (R * slid(mesh, v, u)) + shift;
        EXPECT_LT((slid(moved, v, 2.5 * (R * u)) - expected).norm(), 1e-8);
    }
}

TEST(Sliding, EndsOnDegenerateTrianglesAndNonsenseDisplacements)
{
    Mesh mesh = flat(Diagonals::alternating);
    // Collapse a column of cells: triangles without area, edges without length.
    for (int j = 0; j <= 16; ++j) {
        mesh.V.row(j * 21 + 11) = mesh.V.row(j * 21 + 12);
    }
    const Vec3 end = slid(mesh, nearest_vertex(mesh, {0, 0, 0}), {60, 7, 0});
    EXPECT_TRUE(end.allFinite());
    mesh.V.setZero();
    EXPECT_EQ(slid(mesh, 100, {1, 2, 3}), Vec3(Vec3::Zero()));
    const double huge = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();
    const Mesh panel = crease_panel(10, 10);
    EXPECT_TRUE(slid(panel, 60, {huge, 1, 0}).allFinite());
    EXPECT_EQ(slid(panel, 60, {nan, 1, 0}), Vec3(panel.V.row(60)));
    EXPECT_EQ(slide({mesh.V, Triangles(0, 3)}, Topology(Triangles(0, 3), 1), 0, {1, 0, 0}).face, -1);
}

TEST(Sliding, GoesRoundAClosedSurfaceForAsLongAsItIsAsked)
{
    // Octahedron: from a corner towards the next one, straight over corners, all the way round and back.
    Mesh mesh;
    mesh.V.resize(6, 3);
    mesh.V << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
    mesh.F.resize(8, 3);
    mesh.F << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
    const double edge = std::sqrt(2.0);
    EXPECT_LT((slid(mesh, 0, {0, 4 * edge, 0}) - Vec3(1, 0, 0)).norm(), 1e-9);
    EXPECT_LT((slid(mesh, 0, {0, edge, 0}) - Vec3(0, 1, 0)).norm(), 1e-9);
    EXPECT_TRUE(slid(mesh, 0, {0, 1e300, 0}).allFinite());
}
