// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/io/cad_shapes.h"

#include "kernel/topology.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <cstdlib>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tapeline::testing {

ScratchFolder::ScratchFolder()
{
    static int number = 0;
    path_ = std::filesystem::path(::testing::TempDir()) /
            ("tapeline_" + std::to_string(getpid()) + "_" + std::to_string(++number));
    std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder()
{
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

void write_brep(const std::filesystem::path& path, const TopoDS_Shape& shape)
{
    ASSERT_TRUE(BRepTools::Write(shape, path.c_str()));
}

void write_step(const std::filesystem::path& path, const TopoDS_Shape& shape, const char* unit)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", unit); // read when the writer is made
    STEPControl_Writer writer;
    Interface_Static::SetIVal("write.step.assembly", shape.ShapeType() == TopAbs_COMPOUND ? 1 : 0);
    ASSERT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    Interface_Static::SetCVal("write.step.unit", "MM");
}

void write_iges(const std::filesystem::path& path, const TopoDS_Shape& shape)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    IGESControl_Writer writer("MM", 0);
    ASSERT_TRUE(writer.AddShape(shape));
    writer.ComputeModel();
    ASSERT_TRUE(writer.Write(path.c_str()));
}

TopoDS_Shape compound_of(const std::vector<TopoDS_Shape>& shapes)
{
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) {
        builder.Add(compound, shape);
    }
    return compound;
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& placement)
{
    return shape.Moved(TopLoc_Location(placement), false);
}

TopoDS_Face rectangle(double x0, double y0, double x1, double y1, double z)
{
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), x0, x1, y0, y1).Face();
}

double enclosed_volume(const Mesh& mesh)
{
    double sum = 0;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Vec3 a = mesh.V.row(mesh.F(t, 0)), b = mesh.V.row(mesh.F(t, 1)), c = mesh.V.row(mesh.F(t, 2));
        sum += a.dot(b.cross(c)) / 6;
    }
    return sum;
}

int component_count(const Mesh& mesh)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<char> seen(mesh.F.rows(), 0);
    int count = 0;
    for (int seed = 0; seed < mesh.F.rows(); ++seed) {
        if (seen[seed]) {
            continue;
        }
        ++count;
        std::vector<int> queue{seed};
        seen[seed] = 1;
        while (!queue.empty()) {
            const int t = queue.back();
            queue.pop_back();
            for (const int e : topology.face_edges(t)) {
                const int other = topology.face_across(t, e);
                if (other >= 0 && !seen[other]) {
                    seen[other] = 1;
                    queue.push_back(other);
                }
            }
        }
    }
    return count;
}

std::filesystem::path data_file(const std::string& name)
{
    const char* folder = std::getenv("TAPELINE_DATA");
    return folder == nullptr || *folder == 0 ? std::filesystem::path() : std::filesystem::path(folder) / name;
}

} // namespace tapeline::testing
