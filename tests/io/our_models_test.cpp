// SPDX-License-Identifier: GPL-3.0-or-later
// The sample models in resources/models: what their descriptions promise, and that the program that makes them gives
// the committed files.
#include "io/file_content.h"
#include "io/model_file.h"
#include "kernel/curve.h"
#include "kernel/topology.h"
#include "tests/io/cad_shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

std::filesystem::path model_path(const std::string& name)
{
    return std::filesystem::path(TAPELINE_SOURCE_DIR) / "resources/models" / name;
}

ImportedModel import(const std::string& name)
{
    auto read = read_cad(model_path(name), {});
    EXPECT_TRUE(read) << read.error().message;
    return std::move(*read);
}

struct SharpEdge {
    Vec3 middle;
    double angle, length; // [deg], [mm]
    int cad_edge;
};

/// All tagged mesh edges between two CAD faces with the angle between the exact normals at their middle.
std::vector<SharpEdge> creases(const Model& model)
{
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    std::vector<SharpEdge> result;
    for (const CadEdgeTag& tag : model.cad_edges) {
        const MeshEdge& edge = topology.edge(topology.find_edge(tag.a, tag.b));
        if (edge.border()) {
            continue;
        }
        const Vec3 a = model.mesh.V.row(tag.a), b = model.mesh.V.row(tag.b);
        const Vec3 middle = *model.surface->closest_on_edge(tag.cad_edge, (a + b) / 2);
        const Vec3 n = model.surface->closest(model.cad_face[edge.left], middle)->normal;
        const Vec3 m = model.surface->closest(model.cad_face[edge.right], middle)->normal;
        const double angle = std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / std::numbers::pi;
        result.push_back({middle, angle, (b - a).norm(), tag.cad_edge});
    }
    return result;
}

Vec3 size_of(const Mesh& mesh) { return mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff(); }

} // namespace

TEST(OurModels, HoodHasACharacterLineThatFadesOutBeforeTheRim)
{
    const ImportedModel hood = import("hood.step");
    EXPECT_LT((size_of(hood.model.mesh).head<2>() - Eigen::Vector2d(1400, 1200)).norm(), 1e-6);
    EXPECT_EQ(hood.report.cad_faces, 2);
    EXPECT_EQ(hood.report.sewn_edges, 0) << "the two faces share their edge in the file";
    for (const SharpEdge& edge : creases(hood.model)) {
        const double x = edge.middle.x();
        if (x < 250) {
            EXPECT_NEAR(edge.angle, 20, 1.5) << x;
        } else if (x > 1250) {
            EXPECT_LT(edge.angle, 0.01) << x;
        }
        EXPECT_LT(edge.angle, 21.5);
        EXPECT_TRUE(x > 700 || edge.angle > 10) << x << ": " << edge.angle;
    }
    for (int t = 0; t < hood.model.mesh.F.rows(); ++t) {
        EXPECT_GT(triangle_normal(hood.model.mesh, t).z(), 0.5) << "the outside is up";
    }
}

TEST(OurModels, HoodIsSmoothAwayFromItsLine)
{
    const ImportedModel hood = import("hood.step");
    const Topology topology(hood.model.mesh.F, static_cast<int>(hood.model.mesh.V.rows()));
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        if (!edge.border() && hood.model.cad_face[edge.left] == hood.model.cad_face[edge.right]) {
            EXPECT_GT(triangle_normal(hood.model.mesh, edge.left).dot(triangle_normal(hood.model.mesh, edge.right)),
                      std::cos(5 * std::numbers::pi / 180));
        }
    }
}

TEST(OurModels, WheelArchHasANarrowStripBelowItsLineAndATightBendBesideIt)
{
    const ImportedModel arch = import("wheel_arch.step");
    EXPECT_EQ(arch.report.cad_faces, 2);
    const auto edges = creases(arch.model);
    ASSERT_FALSE(edges.empty());
    for (const SharpEdge& edge : edges) {
        EXPECT_GT(edge.angle, 20);
        EXPECT_LT(edge.angle, 35);
        const double above_arch = std::hypot(edge.middle.x(), edge.middle.z()) - 340;
        EXPECT_GT(above_arch, 34.9);
        EXPECT_LT(above_arch, 45.1);
    }
    // Above the arch's top, the panel turns by more than 12° within 40 mm of the line.
    const int panel = arch.model.surface->closest(0, Vec3(0, 0, 600))->point.z() > 500 ? 0 : 1;
    const auto normal_at = [&](double above_line) {
        Vec3 p(0, 0, 385 + above_line);
        SurfaceFoot foot;
        for (int i = 0; i < 100; ++i) { // the panel is seen along y: walk to where the foot lies straight ahead
            foot = arch.model.surface->closest(panel, p).value_or(SurfaceFoot());
            p.y() = foot.point.y();
        }
        EXPECT_LT((foot.point - p).norm(), 0.1);
        return foot.normal;
    };
    const double turned = std::acos(normal_at(3).dot(normal_at(40))) * 180 / std::numbers::pi;
    EXPECT_GT(turned, 12);
}

TEST(OurModels, PawnIsASolidOfRevolutionWithSharpCircles)
{
    const ImportedModel pawn = import("pawn.step");
    EXPECT_EQ(pawn.report.border_edges, 0);
    EXPECT_GT(enclosed_volume(pawn.model.mesh), 0);
    std::map<int, std::vector<SharpEdge>> by_edge;
    for (const SharpEdge& edge : creases(pawn.model)) {
        by_edge[edge.cad_edge].push_back(edge);
    }
    int circles = 0;
    for (const auto& [number, edges] : by_edge) {
        double length = 0;
        for (const SharpEdge& edge : edges) {
            length += edge.length;
            EXPECT_NEAR(edge.angle, edges.front().angle, 0.01);
        }
        const double radius = std::hypot(edges.front().middle.x(), edges.front().middle.y());
        if (edges.front().angle > 15) {
            ++circles;
            EXPECT_NEAR(length, 2 * std::numbers::pi * radius, 0.02 * length) << "a closed circle";
        }
    }
    EXPECT_GE(circles, 5);
}

TEST(OurModels, BracketHasAFlatSideThatMeetsACurvedSideAtASharpEdge)
{
    const ImportedModel bracket = import("bracket.step");
    EXPECT_EQ(bracket.report.border_edges, 0);
    double length = 0, low = 1e9, high = -1e9;
    for (const SharpEdge& edge : creases(bracket.model)) {
        // The upper edge of the curved front, on the plate's top at z = 30.
        if (std::abs(edge.middle.z() - 30) < 1e-6 && edge.middle.y() < -20 && edge.middle.x() > 1 &&
            edge.middle.x() < 139) {
            EXPECT_GT(edge.angle, 30);
            EXPECT_LT(edge.angle, 80);
            length += edge.length;
            low = std::min(low, edge.middle.y());
            high = std::max(high, edge.middle.y());
        }
    }
    EXPECT_GT(length, 140) << "it runs across the whole part";
    EXPECT_GT(high - low, 10) << "it is curved";
}

TEST(OurModels, PanelIsSewnFromSixPatchesAlongATwelveDegreeCrease)
{
    const ImportedModel panel = import("panel.step");
    EXPECT_EQ(panel.report.cad_faces, 6);
    EXPECT_EQ(panel.report.sewn_edges, 7);
    EXPECT_EQ(component_count(panel.model.mesh), 1);
    double crease = 0;
    for (const SharpEdge& edge : creases(panel.model)) {
        if (std::abs(edge.middle.y()) < 1e-6) {
            crease += edge.length;
            EXPECT_NEAR(edge.angle, 12, 0.2);
        } else {
            EXPECT_LT(edge.angle, 0.01);
        }
    }
    EXPECT_NEAR(crease, 800, 5);
}

TEST(OurModels, DoorHasTwoLinesAndASeamThatCrossesBoth)
{
    const ImportedModel door = import("door.step");
    EXPECT_EQ(door.report.cad_faces, 6);
    EXPECT_EQ(component_count(door.model.mesh), 1);
    double shoulder = 0, upper = 0, seam = 0;
    for (const SharpEdge& edge : creases(door.model)) {
        const double x = edge.middle.x(), y = edge.middle.y();
        if (std::abs(y) < 1e-6) {
            shoulder += edge.length;
            EXPECT_NEAR(edge.angle, 14, 0.7);
        } else if (std::abs(x - 60) < 1e-6) {
            seam += edge.length;
            EXPECT_NEAR(edge.angle, 12, 0.7);
        } else {
            upper += edge.length;
            EXPECT_NEAR(y, 130 + x * x / 9000, 0.1);
            EXPECT_NEAR(edge.angle, 12, 0.7);
        }
    }
    EXPECT_NEAR(shoulder, 1015, 10);
    EXPECT_NEAR(upper, 1018, 10);
    EXPECT_NEAR(seam, 620, 5);
}

TEST(OurModels, ComeOutOfTheirProgramByteForByte)
{
    const ScratchFolder folder;
    for (const char* run : {"one", "two"}) {
        const std::string command = fmt::format("{} {}", TAPELINE_MAKE_MODELS, (folder / run).string());
        ASSERT_EQ(std::system(command.c_str()), 0);
    }
    for (const char* name : {"hood.step", "wheel_arch.step", "pawn.step", "bracket.step", "panel.step", "door.step",
                             "filleted_panel.step"}) {
        const auto one = read_file_content((folder / "one") / name), two = read_file_content((folder / "two") / name);
        const auto committed = read_file_content(model_path(name));
        ASSERT_TRUE(one && two && committed);
        EXPECT_TRUE(one->view() == two->view()) << name;
        EXPECT_TRUE(one->view() == committed->view()) << name << " is not what make_models makes; run it again";
    }
}
