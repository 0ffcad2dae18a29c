// SPDX-License-Identifier: GPL-3.0-or-later
// Thin plates whose clamped rim runs along a crease: the triangles beyond it, which stay, face another way.
#include "kernel/plate.h"
#include "tests/support/plates.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// A flat strip, 160 mm wide and 100 mm long in y, beyond whose end at y = 0 the surface falls by `slope` and is held;
/// its other end is moved by `pull` times a bell over x, and may tilt.
struct StripBesideCrease {
    Mesh mesh;
    PlateSupport support;
    StripBesideCrease(double slope, const Vec3& pull, Diagonals diagonals)
        : mesh(grid(16, 12, -80, 80, -20, 100, [&](double, double y) { return slope * std::min(y, 0.0); }, diagonals,
                    {2}))
    {
        support = holding(
            mesh, [](const Vec3& p) { return p.y() < 1e-9 || p.y() > 100 - 1e-9; },
            [&](const Vec3& p) -> Vec3 {
                const double bell = std::pow(std::cos(p.x() * M_PI / 320), 2);
                return p.y() > 1 ? Vec3(p + bell * pull) : p;
            });
        for (const int v : support.constrained) {
            if (mesh.V(v, 1) > 1) {
                support.free_slope.push_back(v);
            }
        }
    }
    Positions bent() const
    {
        const PlateOptions options{.material = {3, Stiff::along, Vec3::UnitY()}, .tolerance_mm = 1e-6};
        const auto result = bend_plate(mesh, support, options);
        EXPECT_TRUE(result && result->converged);
        return result ? result->V : mesh.V;
    }
};

} // namespace

TEST(PlateBesideACrease, StaysFlatWhereItIsStretchedInItsPlane)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const StripBesideCrease strip(-0.6, Vec3(5, 40, 0), diagonals);
        const Positions V = strip.bent();
        for (int v = 0; v < V.rows(); ++v) {
            if (strip.mesh.V(v, 1) > 0) {
                EXPECT_NEAR(V(v, 2), 0, 5e-3) << V.row(v); // of 40 mm
            }
        }
    }
}

TEST(PlateBesideACrease, BendsAsItWouldWereTheSurfaceSmoothThere)
{
    for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::random}) {
        const Vec3 pull(0, 30, 25);
        const StripBesideCrease creased(-0.6, pull, diagonals), smooth(0, pull, diagonals);
        const Positions V = creased.bent(), W = smooth.bent();
        for (int v = 0; v < V.rows(); ++v) {
            if (creased.mesh.V(v, 1) > 0) {
                EXPECT_LT((V.row(v) - W.row(v)).norm(), 0.2) << W.row(v); // of 39 mm
            }
        }
    }
}
