// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing meshes against what the machine can do at best: moving the same bytes through the file system.
#include "io/file_content.h"
#include "io/model_file.h"
#include "tests/benchmarks/seconds.h"
#include "tests/support/files.h"
#include "tests/support/shapes.h"

#include <benchmark/benchmark.h>
#include <filesystem>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// The counter "raw_ratio" is our time over that of reading the file's bytes alone.
void read_against_bytes(benchmark::State& state, const char* name)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / name;
    if (!write_mesh(path, crease_panel(200, 150))) {
        state.SkipWithError("cannot write");
        return;
    }
    double ours = 0, bytes = 0;
    for (auto _ : state) {
        ours += seconds_of([&] { benchmark::DoNotOptimize(read_mesh(path)->model.mesh.V.data()); });
        bytes += seconds_of([&] { benchmark::DoNotOptimize(read_text(path).data()); });
    }
    state.counters["raw_ratio"] = ours / bytes;
    state.counters["MB_per_s"] =
        static_cast<double>(std::filesystem::file_size(path)) * static_cast<double>(state.iterations()) / ours / 1e6;
}
BENCHMARK_CAPTURE(read_against_bytes, stl, "panel.stl")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_against_bytes, obj, "panel.obj")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_against_bytes, ply, "panel.ply")->Unit(benchmark::kMillisecond);

} // namespace
