// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_file.h"
#include "kernel/curve.h"
#include "kernel/topology.h"
#include "tests/io/cad_shapes.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(10, 20, 30).Shape(); }

gp_Trsf moved_by(double x, double y, double z)
{
    gp_Trsf placement;
    placement.SetTranslation(gp_Vec(x, y, z));
    return placement;
}

gp_Trsf mirrored()
{
    gp_Trsf placement;
    placement.SetMirror(gp_Ax2(gp_Pnt(-3, 0, 0), gp_Dir(1, 0.3, 0.1)));
    return placement;
}

Vec3 size_of(const Mesh& mesh) { return mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff(); }

} // namespace

TEST(CadFile, ReadsABoxAsTwelveTrianglesWithItsTwelveEdgesAndSixFaces)
{
    const ScratchFolder folder;
    write_step(folder / "box.step", box());
    const auto read = read_cad(folder / "box.step", {});
    ASSERT_TRUE(read) << read.error().message;
    const auto& [model, report] = *read;
    EXPECT_EQ(report.format, "STEP");
    EXPECT_EQ(report.units, "mm");
    EXPECT_EQ(model.mesh.V.rows(), 8);
    EXPECT_EQ(model.mesh.F.rows(), 12);
    EXPECT_EQ(report.cad_faces, 6);
    EXPECT_EQ(report.cad_edges, 12);
    EXPECT_EQ(report.border_edges, 0);
    EXPECT_TRUE(report.warnings.empty());
    EXPECT_NEAR(enclosed_volume(model.mesh), 6000, 1e-9);
    EXPECT_NEAR(report.area_mm2, 2200, 1e-9);
    EXPECT_NEAR(report.exact_area_mm2, 2200, 1e-6);
    // Every CAD edge is one mesh edge, and the two triangles along it lie on different CAD faces.
    ASSERT_EQ(model.cad_edges.size(), 12U);
    const Topology topology(model.mesh.F, 8);
    std::vector<int> seen(12, 0);
    for (const CadEdgeTag& tag : model.cad_edges) {
        ++seen[tag.cad_edge];
        const MeshEdge& edge = topology.edge(topology.find_edge(tag.a, tag.b));
        EXPECT_NE(model.cad_face[edge.left], model.cad_face[edge.right]);
    }
    EXPECT_EQ(seen, std::vector<int>(12, 1));
}

TEST(CadFile, ConvertsInchesAndMetresToMillimetres)
{
    const ScratchFolder folder;
    for (const auto& [unit, name] : {std::pair{"INCH", "inch"}, {"M", "m"}}) {
        write_step(folder / "box.step", box(), unit);
        const auto read = read_cad(folder / "box.step", {});
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->report.units, name);
        EXPECT_LT((size_of(read->model.mesh) - Vec3(10, 20, 30)).norm(), 1e-6) << unit;
    }
}

TEST(CadFile, PlacesThePartsOfAnAssemblyAndKeepsTouchingPartsApart)
{
    const ScratchFolder folder;
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::numbers::pi / 2);
    // The second box stands face to face with the first one.
    const TopoDS_Shape one = box();
    write_step(folder / "assembly.step",
               compound_of({one, placed(one, moved_by(10, 0, 0)), placed(one, moved_by(0, 100, 0) * turned)}));
    const auto read = read_cad(folder / "assembly.step", {});
    ASSERT_TRUE(read) << read.error().message;
    const auto& [model, report] = *read;
    EXPECT_EQ(report.cad_faces, 18);
    EXPECT_EQ(report.cad_edges, 36);
    EXPECT_EQ(report.sewn_edges, 0);
    EXPECT_EQ(report.border_edges, 0);
    EXPECT_EQ(component_count(model.mesh), 3);
    EXPECT_NEAR(enclosed_volume(model.mesh), 18000, 1e-6);
    EXPECT_LT((size_of(model.mesh) - Vec3(40, 110, 30)).norm(), 1e-9);
}

TEST(CadFile, KeepsTheOutsideOfAMirroredPartOutside)
{
    const ScratchFolder folder;
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 4, 20).Shape();
    write_brep(folder / "mirrored.brep", compound_of({placed(cone, mirrored()), placed(cone, moved_by(50, 0, 0))}));
    const auto read = read_cad(folder / "mirrored.brep", {});
    ASSERT_TRUE(read) << read.error().message;
    const auto& [model, report] = *read;
    EXPECT_EQ(report.flipped_faces, 0) << "the placement itself must tell, not a repair afterwards";
    EXPECT_EQ(report.border_edges, 0);
    const double volume = std::numbers::pi * 20 / 3 * (100 + 40 + 16);
    EXPECT_NEAR(enclosed_volume(model.mesh), 2 * volume, 0.01 * volume);
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        const Vec3 middle = (model.mesh.V.row(model.mesh.F(t, 0)) + model.mesh.V.row(model.mesh.F(t, 1)) +
                             model.mesh.V.row(model.mesh.F(t, 2))) /
                            3;
        const auto foot = model.surface->closest(model.cad_face[t], middle);
        ASSERT_TRUE(foot);
        EXPECT_GT(foot->normal.dot(triangle_normal(model.mesh, t)), 0.9);
    }
}

TEST(CadFile, SewsFacesThatShareNoEdge)
{
    const ScratchFolder folder;
    write_brep(folder / "loose.brep",
               compound_of({rectangle(0, 0, 10, 10), rectangle(10, 0, 20, 10), rectangle(0, 10, 10, 20)}));
    const auto read = read_cad(folder / "loose.brep", {});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->report.sewn_edges, 2);
    EXPECT_EQ(read->report.cad_edges, 10);
    EXPECT_EQ(component_count(read->model.mesh), 1);
    EXPECT_EQ(read->model.mesh.V.rows(), 8);
}

TEST(CadFile, SewsAGapOnlyWhereTheToleranceCoversIt)
{
    const ScratchFolder folder;
    write_brep(folder / "gap.brep", compound_of({rectangle(0, 0, 10, 10), rectangle(10.02, 0, 20, 10)}));
    ImportOptions options;
    const auto apart = read_cad(folder / "gap.brep", options);
    options.sew_tolerance_mm = 0.05;
    const auto joined = read_cad(folder / "gap.brep", options);
    ASSERT_TRUE(apart && joined);
    EXPECT_EQ(component_count(apart->model.mesh), 2);
    EXPECT_EQ(apart->report.sewn_edges, 0);
    EXPECT_EQ(component_count(joined->model.mesh), 1);
    EXPECT_EQ(joined->report.sewn_edges, 1);
}

TEST(CadFile, ClosesSeamsAndPoles)
{
    const ScratchFolder folder;
    const double pi = std::numbers::pi;
    const std::pair<TopoDS_Shape, double> solids[] = {{BRepPrimAPI_MakeSphere(10).Shape(), 4 * pi / 3 * 1000},
                                                      {BRepPrimAPI_MakeTorus(20, 5).Shape(), 2 * pi * pi * 20 * 25},
                                                      {BRepPrimAPI_MakeCone(10, 0, 20).Shape(), pi * 100 * 20 / 3}};
    ImportOptions coarse;
    coarse.linear_deflection_mm = 0.02;
    for (const auto& [solid, volume] : solids) {
        write_step(folder / "solid.step", solid);
        const auto read = read_cad(folder / "solid.step", coarse);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->report.border_edges, 0);
        EXPECT_EQ(component_count(read->model.mesh), 1);
        EXPECT_NEAR(enclosed_volume(read->model.mesh), volume, 0.01 * volume);
        EXPECT_NEAR(read->report.area_mm2, read->report.exact_area_mm2, 0.01 * read->report.exact_area_mm2);
        for (int t = 0; t < read->model.mesh.F.rows(); ++t) {
            ASSERT_GT(triangle_min_angle(read->model.mesh, t), 0) << "triangle without area";
        }
    }
}

TEST(CadFile, OrientsLooseFacesOfAClosedBodyOutward)
{
    const ScratchFolder folder;
    write_iges(folder / "box.iges", box());
    const auto read = read_cad(folder / "box.iges", {});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->report.format, "IGES");
    EXPECT_EQ(read->report.border_edges, 0);
    EXPECT_EQ(read->report.sewn_edges, 12);
    EXPECT_NEAR(enclosed_volume(read->model.mesh), 6000, 1e-6);
}

TEST(CadFile, GivesTheSameBytesTwice)
{
    const ScratchFolder folder;
    write_step(folder / "torus.step", BRepPrimAPI_MakeTorus(20, 5).Shape());
    ImportOptions coarse;
    coarse.linear_deflection_mm = 0.02;
    const auto first = read_cad(folder / "torus.step", coarse), second = read_cad(folder / "torus.step", coarse);
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(first->model.mesh.V == second->model.mesh.V);
    EXPECT_TRUE(first->model.mesh.F == second->model.mesh.F);
    EXPECT_EQ(first->model.cad_edges, second->model.cad_edges);
    EXPECT_EQ(first->model.cad_face, second->model.cad_face);
}

TEST(CadFile, MakesFinerTrianglesForSmallerDeflections)
{
    const ScratchFolder folder;
    write_brep(folder / "sphere.brep", BRepPrimAPI_MakeSphere(10).Shape());
    ImportOptions options;
    options.angular_deflection = 30;
    options.linear_deflection_mm = 0.2;
    const auto coarse = read_cad(folder / "sphere.brep", options);
    options.linear_deflection_mm = 0.02;
    const auto fine = read_cad(folder / "sphere.brep", options);
    ASSERT_TRUE(coarse && fine);
    EXPECT_GT(fine->report.faces, 4 * coarse->report.faces);
    for (const auto& [read, deflection] : {std::pair{&coarse, 0.2}, {&fine, 0.02}}) {
        const Mesh& mesh = (*read)->model.mesh;
        for (int t = 0; t < mesh.F.rows(); ++t) {
            const Vec3 middle = (mesh.V.row(mesh.F(t, 0)) + mesh.V.row(mesh.F(t, 1)) + mesh.V.row(mesh.F(t, 2))) / 3;
            ASSERT_GT(middle.norm(), 10 - 2 * deflection);
        }
    }
}

TEST(CadFile, RefusesDeflectionsThatMakeNoMesh)
{
    const ScratchFolder folder;
    write_brep(folder / "box.brep", box());
    for (const double linear : {-1.0, 1e-12, std::numeric_limits<double>::quiet_NaN()}) {
        ImportOptions options;
        options.linear_deflection_mm = linear;
        const auto read = read_cad(folder / "box.brep", options);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().kind, ErrorKind::usage);
    }
    ImportOptions options;
    options.angular_deflection = 0;
    EXPECT_FALSE(read_cad(folder / "box.brep", options));
    options = {};
    options.sew_tolerance_mm = -1;
    EXPECT_FALSE(read_cad(folder / "box.brep", options));
}
