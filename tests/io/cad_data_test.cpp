// SPDX-License-Identifier: GPL-3.0-or-later
// CAD files that users bring: what must come out of them, and what must be refused.
#include "io/file_content.h"
#include "io/model_file.h"
#include "kernel/feature_lines.h"
#include "tests/io/cad_shapes.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopoDS_Edge.hxx>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// Coarse, so that many files are read quickly.
Result<ImportedModel> read_coarse(const std::filesystem::path& path)
{
    ImportOptions options;
    options.angular_deflection = 15;
    return read_cad(path, options);
}

class ClosedPart : public ::testing::TestWithParam<const char*> {};

class CadModel : public ::testing::TestWithParam<const char*> {};

class Unreadable : public ::testing::TestWithParam<const char*> {};

/// One sentence that names the file, as a failure to read or a rejection.
void expect_refused(const std::filesystem::path& path)
{
    const auto read = read_cad(path, {});
    ASSERT_FALSE(read) << path;
    const Error& error = read.error();
    EXPECT_TRUE(error.kind == ErrorKind::unreadable || error.kind == ErrorKind::rejected) << error.message;
    EXPECT_NE(error.message.find(path.filename().string()), std::string::npos) << error.message;
    EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;
}

void write_text(const std::filesystem::path& path, std::string_view text)
{
    std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace

TEST_P(ClosedPart, HasNoBorderAndItsExactArea)
{
    const auto path = data_file(std::string("models/") + GetParam());
    if (path.empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto read = read_coarse(path);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->report.border_edges, 0);
    EXPECT_EQ(read->report.non_manifold_edges, 0);
    EXPECT_EQ(read->report.faces_without_triangles, 0);
    EXPECT_EQ(read->report.folded_triangles_left, 0);
    EXPECT_NEAR(read->report.area_mm2, read->report.exact_area_mm2, 0.01 * read->report.exact_area_mm2);
    EXPECT_GT(enclosed_volume(read->model.mesh), 0);
}

INSTANTIATE_TEST_SUITE_P(CadData, ClosedPart,
                         ::testing::Values("screw.step", "linkrods.step", "hammer.brep", "hammer.iges",
                                           "dm1-id-214.stp", "as1-oc-214.stp", "featuretype.STEP"));

TEST_P(CadModel, HasNoTriangleFoldedOverAgainstItsExactSurface)
{
    const auto path = data_file(std::string("models/") + GetParam());
    if (path.empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto read = read_cad(path, {});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->report.folded_triangles_left, 0);
    EXPECT_EQ(read->report.isolated_vertices, 0);
    EXPECT_NEAR(read->report.area_mm2, read->report.exact_area_mm2, 1e-3 * read->report.exact_area_mm2);
}

INSTANTIATE_TEST_SUITE_P(CadData, CadModel, ::testing::Values("aircraft_engine.step", "D150_wing.igs"));

TEST(CadData, FindsNoLineOnTheNacelleWhichHasSmoothSeamsOnly)
{
    if (data_file("").empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto read = read_cad(data_file("models/nacelle.stp"), {});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->report.folded_triangles_left, 0);
    EXPECT_GT(read->report.folded_triangles, 100) << "the tessellation's folds at the lip";
    EXPECT_TRUE(find_feature_lines(read->model).empty());
}

TEST(CadData, SewsTheHammerWithoutSharedEdgesToTheOneThatWasSewnAlready)
{
    if (data_file("").empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto loose = read_coarse(data_file("models/hammer.iges")),
               sewn = read_coarse(data_file("models/hammer.brep"));
    ASSERT_TRUE(loose && sewn);
    EXPECT_EQ(sewn->report.sewn_edges, 0);
    EXPECT_GT(loose->report.sewn_edges, 100);
    EXPECT_EQ(loose->report.cad_faces, sewn->report.cad_faces);
    EXPECT_EQ(loose->report.cad_edges, sewn->report.cad_edges);
    EXPECT_NEAR(loose->report.area_mm2, sewn->report.area_mm2, 1e-3 * sewn->report.area_mm2);
    EXPECT_NEAR(enclosed_volume(loose->model.mesh), enclosed_volume(sewn->model.mesh),
                1e-3 * enclosed_volume(sewn->model.mesh));
}

TEST(CadData, KeepsTheEighteenPartsOfTheAssemblyApart)
{
    if (data_file("").empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto read = read_coarse(data_file("models/as1-oc-214.stp"));
    ASSERT_TRUE(read) << read.error().message;
    // One plate, two angle brackets, six bolts, eight nuts and a rod.
    EXPECT_EQ(component_count(read->model.mesh), 18);
}

TEST(CadData, ReadsTheSamePartInInchesFromStepAndFromStl)
{
    if (data_file("").empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto cad = read_coarse(data_file("models/featuretype.STEP"));
    ImportOptions inches;
    inches.units_mm = 25.4;
    const auto stl = read_model(data_file("models/featuretype.STL"), inches);
    ASSERT_TRUE(cad && stl);
    EXPECT_NEAR(bounding_diagonal(cad->model.mesh.V), bounding_diagonal(stl->model.mesh.V), 0.05);
    EXPECT_NEAR(enclosed_volume(cad->model.mesh), enclosed_volume(stl->model.mesh),
                0.005 * enclosed_volume(stl->model.mesh));
}

TEST_P(Unreadable, IsRefusedInOneSentence)
{
    const auto path = data_file(std::string("nasty/stepcode_") + GetParam());
    if (path.empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    expect_refused(path);
}

INSTANTIATE_TEST_SUITE_P(CadData, Unreadable,
                         ::testing::Values("FOOT_no_geometry.stp", "comments.p21", "missing_and_required.p21",
                                           "s1-c5-214_external_refs.stp", "select_segfault_2.stp",
                                           "select_segfault_210e3.stp", "test_array_bounds_FAIL1.p21"));

TEST(CadData, NamesTheFilesThatAnAssemblyWithoutGeometryRefersTo)
{
    if (data_file("").empty()) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto read = read_cad(data_file("nasty/stepcode_s1-c5-214_external_refs.stp"), {});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::rejected);
    EXPECT_NE(read.error().message.find("MAINBODY.stp"), std::string::npos) << read.error().message;
}

TEST(CadData, RefusesAFileThatIsCutShortAnywhere)
{
    const ScratchFolder folder;
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10).Shape();
    write_step(folder / "whole.step", sphere);
    write_iges(folder / "whole.igs", sphere);
    write_brep(folder / "whole.brep", sphere);
    for (const char* ending : {".step", ".igs", ".brep"}) {
        const auto whole = read_file_content(folder / (std::string("whole") + ending));
        ASSERT_TRUE(whole);
        for (const double share : {0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97}) {
            const std::string name = std::string("short") + ending;
            write_text(folder / name, whole->view().substr(0, static_cast<size_t>(whole->view().size() * share)));
            expect_refused(folder / name);
        }
    }
}

TEST(CadData, RefusesCountsLargerThanTheFile)
{
    const ScratchFolder folder;
    write_brep(folder / "whole.brep", BRepPrimAPI_MakeSphere(10).Shape());
    const auto whole = read_file_content(folder / "whole.brep");
    ASSERT_TRUE(whole);
    for (const char* table : {"\nCurves ", "\nSurfaces ", "\nTShapes "}) {
        std::string text(whole->view());
        text.insert(text.find(table) + std::string_view(table).size(), "99999999");
        write_text(folder / "counts.brep", text);
        expect_refused(folder / "counts.brep");
    }
}

TEST(CadData, RefusesAFileOnWhichTheReaderBreaksDown)
{
    // A vertex whose point is an entity of an unknown kind: OpenCASCADE follows a null pointer there.
    const ScratchFolder folder;
    write_step(folder / "whole.step", BRepPrimAPI_MakeBox(10, 20, 30).Shape());
    const auto whole = read_file_content(folder / "whole.step");
    ASSERT_TRUE(whole);
    std::string text(whole->view());
    const size_t vertex = text.find("VERTEX_POINT('',#");
    ASSERT_NE(vertex, std::string::npos);
    const size_t number = text.find('#', vertex);
    const std::string point = "\n" + text.substr(number, text.find(')', number) - number) + " = CARTESIAN_POINT";
    text.replace(text.find(point) + point.size() - 15, 15, "CARTESIAN_PAINT");
    write_text(folder / "damaged.step", text);
    expect_refused(folder / "damaged.step");
}

TEST(CadData, SurvivesFilesWithAnyByteChanged)
{
    const ScratchFolder folder;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    write_step(folder / "whole.step", box);
    write_brep(folder / "whole.brep", box);
    std::mt19937 sequence(3);
    for (const char* ending : {".step", ".brep"}) {
        const auto whole = read_file_content(folder / (std::string("whole") + ending));
        ASSERT_TRUE(whole);
        const std::string name = std::string("changed") + ending;
        for (int i = 0; i < 40; ++i) {
            std::string text(whole->view());
            for (int k = 0; k < 3; ++k) {
                text[sequence() % text.size()] = "0123456789#$*(),'-+.E"[sequence() % 21];
            }
            write_text(folder / name, text);
            const auto read = read_cad(folder / name, {});
            if (read) {
                EXPECT_TRUE(read->model.mesh.V.allFinite());
            } else {
                EXPECT_NE(read.error().message.find(name), std::string::npos) << read.error().message;
            }
        }
    }
}

TEST(CadData, RefusesAFileWithCurvesOnly)
{
    const ScratchFolder folder;
    write_brep(folder / "curve.brep", BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 2, 3)).Shape());
    expect_refused(folder / "curve.brep");
    EXPECT_NE(read_cad(folder / "curve.brep", {}).error().message.find("curves"), std::string::npos);
}
