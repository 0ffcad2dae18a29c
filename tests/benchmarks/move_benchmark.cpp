// SPDX-License-Identifier: GPL-3.0-or-later
// Whole moves against each other in the same run: the plate against the method as published, a preview of a dragged
// target against the solve that it stands for. A counter "..._ratio" above 1 says that the first one is faster.
#include "bspline/slide.h"
#include "plugin/runner/editor.h"
#include "plugin/runner/target_choice.h"
#include "tests/benchmarks/seconds.h"
#include "tests/support/moves.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <limits>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// Both methods to an error of 0.05 mm on the crease-slide panel, all of it in the region.
void plate_against_asan(benchmark::State& state)
{
    const int nx = static_cast<int>(state.range(0)), ny = static_cast<int>(state.range(1));
    const Model model = model_of(crease_panel(nx, ny));
    const FeatureLine line = line_of(model, crease_panel_line(nx, ny));
    const ParametricCurve target = crease_slide_target(60);
    const Region region = whole_model(model);
    MoveOptions options;
    options.tolerance_mm = 0.05;
    bool converged = true;
    const auto seconds = [&](Method method) {
        options.method = method;
        return seconds_of([&] {
            const auto moved = move_feature_line(model, line, target, region, options);
            converged = converged && moved && moved->converged() && moved->error_estimate_mm() <= options.tolerance_mm;
        });
    };
    double plate = std::numeric_limits<double>::infinity(), asan = plate;
    for (auto _ : state) {
        asan = std::min(asan, seconds(Method::asan_fl));
        plate = std::min(plate, seconds(Method::plate_fl));
    }
    if (!converged) {
        state.SkipWithError("a method did not reach 0.05 mm");
        return;
    }
    state.counters["region_vertices"] = static_cast<double>(region.vertices.size());
    state.counters["plate_s"] = plate;
    state.counters["asan_s"] = asan;
    state.counters["asan_ratio"] = asan / plate;
}
BENCHMARK(plate_against_asan)->Name("plate_against_asan/small")->Args({64, 48})->Unit(benchmark::kMillisecond);
BENCHMARK(plate_against_asan)->Name("plate_against_asan/large")->Args({258, 192})->Unit(benchmark::kMillisecond);

/// Previews of a line dragged on, positions alone and with the strip of measures, against the plate-fl solve of the
/// same target. Least times of the run, since others may use the machine.
void preview_against_solve(benchmark::State& state)
{
    const int nx = static_cast<int>(state.range(0));
    const auto model = *hold_mesh(crease_panel(nx, nx * 3 / 4), {});
    const HeldLine line = *held_part(*model, held_lines(*model, {}).front(), "20%", "80%");
    Job job;
    job.region.roi_distance = 260;
    JobInputs inputs = use_held(job, model, line, {});
    const TargetLine fitted = make_target(model->imported.model, line.line, {})->line;
    const auto slid = [&](double mm) {
        return *slide_on_surface(fitted, model->imported.model.mesh, {{{0, 0}, {0.5, mm}, {1, 0}}});
    };
    const std::vector<TargetLine> targets = {slid(5), slid(10), slid(15)};
    Editor editor(job, inputs);
    if (!editor.start(targets.front())) {
        state.SkipWithError("the preview could not be prepared");
        return;
    }
    double positions = std::numeric_limits<double>::infinity(), strip = positions, solve = positions;
    for (auto _ : state) {
        for (const TargetLine& target : targets) {
            positions = std::min(positions, seconds_of([&] { benchmark::DoNotOptimize(editor.preview(target, 0)); }));
            strip = std::min(strip, seconds_of([&] { benchmark::DoNotOptimize(editor.preview(target, 1e6)); }));
        }
        inputs.target = targets.back();
        solve = std::min(solve, seconds_of([&] {
                             const auto solved = solve_job(job, inputs);
                             state.counters["region_vertices"] =
                                 solved ? static_cast<double>(solved->move.region.vertices.size()) : 0;
                         }));
    }
    state.counters["positions_ms"] = 1e3 * positions;
    state.counters["with_strip_ms"] = 1e3 * strip;
    state.counters["solve_ms"] = 1e3 * solve;
    state.counters["solve_ratio"] = solve / strip;
}
BENCHMARK(preview_against_solve)->Name("preview_against_solve/small")->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(preview_against_solve)->Name("preview_against_solve/large")->Arg(128)->Unit(benchmark::kMillisecond);

} // namespace
