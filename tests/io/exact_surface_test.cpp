// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/exact_surface.h"
#include "io/model_file.h"
#include "kernel/parallel.h"
#include "tests/io/cad_shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Eigen/Geometry>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

ImportedModel import(const TopoDS_Shape& shape)
{
    const ScratchFolder folder;
    write_brep(folder / "shape.brep", shape);
    ImportOptions coarse; // exactness must not hang on the tessellation
    coarse.linear_deflection_mm = 0.05;
    coarse.angular_deflection = 10;
    auto read = read_cad(folder / "shape.brep", coarse);
    EXPECT_TRUE(read) << read.error().message;
    return std::move(*read);
}

/// Points in all directions at a distance of 1/2 to 3/2 of `radius` from the origin.
std::vector<Vec3> points_around(double radius, int count)
{
    std::mt19937 sequence(7);
    const auto uniform = [&] { return sequence() / 2147483648.0 - 1; };
    std::vector<Vec3> points;
    while (static_cast<int>(points.size()) < count) {
        const Vec3 p(uniform(), uniform(), uniform());
        if (p.norm() > 0.1) {
            points.push_back(p.normalized() * radius * (1 + 0.5 * uniform()));
        }
    }
    return points;
}

} // namespace

TEST(ExactSurface, ProjectsToASphereRadially)
{
    const ImportedModel sphere = import(BRepPrimAPI_MakeSphere(10).Shape());
    ASSERT_EQ(sphere.model.surface->face_count(), 1);
    for (const Vec3& p : points_around(10, 500)) {
        const auto foot = sphere.model.surface->closest(0, p);
        ASSERT_TRUE(foot);
        EXPECT_LT((foot->point - 10 * p.normalized()).norm(), 1e-9);
        EXPECT_LT((foot->normal - p.normalized()).norm(), 1e-9);
    }
    // The poles, where the parametrisation is degenerate.
    for (const double z : {-12.0, 9.0}) {
        const auto foot = sphere.model.surface->closest(0, Vec3(0, 0, z));
        ASSERT_TRUE(foot);
        EXPECT_LT((foot->point - Vec3(0, 0, z > 0 ? 10 : -10)).norm(), 1e-6);
        EXPECT_GT(foot->normal.z() * z, 0);
    }
}

TEST(ExactSurface, ProjectsToATorusWithBothSeams)
{
    const ImportedModel torus = import(BRepPrimAPI_MakeTorus(20, 5).Shape());
    for (const Vec3& direction : points_around(1, 500)) {
        const Vec3 p(20 * direction.x() / std::hypot(direction.x(), direction.y()) + 3 * direction.x(),
                     20 * direction.y() / std::hypot(direction.x(), direction.y()) + 3 * direction.y(),
                     4 * direction.z());
        const Vec3 ring = Vec3(p.x(), p.y(), 0).normalized() * 20;
        const auto foot = torus.model.surface->closest(0, p);
        ASSERT_TRUE(foot);
        EXPECT_LT((foot->point - (ring + 5 * (p - ring).normalized())).norm(), 1e-8) << p.transpose();
        EXPECT_LT((foot->normal - (p - ring).normalized()).norm(), 1e-8);
    }
}

TEST(ExactSurface, StaysOnTheTrimmedPartOfAFace)
{
    // A square plate with a round hole: points over the hole go to its rim, points beside the plate to its border.
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), 5, 2).Shape();
    const ImportedModel plate = import(BRepAlgoAPI_Cut(rectangle(-20, -20, 20, 20), hole).Shape());
    ASSERT_EQ(plate.model.surface->face_count(), 1);
    const auto closest = [&](const Vec3& p) { return plate.model.surface->closest(0, p).value().point; };
    EXPECT_LT((closest({12, -7, 3}) - Vec3(12, -7, 0)).norm(), 1e-12);
    EXPECT_LT((closest({25, 4, 3}) - Vec3(20, 4, 0)).norm(), 1e-12);
    EXPECT_LT((closest({30, -25, -2}) - Vec3(20, -20, 0)).norm(), 1e-9);
    for (int i = 0; i < 100; ++i) {
        const double angle = 2 * std::numbers::pi * i / 100;
        const Vec3 outward(std::cos(angle), std::sin(angle), 0);
        EXPECT_LT((closest(3 * outward + Vec3(0, 0, 1)) - 5 * outward).norm(), 1e-9);
        EXPECT_LT((closest(4.999 * outward) - 5 * outward).norm(), 1e-3) << "just inside the hole's rim";
        EXPECT_LT((closest(5.001 * outward) - 5.001 * outward).norm(), 1e-12) << "just beyond the rim";
    }
}

TEST(ExactSurface, ProjectsToAPieceOfACylinderAndItsBorder)
{
    const double pi = std::numbers::pi;
    const ImportedModel piece = import(BRepPrimAPI_MakeCylinder(10, 30, pi / 2).Shape());
    // Which of the five faces is the round one? Its points are 10 away from the axis, normals radial.
    int round = -1;
    for (int f = 0; f < piece.model.surface->face_count(); ++f) {
        const Vec3 middle(10 / std::sqrt(2.0), 10 / std::sqrt(2.0), 15);
        const auto foot = piece.model.surface->closest(f, middle);
        round = foot && (foot->point - middle).norm() < 1e-9 ? f : round;
    }
    ASSERT_GE(round, 0);
    for (int i = 0; i <= 20; ++i) {
        const double angle = pi / 2 * i / 20;
        const Vec3 outward(std::cos(angle), std::sin(angle), 0);
        const auto foot = piece.model.surface->closest(round, 12 * outward + Vec3(0, 0, 1.5 * i));
        ASSERT_TRUE(foot);
        EXPECT_LT((foot->point - (10 * outward + Vec3(0, 0, 1.5 * i))).norm(), 1e-9);
        EXPECT_LT((foot->normal - outward).norm(), 1e-9);
    }
    // Beyond the straight border at angle 0, and above the upper rim.
    EXPECT_LT((piece.model.surface->closest(round, Vec3(11, -4, 7))->point - Vec3(10, 0, 7)).norm(), 1e-9);
    EXPECT_LT((piece.model.surface->closest(round, Vec3(8, 8, 44))->point -
               Vec3(10 / std::sqrt(2.0), 10 / std::sqrt(2.0), 30))
                  .norm(),
              1e-9);
}

TEST(ExactSurface, FindsTheClosestPointOfACircularEdge)
{
    const ImportedModel cylinder = import(BRepPrimAPI_MakeCylinder(10, 30).Shape());
    int circles = 0;
    for (int e = 0; e < cylinder.report.cad_edges; ++e) {
        const auto probe = cylinder.model.surface->closest_on_edge(e, Vec3(-3, 4, 40));
        ASSERT_TRUE(probe);
        if ((*probe - Vec3(-6, 8, 30)).norm() > 1e-6) {
            continue; // the seam or the lower circle
        }
        ++circles;
        for (const Vec3& p : points_around(10, 200)) {
            const double flat = std::hypot(p.x(), p.y());
            const Vec3 exact(10 * p.x() / flat, 10 * p.y() / flat, 30);
            EXPECT_LT((*cylinder.model.surface->closest_on_edge(e, p) - exact).norm(), 1e-8);
        }
    }
    EXPECT_EQ(circles, 1);
}

TEST(ExactSurface, NormalsOfAReversedFacePointToTheSideOfItsTriangles)
{
    const TopoDS_Shape turned = rectangle(0, 0, 10, 10).Reversed();
    const ImportedModel plate = import(turned);
    EXPECT_LT(triangle_normal(plate.model.mesh, 0).z(), 0);
    EXPECT_LT(plate.model.surface->closest(0, Vec3(5, 5, 1))->normal.z(), 0);
}

TEST(ExactSurface, AnswersTheSameOnSeveralThreads)
{
    const ImportedModel torus = import(BRepPrimAPI_MakeTorus(20, 5).Shape());
    const auto points = points_around(22, 2000);
    std::vector<Vec3> one(points.size()), many(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        one[i] = torus.model.surface->closest(0, points[i])->point;
    }
    parallel_for(
        static_cast<int>(points.size()), [&](int i) { many[i] = torus.model.surface->closest(0, points[i])->point; },
        16);
    EXPECT_EQ(one, many);
}

TEST(ExactSurface, HasNoAnswerForUnknownNumbersAndPlaces)
{
    const ImportedModel sphere = import(BRepPrimAPI_MakeSphere(10).Shape());
    EXPECT_FALSE(sphere.model.surface->closest(-1, Vec3::Zero()));
    EXPECT_FALSE(sphere.model.surface->closest(1, Vec3::Zero()));
    EXPECT_FALSE(sphere.model.surface->closest(0, Vec3::Constant(std::nan(""))));
    EXPECT_FALSE(sphere.model.surface->closest_on_edge(99, Vec3::Zero()));
}
