// SPDX-License-Identifier: GPL-3.0-or-later
// The editor behind the live faces: quick previews, exact results.
#include "bspline/slide.h"
#include "plugin/runner/editor.h"
#include "plugin/runner/target_choice.h"
#include "tests/plugin/run_command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

/// The crease panel held in memory, its line and a job that moves the middle of it.
struct Bench {
    std::shared_ptr<const HeldModel> model;
    HeldLine line;
    Job job;
    JobInputs inputs;
    std::optional<TargetLine> fitted;

    explicit Bench(const std::string& method = "asan-fl")
    {
        write_panel(folder.path() / "panel.obj", 32, 24);
        model = *hold_model(folder.path() / "panel.obj", {});
        line = *held_part(*model, held_lines(*model, {}).front(), "20%", "80%");
        job.move.method = method;
        job.region.roi_distance = 210;
        inputs = use_held(job, model, line, {});
        fitted = make_target(model->imported.model, line.line, {})->line;
    }

    /// The line slid by so much in its middle.
    TargetLine slid(double mm) const
    {
        return *slide_on_surface(*fitted, model->imported.model.mesh, {{{0, 0}, {0.5, mm}, {1, 0}}});
    }

    TemporaryFolder folder;
};

TEST(Editor, SolvesToTheBitAsAJobDoesAfterAnyDrag)
{
    for (const char* method : {"asan-fl", "plate-fl", "arap"}) {
        const Bench bench(method);
        Editor editor(bench.job, bench.inputs);
        for (const double mm : {8.0, -12.0}) {
            ASSERT_TRUE(editor.preview(bench.slid(mm / 2)));
            const auto solved = editor.solve(bench.slid(mm));
            ASSERT_TRUE(solved) << solved.error().message;
            JobInputs inputs = bench.inputs;
            inputs.target = bench.slid(mm);
            const auto job = solve_job(bench.job, inputs);
            ASSERT_TRUE(job);
            EXPECT_EQ((*solved)->move.V, job->move.V) << method;
            EXPECT_EQ((*solved)->move.rest.mesh.F, job->move.rest.mesh.F) << method;
        }
    }
}

TEST(Editor, ShowsTheRestShapeWhereTheTargetIsTheFittedLineItself)
{
    const Bench bench;
    Editor editor(bench.job, bench.inputs);
    const auto preview = editor.preview(*bench.fitted, 1e6);
    ASSERT_TRUE(preview) << preview.error().message;
    // The fit misses the line a little; nothing moves by more than its vertices do.
    EXPECT_LT(preview->placement.u_max_mm, 1e-3);
    EXPECT_LE((preview->V - preview->rest->V).rowwise().norm().maxCoeff(), preview->placement.u_max_mm + 1e-9);
    EXPECT_EQ(preview->flipped, 0);
}

TEST(Editor, MovesNothingOutsideTheRegionInAPreview)
{
    const Bench bench;
    Editor editor(bench.job, bench.inputs);
    const auto preview = editor.preview(bench.slid(20), 1e6);
    ASSERT_TRUE(preview) << preview.error().message;
    std::vector<char> inside(preview->V.rows(), 0);
    for (const auto* faces : {&preview->parts.compressed, &preview->parts.tension}) {
        for (const int t : *faces) {
            for (const int v : preview->rest->F.row(t)) {
                inside[v] = 1;
            }
        }
    }
    int outside = 0;
    for (int v = 0; v < preview->V.rows(); ++v) {
        if (!inside[v]) {
            ++outside;
            EXPECT_EQ(preview->V.row(v), preview->rest->V.row(v));
        }
    }
    EXPECT_GT(outside, 100);
}

TEST(Editor, LeavesMeasuresOutWhereTheBudgetIsSpent)
{
    const Bench bench;
    Editor editor(bench.job, bench.inputs);
    ASSERT_TRUE(editor.start(bench.slid(5)));
    const auto late = editor.preview(bench.slid(6), 0);
    const auto timely = editor.preview(bench.slid(6), 1e6);
    ASSERT_TRUE(late && timely);
    EXPECT_FALSE(late->strip);
    ASSERT_TRUE(timely->strip);
    EXPECT_LT(timely->strip->line_error_max_mm, 1e-9);
    EXPECT_EQ(late->V, timely->V);
}

TEST(Editor, MeasuresAPreviewOfACadModelFromItsFaces)
{
    Job job;
    const auto model = *hold_model(TAPELINE_SOURCE_DIR "/resources/models/hood.step", {});
    const HeldLine line = *held_part(*model, held_lines(*model, {}).front(), "20%", "80%");
    job.region.roi_distance = 250;
    job.remesh.max_edge = 25;
    const JobInputs inputs = use_held(job, model, line, {});
    const TargetLine fitted = make_target(model->imported.model, line.line, {})->line;
    const auto target = slide_on_surface(fitted, model->imported.model.mesh, {{{0, 0}, {0.5, 20}, {1, 0}}});
    ASSERT_TRUE(target);
    Editor editor(job, inputs);
    ASSERT_TRUE(editor.start(*target, {}));
    const auto preview = editor.preview(*target, 60000, {});
    ASSERT_TRUE(preview) << preview.error().message;
    const auto bulge = strip_json(*preview)["bulge"];
    EXPECT_EQ(bulge["reference"], "exact");
    EXPECT_GT(std::abs(bulge["max_mm"].get<double>()), 0);
    EXPECT_LT(std::abs(bulge["max_mm"].get<double>()), 0.5); // the target was slid over coarse triangles
}

TEST(Editor, FailsAsAMoveDoesAndGoesOn)
{
    const Bench bench;
    Editor editor(bench.job, bench.inputs);
    const Progress never([](double, std::string_view) { return false; });
    const auto cancelled = editor.solve(bench.slid(5), never);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::cancelled);
    EXPECT_TRUE(editor.preview(bench.slid(5)));
}

} // namespace
} // namespace tapeline::testing
