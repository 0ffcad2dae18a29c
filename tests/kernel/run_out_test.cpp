// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/run_out.h"
#include "tests/support/hand_made.h"
#include "tests/support/moves.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// Flat, in edges of 5 mm; the line y = 0, |x| ≤ 120, moves by 20 mm sideways at its last end and stays at its first.
ExtendedLine moved_at_one_end()
{
    const Model model = model_of(grid(80, 40, -200, 200, -100, 100, [](double, double) { return 0.0; }));
    std::vector<int> vertices;
    for (int i = 16; i <= 64; ++i) {
        vertices.push_back(20 * 81 + i);
    }
    const FeatureLine line = line_of(model, vertices);
    std::vector<Vec3> displacements;
    for (size_t i = 0; i < vertices.size(); ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(vertices.size() - 1);
        displacements.push_back(Vec3(0, 20 * x * x, 0));
    }
    return extend_line(model, whole_mesh_region(model.mesh), sends(model, line, displacements)).value();
}

double middle(const ExtendedLine& line, size_t i)
{
    return 0.5 * (line.model.mesh.V(line.vertices[i], 0) + line.model.mesh.V(line.vertices[i + 1], 0));
}

} // namespace

TEST(RunOut, IsASmoothStepAsLongOnBothSidesOfAnEndAsItMoves)
{
    const ExtendedLine line = moved_at_one_end();
    const double way = line.model.mesh.V(line.vertices[line.last], 0) > 0 ? 1 : -1;
    for (const double angle : {20.0, -5.0, 2.5, 0.0}) {
        const double length = 20 * std::min(1.0, std::abs(angle) / 5);
        const std::vector<double> angles(line.vertices.size() - 1, angle);
        const std::vector<RunOut> runs = run_out(line, angles, 5);
        for (size_t i = 0; i < runs.size(); ++i) {
            const double x = way * middle(line, i), s = (x - 120) / length;
            const bool used = std::abs(x) < 120;
            EXPECT_EQ(runs[i].after, x > 0) << x;
            if (length > 0 && std::abs(s) < 1) {
                EXPECT_NEAR(runs[i].left, 0.5 - 0.75 * s + 0.25 * s * s * s, 1e-9) << x;
            } else {
                EXPECT_EQ(runs[i].left, used ? -1 : 0) << x;
            }
        }
    }
}
