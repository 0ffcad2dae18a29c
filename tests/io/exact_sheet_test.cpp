// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from the faces of our own CAD models, near and far, against OpenCASCADE's own distance between shapes.
#include "io/model_file.h"
#include "kernel/exact_sheet.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

using namespace tapeline;

namespace {

/// The faces without the solid that they bound: inside it OpenCASCADE's distance is 0.
TopoDS_Shape faces_of(const std::string& path)
{
    STEPControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    TopoDS_Compound compound;
    const BRep_Builder builder;
    builder.MakeCompound(compound);
    for (TopExp_Explorer faces(reader.OneShape(), TopAbs_FACE); faces.More(); faces.Next()) {
        builder.Add(compound, faces.Current());
    }
    return compound;
}

double distance_by_opencascade(const TopoDS_Shape& shape, const Vec3& p)
{
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z()));
    return BRepExtrema_DistShapeShape(vertex, shape).Value();
}

struct Sample {
    const char* model;
    double far; ///< about what a method that buckles makes of it [mm]
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) { return out << sample.model; }

class ExactSheetOfOurModels : public ::testing::TestWithParam<Sample> {};

} // namespace

TEST_P(ExactSheetOfOurModels, AgreesWithOpenCascadeFromNearAndFar)
{
    const auto [name, far] = GetParam();
    const std::string path = std::string(TAPELINE_SOURCE_DIR "/resources/models/") + name;
    const auto read = read_model(path, {});
    ASSERT_TRUE(read) << read.error().message;
    const TopoDS_Shape shape = faces_of(path);
    const Mesh& mesh = read->model.mesh;
    std::vector<int> all(mesh.F.rows());
    std::iota(all.begin(), all.end(), 0);
    const ExactSheet sheet(read->model, all);

    std::mt19937 sequence(3);
    int exact = 0, count = 0;
    double farthest_apart = 0;
    for (const double share : {0.0, 1e-4, 0.02, 1.0}) {
        for (int k = 0; k < 10; ++k, ++count) {
            const int t = static_cast<int>(sequence() % static_cast<unsigned>(mesh.F.rows()));
            Vec3 middle = Vec3::Zero();
            for (const int v : mesh.F.row(t)) {
                middle += Vec3(mesh.V.row(v)) / 3;
            }
            const double sense = k % 2 == 0 ? 1 : -1;
            const Vec3 p = middle + sense * share * far * triangle_normal(mesh, t);
            const SheetFoot foot = sheet.foot(p);
            const double known = distance_by_opencascade(shape, p);
            if (foot.exact) {
                ++exact;
                farthest_apart = std::max(farthest_apart, std::abs((p - foot.exact->point).norm() - known));
            } else {
                EXPECT_NEAR(foot.triangle.distance, known, 0.2);
            }
        }
    }
    EXPECT_GE(exact, count * 9 / 10);
    EXPECT_LT(farthest_apart, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Models, ExactSheetOfOurModels,
                         ::testing::Values(Sample{"hood.step", 70}, Sample{"wheel_arch.step", 40},
                                           Sample{"pawn.step", 5}, Sample{"bracket.step", 20},
                                           Sample{"filleted_panel.step", 30}));
