// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_file.h"
#include "tests/support/files.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// A panel whose coordinates use all bits of a double, over many orders of magnitude.
Mesh awkward_numbers()
{
    Mesh mesh = crease_panel(8, 6, Diagonals::random);
    std::mt19937_64 sequence(3);
    for (double& x : mesh.V.reshaped()) {
        x += std::ldexp(static_cast<double>(sequence()), -64 - static_cast<int>(sequence() % 30));
    }
    mesh.V(0, 2) = std::numeric_limits<double>::denorm_min();
    mesh.V(1, 2) = -0.0;
    mesh.V(2, 2) = 1e22;
    mesh.V(3, 2) = 1.0 / 3;
    return mesh;
}

bool same_bits(const Positions& a, const Positions& b)
{
    return a.rows() == b.rows() &&
           std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

Mesh read_back(const std::filesystem::path& file) { return read_mesh(file, {}).value().model.mesh; }

} // namespace

TEST(MeshExport, ReadsBackBitByBitInTheSameOrder)
{
    const TemporaryFolder folder;
    const Mesh mesh = awkward_numbers();
    for (const auto& [name, ascii] :
         {std::pair{"a.obj", false}, {"a.off", false}, {"a.ply", false}, {"b.ply", true}, {"C.OBJ", true}}) {
        ASSERT_TRUE(write_mesh(folder / name, mesh, {.ascii = ascii}));
        const Mesh again = read_back(folder / name);
        EXPECT_TRUE(same_bits(again.V, mesh.V)) << name;
        EXPECT_EQ(again.F, mesh.F) << name;
    }
}

TEST(MeshExport, KeepsTheCornersOfStlTriangles)
{
    const TemporaryFolder folder;
    const Mesh mesh = awkward_numbers();
    for (const bool ascii : {true, false}) {
        ASSERT_TRUE(write_mesh(folder / "a.stl", mesh, {.ascii = ascii}));
        const Mesh again = read_back(folder / "a.stl");
        ASSERT_EQ(again.F.rows(), mesh.F.rows());
        for (int t = 0; t < mesh.F.rows(); ++t) {
            for (int k = 0; k < 3; ++k) {
                for (int axis = 0; axis < 3; ++axis) {
                    const double x = mesh.V(mesh.F(t, k), axis);
                    EXPECT_EQ(again.V(again.F(t, k), axis), ascii ? x : static_cast<double>(static_cast<float>(x)));
                }
            }
        }
    }
}

TEST(MeshExport, WritesTheSameBytesTwice)
{
    const TemporaryFolder folder;
    const Mesh mesh = awkward_numbers();
    for (const std::string name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
        ASSERT_TRUE(write_mesh(folder / name, mesh));
        const std::string first = read_text(folder / name);
        ASSERT_TRUE(write_mesh(folder / name, mesh));
        EXPECT_EQ(first, read_text(folder / name));
    }
}

TEST(MeshExport, WritesUnitNormalsIntoBinaryStl)
{
    const TemporaryFolder folder;
    const Mesh mesh = crease_panel(4, 2);
    ASSERT_TRUE(write_mesh(folder / "a.stl", mesh));
    const std::string content = read_text(folder / "a.stl");
    ASSERT_EQ(content.size(), 84 + 50 * static_cast<std::size_t>(mesh.F.rows()));
    EXPECT_NE(content.substr(0, 5), "solid");
    for (int t = 0; t < mesh.F.rows(); ++t) {
        std::array<float, 3> n{};
        std::memcpy(n.data(), content.data() + 84 + 50 * t, 12);
        EXPECT_NEAR((Vec3(n[0], n[1], n[2]) - triangle_normal(mesh, t)).norm(), 0, 1e-6);
    }
}

TEST(MeshExport, DividesByTheUnit)
{
    const TemporaryFolder folder;
    const Mesh mesh = crease_panel(4, 2);
    ASSERT_TRUE(write_mesh(folder / "a.obj", mesh, {.units_mm = 1000}));
    const auto again = read_mesh(folder / "a.obj", {.units_mm = 1000}).value().model.mesh;
    EXPECT_LT((again.V - mesh.V).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_DOUBLE_EQ(read_back(folder / "a.obj").V(0, 0), -0.4);
}

TEST(MeshExport, RefusesInOneSentenceAndLeavesTheOldFileAlone)
{
    const TemporaryFolder folder;
    const auto expect_refusal = [&](const std::filesystem::path& file, const Mesh& mesh, const std::string& words) {
        const auto written = write_mesh(file, mesh);
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().message.find(words), std::string::npos) << written.error().message;
    };
    Mesh mesh = crease_panel(4, 2);
    expect_refusal(folder / "a.fbx", mesh, ".stl, .obj, .ply or .off");
    expect_refusal(folder / "a", mesh, ".stl, .obj, .ply or .off");
    expect_refusal(folder / "no/such/folder/a.obj", mesh, "cannot write");
    folder.write("a.obj", "old");
    mesh.V(3, 1) = std::numeric_limits<double>::quiet_NaN();
    expect_refusal(folder / "a.obj", mesh, "vertex 3 is not a finite point");
    mesh.V(3, 1) = 1e39;
    expect_refusal(folder / "a.stl", mesh, "float32");
    mesh.F(2, 2) = 999;
    expect_refusal(folder / "a.obj", mesh, "triangle 2");
    EXPECT_EQ(read_text(folder / "a.obj"), "old");
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        ++files;
    }
    EXPECT_EQ(files, 1);
}
