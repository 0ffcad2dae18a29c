// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_file.h"
#include "tests/support/files.h"

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

ImportedModel read(std::string_view name, std::string_view content, const ImportOptions& options = {})
{
    const TemporaryFolder folder;
    auto model = read_mesh(folder.write(name, content), options);
    EXPECT_TRUE(model) << (model ? "" : model.error().message);
    return model ? std::move(*model) : ImportedModel{};
}

std::string with_line_ends(const std::string& text, const std::string& line_end)
{
    std::string result;
    for (const char c : text) {
        result += c == '\n' ? line_end : std::string(1, c);
    }
    return result;
}

/// A number's bytes, lowest first or highest first.
template <class T>
std::string bytes(T value, bool big = false)
{
    std::string raw(sizeof(T), '\0');
    std::memcpy(raw.data(), &value, sizeof(T));
    return big ? std::string(raw.rbegin(), raw.rend()) : raw;
}

/// Corner points of triangle t as one row of nine numbers.
std::vector<double> corners_of(const Mesh& mesh, int t)
{
    std::vector<double> result;
    for (int k = 0; k < 3; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            result.push_back(mesh.V(mesh.F(t, k), axis));
        }
    }
    return result;
}

const std::string obj_square = "# two triangles\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\nf 1 2 3\nf 1 3 4\n";
const std::string off_square = "OFF\n# c\n4 2 0\n0 0 0\n1 0 0\n\n1 1 0 # c\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3\n";
const std::string ply_square = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                               "float z\nelement face 2\nproperty list uchar int vertex_index\nend_header\n0 0 0\n"
                               "1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const std::string stl_square = "solid a facet\n facet normal nan nan nan\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 "
                               "0\n   vertex 1 1 0\n  endloop\n endfacet\nendsolid a\nSOLID b\n FACET NORMAL 0 0 1\n  "
                               "OUTER LOOP\n   VERTEX 0 -0 0\n   VERTEX 1 1 0\n   VERTEX 0 1 0\n  ENDLOOP\n "
                               "ENDFACET\nENDSOLID\n";

} // namespace

TEST(MeshFile, ReadsTheSameMeshWithEveryLineEndingFromEveryTextFormat)
{
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
        for (const auto& [name, text] :
             {std::pair{"a.obj", obj_square}, {"a.off", off_square}, {"a.ply", ply_square}, {"a.stl", stl_square}}) {
            for (const bool last_line_end : {true, false}) {
                std::string content = with_line_ends(text, line_end);
                content.resize(content.size() - (last_line_end ? 0 : line_end.size()));
                const ImportedModel model = read(name, content);
                ASSERT_EQ(model.model.mesh.V.rows(), 4) << name;
                ASSERT_EQ(model.model.mesh.F.rows(), 2) << name;
                EXPECT_EQ(model.model.mesh.F, (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished()) << name;
                EXPECT_EQ(model.model.mesh.V.row(2), Vec3(1, 1, 0).transpose()) << name;
                EXPECT_EQ(model.report.border_edges, 4);
                EXPECT_DOUBLE_EQ(model.report.area_mm2, 1);
            }
        }
    }
}

TEST(MeshFile, WeldsStlCornersOfSeveralSolidsAndCountsTheMerges)
{
    const ImportedModel model = read("a.stl", stl_square);
    EXPECT_EQ(model.report.welded_corners, 2); // one of them joins 0 and -0
    EXPECT_EQ(model.report.format, "STL ascii");
}

TEST(MeshFile, ReadsABinaryStlThatStartsWithSolid)
{
    std::string content = "solid by a careless program";
    content.resize(80, ' ');
    content += bytes<std::uint32_t>(2);
    for (const auto& triangle : {std::array<float, 9>{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, -0.f, 0, 1, 1, 0, 0, 1, 0.1f}}) {
        content.append(12, '\0');
        for (const float x : triangle) {
            content += bytes(x);
        }
        content += "ab";
    }
    ImportedModel model = read("a.stl", content);
    EXPECT_EQ(model.report.format, "STL binary");
    EXPECT_EQ(model.report.welded_corners, 2);
    EXPECT_EQ(model.model.mesh.V(3, 2), static_cast<double>(0.1f));
    EXPECT_TRUE(model.report.warnings.empty());

    content[0] = 'x';
    model = read("a.stl", content + "a program's own notes");
    EXPECT_EQ(model.model.mesh.F.rows(), 2);
    EXPECT_EQ(model.report.warnings.size(), 1u);
}

TEST(MeshFile, ReadsEveryFormOfObjCorner)
{
    const ImportedModel model =
        read("a.obj", "\xEF\xBB\xBFmtllib a.mtl\no one\nv 0 0 0 1 0 0\nv +1.0 .0 0.\nv 1e0 1E+0 "
                      "0e5\nvt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf -3//1 \\\n -1//1  \\\r\n 4//1\no "
                      "two\nv 0 1 0\ng x\nv 0 2 0\ns off\nl 1 2\np 1\nf 4/1/1 -3/1/1 -1/1/1\n");
    const Mesh& mesh = model.model.mesh;
    ASSERT_EQ(mesh.V.rows(), 5);
    EXPECT_EQ(mesh.F, (Triangles(3, 3) << 0, 1, 2, 0, 2, 3, 3, 2, 4).finished());
    EXPECT_TRUE(model.report.warnings.empty()) << model.report.warnings.front();
}

TEST(MeshFile, TriangulatesPolygonsAndKeepsEveryVertexWhereItWas)
{
    // An L-shaped hexagon (concave), a quadrilateral, and a vertex that nothing uses.
    const ImportedModel model =
        read("a.off", "OFF 9 2 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n3 0 0\n3 1 0\n9 9 9\n"
                      "6 0 1 2 3 4 5\n4 1 6 7 2\n");
    EXPECT_EQ(model.model.mesh.V.rows(), 9);
    EXPECT_EQ(model.model.mesh.F.rows(), 4 + 2);
    EXPECT_EQ(model.report.triangulated_polygons, 2);
    EXPECT_EQ(model.report.isolated_vertices, 1);
    EXPECT_NEAR(model.report.area_mm2, 4, 1e-14);
    EXPECT_EQ(model.report.border_edges, 8);
}

TEST(MeshFile, ReadsPlyWithAnyOrderAndTypeOfPropertiesInEveryEncoding)
{
    for (const bool big : {false, true}) {
        std::string content = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                              "_endian 1.0\ncomment c\nobj_info o\nelement camera 1\nproperty list ushort double d\n"
                              "property char c\nelement vertex 3\nproperty uchar red\nproperty double z\nproperty list "
                              "uint16 int8 l\nproperty short x\nproperty float32 y\nelement face 1\nproperty float "
                              "quality\nproperty list int uint vertex_indices\nproperty list uchar float "
                              "texcoord\nend_header\n";
        content += bytes<std::uint16_t>(2, big) + bytes(1.0, big) + bytes(2.0, big) + "c";
        for (int v = 0; v < 3; ++v) {
            content += std::string("r") + bytes(0.1 * v, big) + bytes<std::uint16_t>(3, big) + "\n\r\n" +
                       bytes<std::int16_t>(static_cast<std::int16_t>(-v), big) +
                       bytes(0.5f + static_cast<float>(v * v), big);
        }
        content += bytes(1.f, big) + bytes<std::int32_t>(3, big) + bytes<std::uint32_t>(2, big) +
                   bytes<std::uint32_t>(0, big) + bytes<std::uint32_t>(1, big) + std::string("\1", 1) + bytes(0.f, big);
        const ImportedModel model = read("a.ply", content);
        ASSERT_EQ(model.model.mesh.F.rows(), 1);
        EXPECT_EQ(corners_of(model.model.mesh, 0), (std::vector<double>{-2, 4.5, 0.1 * 2, 0, 0.5, 0, -1, 1.5, 0.1}));
    }
}

TEST(MeshFile, ScalesToMillimetres)
{
    const ImportedModel model = read("a.obj", obj_square, {.units_mm = 25.4});
    EXPECT_DOUBLE_EQ(model.model.mesh.V(2, 0), 25.4);
    EXPECT_NEAR(model.report.area_mm2, 25.4 * 25.4, 1e-9);
    EXPECT_EQ(model.report.units, "25.4 mm");
}

TEST(MeshFile, JoinsWhatWasOpenedAlongSharpEdgesForShading)
{
    // A roof whose ridge has its two vertices twice, once per normal.
    const ImportedModel model =
        read("a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 0\nv 1 0 1\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 4 5 6\n");
    EXPECT_EQ(model.model.mesh.V.rows(), 6);
    EXPECT_EQ(model.model.mesh.F, (Triangles(2, 3) << 0, 1, 2, 1, 0, 5).finished());
    EXPECT_EQ(model.report.sewn_edges, 1);
    EXPECT_EQ(model.report.isolated_vertices, 2);
}

TEST(MeshFile, ReadsTheModelsFromElsewhere)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto report = [&](const char* name) { return read_mesh(*data / "models" / name, {}).value().report; };
    const ImportReport quads = report("fandisk_quads_pmp.off");
    EXPECT_EQ(quads.vertices, 766);
    EXPECT_EQ(quads.triangulated_polygons, 764);
    EXPECT_EQ(quads.faces, 2 * 764);
    EXPECT_EQ(quads.border_edges, 0);
    const ImportReport fandisk = report("fandisk_pmp.off");
    EXPECT_EQ(fandisk.vertices, 6475);
    EXPECT_EQ(fandisk.faces, 12946);
    EXPECT_EQ(fandisk.border_edges + fandisk.flipped_faces + fandisk.isolated_vertices, 0);
    for (const char* name : {"rook.stl", "sh1_occt.stl", "featuretype.STL"}) {
        const ImportReport stl = report(name);
        EXPECT_EQ(stl.border_edges, 0) << name;
        EXPECT_GT(stl.welded_corners, 0) << name;
    }
}
