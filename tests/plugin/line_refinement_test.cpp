// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/line_refinement.h"
#include "tests/plugin/run_command.h"
#include "tests/support/moves.h"

#include <gtest/gtest.h>

namespace tapeline::testing {
namespace {

TEST(LineRefinement, HalvesLongEdgesAndKeepsOldVerticesAndTheLine)
{
    const Model model = model_of(flat_roof(4, 4));
    const FeatureLine line = line_of(model, crease_panel_line(4, 4));
    const auto refined = refine_line(model, line, 300);
    ASSERT_TRUE(refined) << refined.error().message;
    // Edges of 1000 mm are halved twice.
    EXPECT_EQ(refined->line.vertices.size(), 17U);
    EXPECT_NEAR(refined->line.length_mm, line.length_mm, 1e-9);
    EXPECT_LE(longest_edge(refined->model.mesh, refined->line), 300);
    EXPECT_EQ(refined->line.vertices.front(), line.vertices.front());
    EXPECT_EQ(refined->line.vertices.back(), line.vertices.back());
    EXPECT_EQ(refined->model.mesh.V.topRows(model.mesh.V.rows()), model.mesh.V);
}

TEST(LineRefinement, LeavesAFineLineAlone)
{
    const Model model = model_of(flat_roof(4, 4));
    const FeatureLine line = line_of(model, crease_panel_line(4, 4));
    const auto refined = refine_line(model, line, 1000.5);
    ASSERT_TRUE(refined) << refined.error().message;
    EXPECT_EQ(refined->line.vertices, line.vertices);
    EXPECT_EQ(refined->model.mesh.F, model.mesh.F);
}

/// The bracket's straight edges are single edges of its tessellation.
TEST(LineRefinement, LetsAPartOfAStraightCadEdgeMove)
{
    const TemporaryFolder folder;
    const CommandRun run = run_tapeline({"move", TAPELINE_SOURCE_DIR "/resources/models/bracket.step", "--line",
                                         "5@20%..80%", "--slide", "0,0.5,1.5,2,1.5,0.5,0", "--roi-distance", "12", "-o",
                                         (folder / "moved.obj").string(), "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
}

} // namespace
} // namespace tapeline::testing
