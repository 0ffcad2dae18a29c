// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/canvas.h"
#include "io/picture.h"
#include "io/raster.h"
#include "io/shaders.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <numeric>
#include <tbb/global_control.h>
#include <unistd.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// A PNG read back: RGB in [0, 255].
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::array<int, 3>> rgb;

    explicit Pixels(const std::filesystem::path& png)
    {
        cairo_surface_t* const surface = cairo_image_surface_create_from_png(png.c_str());
        width = cairo_image_surface_get_width(surface);
        height = cairo_image_surface_get_height(surface);
        const unsigned char* const data = cairo_image_surface_get_data(surface);
        const int stride = cairo_image_surface_get_stride(surface);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const unsigned char* const p = data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x;
                rgb.push_back({p[2], p[1], p[0]}); // little-endian ARGB
            }
        }
        cairo_surface_destroy(surface);
    }
    template <class Test>
    int count(const Test& test) const
    {
        return static_cast<int>(std::count_if(rgb.begin(), rgb.end(), test));
    }
};

class Picture : public ::testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path file(const char* name) const { return folder_ / name; }
    std::string bytes(const char* name) const
    {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("tapeline_picture_" + std::to_string(getpid()));
    const Mesh panel_ = crease_panel(30, 20);
    PictureOptions small_ = [] {
        PictureOptions options;
        options.width = 320;
        options.height = 240;
        return options;
    }();
};

bool is_red(const std::array<int, 3>& p) { return p[0] > 170 && p[1] < 90 && p[2] < 90; }

Mesh box(double sx, double sy, double sz)
{
    Mesh mesh;
    mesh.V.resize(8, 3);
    for (int v = 0; v < 8; ++v) {
        mesh.V.row(v) << (v & 1 ? sx : 0), (v & 2 ? sy : 0), (v & 4 ? sz : 0);
    }
    mesh.F.resize(12, 3);
    mesh.F << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7,
        5;
    return mesh;
}

} // namespace

TEST_F(Picture, ShowsTheMeshInTheWantedSize)
{
    ASSERT_TRUE(draw_mesh(file("a.png"), panel_, small_));
    const Pixels pixels(file("a.png"));
    EXPECT_EQ(pixels.width, 320);
    EXPECT_EQ(pixels.height, 240);
    // The background is nearly white; the panel covers a fair part.
    const int covered = pixels.count([](const auto& p) { return p[0] < 200; });
    EXPECT_GT(covered, 320 * 240 / 10);
    EXPECT_LT(covered, 320 * 240 * 9 / 10);
}

TEST_F(Picture, HasTheSameBytesEachTimeAndForAnyNumberOfThreads)
{
    small_.title = "Same";
    small_.shading = Shading::zebra;
    ASSERT_TRUE(draw_mesh(file("a.png"), panel_, small_));
    ASSERT_TRUE(draw_mesh(file("b.png"), panel_, small_));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    ASSERT_TRUE(draw_mesh(file("c.png"), panel_, small_));
    EXPECT_FALSE(bytes("a.png").empty());
    EXPECT_EQ(bytes("a.png"), bytes("b.png"));
    EXPECT_EQ(bytes("a.png"), bytes("c.png"));
}

TEST_F(Picture, DrawsALineInItsColourUnlessItIsBehindTheSurface)
{
    PictureLine line;
    for (const int v : crease_panel_line(30, 20)) {
        line.points.emplace_back(panel_.V.row(v));
    }
    small_.lines = {line};
    ASSERT_TRUE(draw_mesh(file("on.png"), panel_, small_));
    const int visible = Pixels(file("on.png")).count(is_red);
    EXPECT_GT(visible, 150);
    for (Vec3& p : small_.lines[0].points) {
        p.z() -= 60;
    }
    ASSERT_TRUE(draw_mesh(file("under.png"), panel_, small_));
    EXPECT_LT(Pixels(file("under.png")).count(is_red), visible / 4);
}

TEST_F(Picture, WritesALabelWhateverItsBytes)
{
    PictureLine line{
        {Vec3(panel_.V.row(310)), Vec3(panel_.V.row(320))}, {0.1, 0.2, 0.9}, "line \xff\xc0 7 \u00b5", false};
    small_.title = "\xfe\xff title";
    small_.lines = {line};
    EXPECT_TRUE(draw_mesh(file("a.png"), panel_, small_));
}

TEST_F(Picture, OfASphereInZebraHasStripesOfLightAndDark)
{
    const Mesh cap = grid(40, 40, -60, 60, -60, 60, [](double x, double y) { return std::sqrt(1e4 - x * x - y * y); });
    small_.shading = Shading::zebra;
    ASSERT_TRUE(draw_mesh(file("a.png"), cap, small_));
    const Pixels pixels(file("a.png"));
    // Down the middle column, count changes between clear light and clear dark.
    int changes = 0, last = 0;
    for (int y = 0; y < pixels.height; ++y) {
        const auto& p = pixels.rgb[y * pixels.width + pixels.width / 2];
        const int now = p[0] > 200 ? 1 : (p[0] < 100 ? -1 : 0);
        changes += now * last < 0;
        last = now != 0 ? now : last;
    }
    EXPECT_GE(changes, 8);
    EXPECT_LE(changes, 40);
}

TEST_F(Picture, MarksSignsOfCurvatureByColour)
{
    small_.shading = Shading::curvature_sign;
    small_.legend = false;
    const auto colours = [&](double value) {
        small_.values.assign(panel_.V.rows(), value);
        EXPECT_TRUE(draw_mesh(file("a.png"), panel_, small_));
        const Pixels pixels(file("a.png"));
        return std::array{pixels.count([](const auto& p) { return p[0] > p[2] + 60; }),
                          pixels.count([](const auto& p) { return p[2] > p[0] + 60; })};
    };
    const auto positive = colours(1), negative = colours(-1), zero = colours(0);
    EXPECT_GT(positive[0], 5000);
    EXPECT_EQ(positive[1], 0);
    EXPECT_GT(negative[1], 5000);
    EXPECT_EQ(negative[0], 0);
    EXPECT_EQ(zero[0] + zero[1], 0);
    EXPECT_EQ(colours(std::numeric_limits<double>::quiet_NaN())[0], 0);
}

TEST_F(Picture, RefusesWhatCannotBeDrawnAndLeavesNoFile)
{
    Mesh broken = panel_;
    broken.V(5, 1) = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(draw_mesh(file("a.png"), broken, small_));
    EXPECT_FALSE(draw_mesh(file("a.png"), Mesh{}, small_));
    PictureOptions wrong = small_;
    wrong.width = 100000;
    EXPECT_FALSE(draw_mesh(file("a.png"), panel_, wrong));
    wrong = small_;
    wrong.shading = Shading::curvature_sign;
    wrong.values = {1, 2, 3};
    EXPECT_FALSE(draw_mesh(file("a.png"), panel_, wrong));
    EXPECT_FALSE(draw_sections(file("a.png"), {}));
    EXPECT_FALSE(std::filesystem::exists(file("a.png")));
    EXPECT_FALSE(draw_mesh(file("no such folder") / "a.png", panel_, small_));
}

TEST_F(Picture, OfSectionsShowsEachSideInItsColour)
{
    std::vector<int> faces(panel_.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    const auto line = crease_panel_line(30, 20);
    const auto [left, right] = sides_of_line(panel_, faces, line, false);
    const auto sections = cross_sections({panel_, panel_.V, line, false, left, right, nullptr, 3});
    ASSERT_EQ(sections.size(), 3U);
    ASSERT_TRUE(draw_sections(file("a.png"), sections));
    const Pixels pixels(file("a.png"));
    EXPECT_GT(pixels.count([](const auto& p) { return p[0] > p[2] + 100; }), 300); // orange
    EXPECT_GT(pixels.count([](const auto& p) { return p[2] > p[0] + 80; }), 300);  // teal
}

TEST(FitCamera, ShowsAllVerticesFromTheSideThatTheNormalsFace)
{
    Mesh upside_down = crease_panel(12, 8);
    upside_down.F.col(1).swap(upside_down.F.col(2));
    Mesh wall = crease_panel(12, 8);
    wall.V = wall.V * Eigen::AngleAxisd(1.5, Vec3::UnitX()).toRotationMatrix().transpose();
    for (const Mesh& mesh : {crease_panel(12, 8), upside_down, wall, box(3, 50, 7), box(100, 1, 1), box(1, 1, 90)}) {
        for (const double aspect : {4.0 / 3, 1.0, 0.5}) {
            const Camera camera = fit_camera(mesh, {}, aspect);
            const picture::View view(camera, static_cast<int>(600 * aspect), 600);
            Vec3 facing = Vec3::Zero();
            for (int t = 0; t < mesh.F.rows(); ++t) {
                facing += triangle_area(mesh, t) * triangle_normal(mesh, t);
            }
            EXPECT_GE(facing.dot(view.towards), -1e-6);
            for (int v = 0; v < mesh.V.rows(); ++v) {
                const Vec3 p = view.project(mesh.V.row(v));
                EXPECT_TRUE(p.x() > 5 && p.x() < view.width - 5 && p.y() > 5 && p.y() < view.height - 5)
                    << p.transpose();
            }
        }
    }
}

TEST(Raster, CoversExactlyTheProjectedArea)
{
    const Mesh square = grid(3, 3, -1, 1, -1, 1, [](double, double) { return 0.0; });
    Camera camera;
    camera.direction = -Vec3::UnitZ();
    camera.up = Vec3::UnitY();
    camera.height_mm = 4;
    const picture::View view(camera, 200, 100);
    const auto raster = picture::rasterise(square, view, [](int, const Vec3&) { return picture::Colour{1, 1, 1}; });
    const double covered = std::accumulate(raster.coverage.begin(), raster.coverage.end(), 0.0);
    EXPECT_NEAR(covered, 50 * 50, 1e-6);
}
