// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from exact faces that coarse triangles stand for, in closed form.
#include "kernel/exact_sheet.h"
#include "kernel/quality.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

using namespace tapeline;

namespace {

constexpr double radius = 50;

/// Exact faces given by a rule.
class Faces final : public SurfaceProjector {
public:
    using Rule = std::function<std::optional<SurfaceFoot>(int, const Vec3&)>;
    Faces(int count, Rule rule) : count_(count), rule_(std::move(rule)) {}
    int face_count() const override { return count_; }
    std::optional<SurfaceFoot> closest(int face, const Vec3& p) const override { return rule_(face, p); }
    std::optional<Vec3> closest_on_edge(int, const Vec3&) const override { return std::nullopt; }

private:
    int count_;
    Rule rule_;
};

/// The whole cylinder of radius 50 about x, normals outwards.
std::optional<SurfaceFoot> on_cylinder(int, const Vec3& p)
{
    const Vec3 n = Vec3(0, p.y(), p.z()).normalized();
    return SurfaceFoot{radius * n + Vec3(p.x(), 0, 0), n};
}

Vec3 around(double x, double angle, double r) { return {x, r * std::sin(angle), r * std::cos(angle)}; }

/// Part of that cylinder, ±0.8 rad about the z axis, in steps of 0.2 rad whose chords are 0.25 mm deep.
Model trough(Faces::Rule rule = on_cylinder)
{
    constexpr int columns = 8, rows = 8;
    Model model;
    model.mesh.V.resize((columns + 1) * (rows + 1), 3);
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            model.mesh.V.row(j * (columns + 1) + i) = around(10 * i - 40, 0.2 * (j - 0.5 * rows), radius);
        }
    }
    std::vector<Eigen::RowVector3i> F;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
            F.emplace_back(a, b, d); // outside is +z
            F.emplace_back(a, d, c);
        }
    }
    model.mesh.F.resize(static_cast<Eigen::Index>(F.size()), 3);
    for (size_t t = 0; t < F.size(); ++t) {
        model.mesh.F.row(static_cast<Eigen::Index>(t)) = F[t];
    }
    model.cad_face.assign(F.size(), 0);
    model.surface = std::make_shared<Faces>(1, std::move(rule));
    return model;
}

std::vector<int> all_of(const Model& model)
{
    std::vector<int> all(model.mesh.F.rows());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// The line y = 0 of the trough moved round by a third of a step, what lies beside it in proportion, all on the cylinder.
Positions turned(const Model& model, double lift)
{
    Positions V = model.mesh.V;
    for (Eigen::Index v = 0; v < V.rows(); ++v) {
        const double x = V(v, 0), angle = std::atan2(V(v, 1), V(v, 2));
        const double share = std::max(0.0, 1 - std::abs(angle) / 0.6) * std::max(0.0, 1 - std::abs(x) / 40);
        if (share > 0) {
            V.row(v) = around(x, angle + 0.067 * share, radius + lift * share);
        }
    }
    return V;
}

QualityReport report_on(const Model& model, const Positions& moved, const Model* cad)
{
    QualityInput input{model.mesh, moved, {}, false, {}, {}, nullptr, 3};
    for (int i = 0; i <= 8; ++i) {
        input.line.push_back(4 * 9 + i);
    }
    const auto sides = sides_of_line(model.mesh, all_of(model), input.line, false);
    input.compressed_faces = sides.first;
    input.tension_faces = sides.second;
    input.cad = cad;
    const auto report = measure_quality(input);
    EXPECT_TRUE(report) << report.error().message;
    return *report;
}

} // namespace

TEST(ExactSheet, MeasuresFromTheFaceItselfFromNearAndFarWithItsSign)
{
    const Model model = trough();
    const ExactSheet sheet(model, all_of(model));
    for (const double x : {-33.0, 4.0}) {
        for (const double angle : {-0.65, -0.1, 0.03, 0.5}) {
            // 0.1 below the cylinder is above the chords.
            for (const double height : {-49.0, -20.0, -0.1, -1e-6, 1e-6, 0.1, 3.0, 200.0}) {
                const Vec3 p = around(x, angle, radius + height);
                const SheetFoot foot = sheet.foot(p);
                ASSERT_TRUE(foot.exact) << angle << " " << height;
                EXPECT_NEAR((p - foot.exact->point).norm(), std::abs(height), 1e-9);
                EXPECT_EQ((p - foot.exact->point).dot(foot.exact->normal) > 0, height > 0);
            }
        }
    }
}

TEST(ExactSheet, LeavesToTheTrianglesWhatIsClosestOutsideThePart)
{
    const Model model = trough();
    const ExactSheet sheet(model, all_of(model));
    // The face goes all the way round, the part does not.
    for (const Vec3& p : {around(0, 1.4, 48), around(0, 3, 60), Vec3(70, 0, 51)}) {
        const SheetFoot foot = sheet.foot(p);
        EXPECT_FALSE(foot.exact);
        EXPECT_GE(foot.triangle.face, 0);
        EXPECT_GT(foot.triangle.distance, 10);
    }
}

TEST(ExactSheet, FindsOutASearchThatEndsInAnotherValley)
{
    // A search that stops at a place on the face 25 degrees away, as one that started there would.
    const Model model = trough([](int face, const Vec3& p) {
        const bool on_it = std::abs(std::hypot(p.y(), p.z()) - radius) < 1;
        const double angle = std::atan2(p.y(), p.z());
        return on_it ? on_cylinder(face, p)
                     : on_cylinder(face, around(p.x(), angle > 0 ? angle - 0.4 : angle + 0.4, 1));
    });
    const ExactSheet sheet(model, all_of(model));
    EXPECT_TRUE(sheet.foot(around(0, 0.3, radius + 0.5)).exact);
    for (const double height : {-20.0, 5.0, 70.0}) {
        const SheetFoot foot = sheet.foot(around(0, 0.3, radius + height));
        EXPECT_FALSE(foot.exact) << height;
        EXPECT_NEAR(foot.triangle.distance, std::abs(height), 0.26);
    }
}

TEST(ExactSheet, KnowsInsideFromOutsideBesideASharpEdge)
{
    // Two quarter planes that meet in the x axis, once as a ridge and once as a valley.
    for (const double fall : {-1.0, 1.0}) {
        Model model;
        model.mesh.V.resize(6, 3);
        model.mesh.V << -9, -9, 9 * fall, 9, -9, 9 * fall, -9, 0, 0, 9, 0, 0, -9, 9, 9 * fall, 9, 9, 9 * fall;
        model.mesh.F.resize(4, 3);
        model.mesh.F << 0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4;
        model.cad_face = {0, 0, 1, 1};
        model.surface = std::make_shared<Faces>(2, [fall](int face, const Vec3& p) {
            const double side = face == 0 ? -1 : 1;
            const Vec3 down = Vec3(0, side, fall).normalized();
            const double along = std::max(0.0, down.dot(p));
            return SurfaceFoot{Vec3(p.x(), 0, 0) + along * down, Vec3(0, -side * fall, 1).normalized()};
        });
        const ExactSheet sheet(model, all_of(model));
        for (const double y : {-0.3, 0.0, 0.2}) {
            for (const double z : {-1.0, 1.0}) {
                const Vec3 p(2, y, z);
                const SheetFoot foot = sheet.foot(p);
                ASSERT_TRUE(foot.exact);
                const double outside = std::max(-fall, 0.0) > 0 ? z + std::abs(y) : z - std::abs(y);
                EXPECT_EQ((p - foot.exact->point).dot(foot.exact->normal) > 0, outside > 0) << fall << y << z;
            }
        }
    }
}

TEST(Bulge, IsMeasuredFromTheCadFacesWhereTheModelHasThem)
{
    const Model model = trough();
    const Positions along = turned(model, 0), off = turned(model, 2);
    const QualityReport exact = report_on(model, along, &model), chords = report_on(model, along, nullptr);
    EXPECT_EQ(exact.bulge_reference, BulgeReference::exact);
    EXPECT_EQ(exact.bulge_fallbacks, 0);
    EXPECT_LT(std::abs(exact.bulge_max_mm), 1e-9);
    EXPECT_EQ(chords.bulge_reference, BulgeReference::triangles);
    EXPECT_GT(chords.bulge_max_mm, 0.05);

    // A side that is meant to leave the surface: of the vertices beside the line those in the middle rise most.
    const QualityReport above = report_on(model, off, &model);
    EXPECT_NEAR(above.bulge_max_mm, 2 * (1 - 0.2 / 0.6), 1e-9);
    Model mesh = model;
    mesh.surface.reset();
    EXPECT_EQ(report_on(model, along, &mesh).bulge_max_mm, chords.bulge_max_mm);
}
