// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_readers.h"
#include "tests/support/files.h"
#include "tests/support/shapes.h"

#include <array>
#include <gtest/gtest.h>
#include <random>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

const std::string ply_vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string ply_start = "ply\nformat ascii 1.0\n" + ply_vertex + ply_face + "end_header\n";
const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
const std::string obj_three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct Damaged {
    std::string name, content, place, words;
};

/// One sentence: no line breaks, no full stop inside that would start another, the file's name and the place in it.
void expect_one_sentence(const Error& error, const std::string& name)
{
    EXPECT_EQ(error.kind, ErrorKind::unreadable) << error.message;
    EXPECT_NE(error.message.find(name), std::string::npos) << error.message;
    EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;
    EXPECT_EQ(error.message.find(". "), std::string::npos) << error.message;
}

} // namespace

TEST(DamagedMeshFile, IsRefusedInOneSentenceWithThePlaceAndTheReason)
{
    std::string stl_count(84 + 50, '\0');
    stl_count[83] = '\x7f';
    std::string stl_nan(84 + 50, '\0');
    stl_nan[80] = 1;
    stl_nan[84 + 12 + 3] = '\x7f';
    stl_nan[84 + 12 + 2] = '\xc0';
    const std::array cases{
        Damaged{"a.obj", "", "", "empty"},
        Damaged{"a.stl", "\n \r\n", "", "empty"},
        Damaged{"a.obj", std::string("\xFE\xFF\0v\0 \0\x31", 8), "", "UTF-16"},
        Damaged{"a.txt", "Dear reader,", "", "none of STEP"},
        Damaged{"a.obj", obj_three, "", "no triangles"},
        Damaged{"a.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n", "line 3", "x of vertex 2"},
        Damaged{"a.obj", "v 0 0 0\nv 1 -inf 0\n", "line 2", "y of vertex 1"},
        Damaged{"a.obj", "v 0 0 1D5\n", "line 1", "\"1D5\""},
        Damaged{"a.obj", "v 0,5 0 1\n", "line 1", "\"0,5\""},
        Damaged{"a.obj", "v 0 0 1e999\n", "line 1", "beyond what a double can hold"},
        Damaged{"a.obj", "v 0 0 +-1\n", "line 1", "not a number"},
        Damaged{"a.obj", "v 0 0\n", "line 1", "z of vertex 0 (counted from 0) is missing"},
        Damaged{"a.obj", obj_three + "f 1 2 3\nf 1 2 4\n", "line 5", "names vertex 4, but the file has 3"},
        Damaged{"a.obj", obj_three + "f 1 2 -4\n", "line 4", "\"-4\" names no vertex"},
        Damaged{"a.obj", obj_three + "f 0 1 2\n", "line 4", "\"0\" names no vertex"},
        Damaged{"a.obj", obj_three + "f 1 2 99999999999999999999\n", "line 4", "not of the form"},
        Damaged{"a.obj", obj_three + "f 1 2 3x\n", "line 4", "not of the form"},
        Damaged{"a.obj", obj_three + "f\n", "line 4", "no corners"},
        Damaged{"a.obj", obj_three + "f 1 1 2\n", "", "degenerate"},
        Damaged{"a.obj", "v 1e300 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "", "vertex 0"},
        Damaged{"a.off", "OFF\n", "line 1", "cut off"},
        Damaged{"a.off", "OFF\n-1 2 0\n", "line 2", "announces -1 vertices"},
        Damaged{"a.off", "OFF\n353535235358 6 0\n" + three, "line 2", "announces 353535235358 vertices"},
        Damaged{"a.off", "OFF\n3 99 0\n" + three, "line 2", "announces 99 faces"},
        Damaged{"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n", "line 5", "y of vertex 2"},
        Damaged{"a.off", "OFF\n3 1 0\n" + three + "3 0 1 3\n", "line 6", "names vertex 3"},
        Damaged{"a.off", "OFF\n3 1 0\n" + three + "4 0 1 2\n", "line 6", "4 corners"},
        Damaged{"a.off", "OFF\n3 2 0\n" + three + "3 0 1 2\n", "line 6", "after 1 of 2 faces"},
        Damaged{"a.off", "OFF BINARY\n\1\2\3", "", "binary OFF"},
        Damaged{"a.off", "4OFF\n3 1 0\n" + three + "3 0 1 2\n", "line 1", "three coordinates"},
        Damaged{"a.ply", "ply\nformat ascii 1.0\n" + ply_vertex, "line 6", "end_header"},
        Damaged{"a.ply", "ply\nformat fancy 1.0\n", "line 2", "\"fancy\""},
        Damaged{"a.ply", "ply\n" + ply_vertex + "end_header\n" + three, "line 6", "no \"format\""},
        Damaged{"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\n", "line 4", "\"half\""},
        Damaged{"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n" + three, "", "without properties"},
        Damaged{"a.ply", "ply\nformat ascii 1.0\n" + ply_vertex + "property int x\n", "line 7", "twice"},
        Damaged{"a.ply", ply_start + "0 0 0\n1 0 0\n0 1\n3 0 1 2\n", "line 12", "missing"},
        Damaged{"a.ply", ply_start + "0 0 0\n1 0 0\n0 1 0 7\n3 0 1 2\n", "line 12", "more values"},
        Damaged{"a.ply", ply_start + three + "3 0 1 3\n", "line 13", "names vertex 3"},
        Damaged{"a.ply", ply_start + three + "-3 0 1 2\n", "line 13", "announces -3 items"},
        Damaged{"a.ply", ply_start + three, "line 12", "face"},
        Damaged{"a.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n",
                "byte", "4000000000 rows"},
        Damaged{"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "line 4", "cut off"},
        Damaged{"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 inf 0\n",
                "line 6", "y of vertex 2"},
        Damaged{"a.stl", "solid a\n", "line 1", "endsolid"},
        Damaged{"a.stl", "solid a\nendsolid\n", "", "no triangles"},
        Damaged{"a.stl", stl_count, "byte 80", "announces 2130706432 triangles"},
        Damaged{"a.stl", stl_count.substr(0, 50), "byte 50", "at least 84 bytes"},
        Damaged{"a.stl", stl_nan, "byte 96", "triangle 0"},
    };
    for (const Damaged& damaged : cases) {
        const auto model = read_mesh_content(damaged.name, damaged.content);
        ASSERT_FALSE(model) << damaged.content;
        expect_one_sentence(model.error(), damaged.name);
        EXPECT_NE(model.error().message.find(damaged.place), std::string::npos) << model.error().message;
        EXPECT_NE(model.error().message.find(damaged.words), std::string::npos) << model.error().message;
    }
}

TEST(DamagedMeshFile, CutOffOrChangedAtAnyByteReadsOrIsRefused)
{
    const TemporaryFolder folder;
    const Mesh mesh = crease_panel(2, 2);
    std::mt19937 sequence(7);
    for (const auto& [name, ascii] : {std::pair{"a.stl", true},
                                      {"a.stl", false},
                                      {"a.obj", true},
                                      {"a.off", true},
                                      {"a.ply", true},
                                      {"a.ply", false}}) {
        const auto file = folder / name;
        ASSERT_TRUE(write_mesh(file, mesh, {.ascii = ascii}));
        const std::string whole = read_text(file);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            for (const bool cut : {true, false}) {
                std::string damaged = cut ? whole.substr(0, size) : whole;
                if (!cut) {
                    damaged[size] = static_cast<char>(sequence());
                }
                const auto model = read_mesh_content(name, damaged);
                if (!model) {
                    expect_one_sentence(model.error(), name);
                    continue;
                }
                EXPECT_TRUE(model->model.mesh.V.allFinite());
                EXPECT_GE(model->model.mesh.F.minCoeff(), 0);
                EXPECT_LT(model->model.mesh.F.maxCoeff(), model->model.mesh.V.rows());
            }
        }
    }
}

TEST(DamagedMeshFile, WithManyFacesCutOffIsNeverTakenForWhole)
{
    const TemporaryFolder folder;
    const Mesh mesh = crease_panel(4, 4);
    for (const auto& [name, ascii] : {std::pair{"a.stl", true}, {"a.stl", false}, {"a.off", true}, {"a.ply", false}}) {
        const auto file = folder / name;
        ASSERT_TRUE(write_mesh(file, mesh, {.ascii = ascii}));
        const std::string whole = read_text(file);
        for (std::size_t size = 200; size + 10 < whole.size(); size += 17) {
            EXPECT_FALSE(read_mesh_content(name, whole.substr(0, size))) << name << " " << size;
        }
    }
}
