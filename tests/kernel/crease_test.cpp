// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/crease.h"
#include "kernel/topology.h"
#include "tests/support/shapes.h"
#include "tests/support/side.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// Normal of the triangle of `mesh` that runs a→b (or b→a), with the mesh's orientation.
Vec3 normal_at(const Mesh& mesh, const Positions& V, int a, int b)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    return triangle_normal({V, mesh.F}, topology.face_left_of(a, b));
}

/// Both sides of a line on a mesh.
struct TwoSides {
    SideMesh left, right;
    std::vector<Vec3> other;  ///< normals of the right side beside the line
    std::vector<double> rest; ///< signed crease angles at rest [deg]

    TwoSides(const Mesh& mesh, const std::vector<int>& line)
    {
        auto sides = split_along(line_across(mesh, line));
        left = std::move((*sides)[0]);
        right = std::move((*sides)[1]);
        for (size_t i = 0; i + 1 < line.size(); ++i) {
            other.push_back(normal_at(mesh, mesh.V, line[i + 1], line[i]));
        }
        rest = angles(left.mesh.V);
    }

    std::vector<double> angles(const Positions& V) const
    {
        std::vector<double> result;
        for (size_t i = 0; i + 1 < left.line.size(); ++i) {
            const int a = left.line[i], b = left.line[i + 1];
            const Vec3 n = normal_at(left.mesh, V, a, b), along = (V.row(b) - V.row(a)).normalized();
            result.push_back(std::atan2(other[i].cross(n).dot(along), other[i].dot(n)) * 180 / std::numbers::pi);
        }
        return result;
    }

    double rms_difference(const Positions& V) const
    {
        const std::vector<double> now = angles(V);
        double sum = 0;
        for (size_t i = 0; i < rest.size(); ++i) {
            sum += std::pow(now[i] - rest[i], 2);
        }
        return std::sqrt(sum / static_cast<double>(rest.size()));
    }
};

DeformationOptions along_y()
{
    DeformationOptions options;
    options.material.stiff_direction = Vec3::UnitY();
    return options;
}

/// The left side of a roof bent so that it leaves the line without an angle and meets the rim where it was.
Positions without_crease(const SideMesh& left)
{
    Positions V = left.mesh.V;
    for (int v = 0; v < V.rows(); ++v) {
        const double t = V(v, 1) / 1000;
        V(v, 2) += 0.6 * V(v, 1) * (1 - t) * (1 - t);
    }
    return V;
}

} // namespace

TEST(Crease, OfARoofThatLostItsAngleComesBack)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const TwoSides roof(flat_roof(40, 24, diagonals), grid_row(40, 12));
        const Positions flat = without_crease(roof.left);
        ASSERT_GT(roof.rms_difference(flat), 25);
        const auto result = restore_crease(roof.left, flat, 0, 40, roof.other, roof.rest, along_y());
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_TRUE(result->converged);
        // The first and last triangle's third corner may be on the fixed rim.
        const std::vector<double> now = roof.angles(result->V);
        for (size_t i = 1; i + 1 < now.size(); ++i) {
            EXPECT_NEAR(now[i], roof.rest[i], 0.05) << i;
        }
        for (const std::vector<int>* held : {&roof.left.fixed, &roof.left.line}) {
            for (const int v : *held) {
                EXPECT_EQ(result->V.row(v), flat.row(v));
            }
        }
    }
}

TEST(Crease, AlongABentLineComesBackWithinADegree)
{
    // The line swings by 60 mm over 400 mm, so neighbouring edges ask different things of one triangle corner.
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        Mesh mesh = flat_roof(60, 24, diagonals);
        for (int v = 0; v < mesh.V.rows(); ++v) {
            mesh.V(v, 1) += 60 * std::sin(mesh.V(v, 0) * std::numbers::pi / 400) * (1 - std::abs(mesh.V(v, 1)) / 1000);
        }
        const TwoSides roof(mesh, grid_row(60, 12));
        Positions lost = roof.left.mesh.V;
        for (int v = 0; v < lost.rows(); ++v) {
            const double t = std::min(1.0, std::abs(mesh.V(v, 1)) / 1000);
            lost(v, 2) += 0.2 * (300 + lost(v, 2)) * t * (1 - t) * 2;
        }
        for (const int v : roof.left.line) {
            lost.row(v) = roof.left.mesh.V.row(v);
        }
        for (const int v : roof.left.fixed) {
            lost.row(v) = roof.left.mesh.V.row(v);
        }
        ASSERT_GT(roof.rms_difference(lost), 3);
        const auto result = restore_crease(roof.left, lost, 0, 60, roof.other, roof.rest, along_y());
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_LT(roof.rms_difference(result->V), 1);
    }
}

TEST(Crease, ThatIsStillThereLeavesEveryPosition)
{
    const TwoSides roof(flat_roof(20, 12, Diagonals::random), grid_row(20, 6));
    const auto result = restore_crease(roof.left, roof.left.mesh.V, 0, 20, roof.other, roof.rest, along_y());
    ASSERT_TRUE(result);
    EXPECT_EQ(result->V, roof.left.mesh.V);
    EXPECT_TRUE(result->converged);
}

TEST(Crease, IsRestoredOnTheUsedPartOnly)
{
    const TwoSides roof(flat_roof(40, 24), grid_row(40, 12));
    const Positions flat = without_crease(roof.left);
    const std::vector<Vec3> other(roof.other.begin() + 10, roof.other.begin() + 30);
    const std::vector<double> wanted(roof.rest.begin() + 10, roof.rest.begin() + 30);
    const auto result = restore_crease(roof.left, flat, 10, 30, other, wanted, along_y());
    ASSERT_TRUE(result);
    const std::vector<double> now = roof.angles(result->V), before = roof.angles(flat);
    for (int i = 0; i < 40; ++i) {
        if (i >= 10 && i < 30) {
            EXPECT_NEAR(now[i], roof.rest[i], 0.05) << i;
        } else if (i < 5 || i >= 35) {
            EXPECT_LT(std::abs(now[i] - before[i]), std::abs(now[i] - roof.rest[i])) << i;
        }
    }
}

TEST(Crease, TurnsAndScalesWithTheModel)
{
    const TwoSides roof(flat_roof(20, 12, Diagonals::random), grid_row(20, 6));
    const Positions flat = without_crease(roof.left);
    DeformationOptions options = along_y();
    options.tolerance_mm = 1e-7;
    const auto result = restore_crease(roof.left, flat, 0, 20, roof.other, roof.rest, options);
    ASSERT_TRUE(result);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(2, Vec3(1, 1, 3).normalized()).toRotationMatrix();
    const Vec3 shift(10, 20, 30);
    SideMesh turned = roof.left;
    turned.mesh.V = transformed(roof.left.mesh.V, 0.01, R, shift);
    std::vector<Vec3> other;
    for (const Vec3& n : roof.other) {
        other.push_back(R * n);
    }
    options.material.stiff_direction = R * Vec3::UnitY();
    options.tolerance_mm = 1e-9;
    const auto second = restore_crease(turned, transformed(flat, 0.01, R, shift), 0, 20, other, roof.rest, options);
    ASSERT_TRUE(second);
    EXPECT_LT((second->V - transformed(result->V, 0.01, R, shift)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Crease, RefusesListsThatDoNotFitTheLine)
{
    const TwoSides roof(flat_roof(10, 6), grid_row(10, 3));
    const auto result = restore_crease(roof.left, roof.left.mesh.V, 0, 9, roof.other, roof.rest, along_y());
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
}
