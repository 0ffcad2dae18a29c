// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_file.h"
#include "tests/support/files.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::vector<std::filesystem::path> nasty_meshes()
{
    std::vector<std::filesystem::path> files;
    if (const auto data = data_folder()) {
        for (const auto& entry : std::filesystem::directory_iterator(*data / "nasty")) {
            if (entry.path().filename().string().starts_with("assimp_")) {
                files.push_back(entry.path());
            }
        }
    }
    std::ranges::sort(files);
    return files;
}

class NastyMesh : public ::testing::TestWithParam<std::filesystem::path> {};

} // namespace

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(NastyMesh);
INSTANTIATE_TEST_SUITE_P(FromElsewhere, NastyMesh, ::testing::ValuesIn(nasty_meshes()), [](const auto& parameter) {
    std::string name = parameter.param.filename().string();
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
});

TEST_P(NastyMesh, ReadsSoundOrIsRefusedInOneSentence)
{
    const auto model = read_mesh(GetParam(), {});
    if (!model) {
        RecordProperty("refused", model.error().message);
        EXPECT_EQ(model.error().kind, ErrorKind::unreadable);
        EXPECT_NE(model.error().message.find(GetParam().filename().string()), std::string::npos);
        EXPECT_EQ(model.error().message.find('\n'), std::string::npos);
        return;
    }
    const Mesh& mesh = model->model.mesh;
    ASSERT_GT(mesh.F.rows(), 0);
    EXPECT_TRUE(mesh.V.allFinite());
    EXPECT_GE(mesh.F.minCoeff(), 0);
    EXPECT_LT(mesh.F.maxCoeff(), mesh.V.rows());
    EXPECT_EQ(model->report.faces, mesh.F.rows());
}

TEST(NastyMeshes, ThatAreDamagedAreRefusedAndOddOnesRead)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto reads = [&](const std::string& name) {
        return read_mesh(*data / "nasty" / ("assimp_" + name), {}).has_value();
    };
    for (const char* name : {"OutOfMemory.off", "box_UTF16BE.obj", "empty.obj", "empty.off", "empty.ply", "invalid.off",
                             "malformed.obj", "malformed2.obj", "number_formats.obj", "point_cloud.obj",
                             "crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply"}) {
        EXPECT_FALSE(reads(name)) << name;
    }
    for (const char* name :
         {"box_longline.obj", "box_without_lineending.obj", "concave_polygon.obj", "regr_3429812.obj",
          "sphereWithHole.stl", "testmixed.obj", "triangle_with_empty_solid.stl", "triangle_with_two_solids.stl"}) {
        EXPECT_TRUE(reads(name)) << name;
    }
}
