// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/job_outputs.h"

#include "io/model_file.h"
#include "io/target_file.h"
#include "plugin/runner/html_report.h"
#include "plugin/runner/job_file.h"
#include "plugin/runner/output_set.h"
#include "plugin/runner/pictures.h"
#include "plugin/runner/stats.h"
#include "plugin/runner/vertex_list.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tapeline {

namespace {

namespace fs = std::filesystem;

Result<void> check_ending(const fs::path& path, std::initializer_list<const char*> endings, const char* what)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (std::ranges::find(endings, ending) == endings.end()) {
        return fail(ErrorKind::usage, fmt::format("cannot tell the {} format of {}; end its name with one of {}", what,
                                                  path.string(), fmt::join(endings, ", ")));
    }
    return {};
}

constexpr std::array<const char*, 9> picture_names = {
    "before_shaded.png",   "after_shaded.png",   "before_zebra.png",  "after_zebra.png", "before_curvature.png",
    "after_curvature.png", "before_closeup.png", "after_closeup.png", "sections.png"};

ExportOptions export_options(const Job& job) { return {job.outputs.ascii, unit_length_mm(job.import.units)}; }

void add_meshes(OutputSet& outputs, const Job& job, const MoveResult& move)
{
    // Meshes of CAD models are written in mm, meshes of mesh files in the unit that they came in.
    const ExportOptions options = export_options(job);
    const auto add = [&](const fs::path& goal, const Positions& V) {
        outputs.add(goal, [options, V, F = move.rest.mesh.F](const fs::path& path) {
            return write_mesh(path, Mesh{V, F}, options);
        });
    };
    for (const fs::path& goal : job.outputs.out) {
        add(goal, move.V);
    }
    if (!job.outputs.rest.empty()) {
        add(job.outputs.rest, move.rest.mesh.V);
    }
}

} // namespace

Result<void> check_mesh_name(const fs::path& path)
{
    return check_ending(path, {".obj", ".stl", ".ply", ".off"}, "mesh");
}

Result<void> check_target_name(const fs::path& path)
{
    return check_ending(path, {".json", ".step", ".stp", ".iges", ".igs", ".brep", ".csv"}, "target line");
}

Result<void> check_outputs(const Job& job)
{
    if (job.outputs.out.empty()) {
        return fail(ErrorKind::usage, "no output is named: give -o FILE (the job key outputs.out)");
    }
    return check_output_names(job);
}

Result<void> check_output_names(const Job& job)
{
    const OutputSettings& o = job.outputs;
    std::vector<fs::path> meshes = o.out;
    meshes.push_back(o.rest);
    OutputSet names;
    for (const fs::path& path : meshes) {
        if (path.empty()) {
            continue;
        }
        if (auto fine = check_mesh_name(path); !fine) {
            return fine;
        }
        names.add_text(path, {});
    }
    if (!o.save_target.empty()) {
        if (auto fine = check_target_name(o.save_target); !fine) {
            return fine;
        }
    }
    for (const fs::path& path : {o.stats, o.report, o.line_vertices, o.save_target, job.command.save_job}) {
        if (!path.empty()) {
            names.add_text(path, {});
        }
    }
    for (const char* name : picture_names) {
        if (!o.pictures.empty()) {
            names.add_text(o.pictures / name, {});
        }
    }
    return names.check(job.input);
}

Result<void> write_outputs(const Job& job, JobOutcome& outcome, Stopwatch& watch, const Progress& progress)
{
    const OutputSettings& o = job.outputs;
    OutputSet outputs;
    add_meshes(outputs, job, outcome.move);
    const TargetLine& target = outcome.preparation.target->line;
    if (!o.save_target.empty()) {
        outputs.add(o.save_target, [&](const fs::path& path) { return write_target(path, target); });
    }
    std::vector<Picture> pictures;
    Stage stage;
    if (!o.pictures.empty() || !o.report.empty()) {
        if (!progress.report(0, "pictures")) {
            return fail(ErrorKind::cancelled, "cancelled");
        }
        const Preparation& p = outcome.preparation;
        stage = make_stage(p.model.mesh, p.region, outcome.move, target);
        Result<std::vector<Picture>> drawn = draw_move(outcome.move, target, stage);
        if (!drawn) {
            return tl::unexpected(drawn.error());
        }
        pictures = std::move(*drawn);
        watch.lap("pictures");
    }
    outcome.seconds = watch.seconds();
    for (const Picture& picture : pictures) {
        if (!o.pictures.empty()) {
            outputs.add_text(o.pictures / picture.name, picture.png);
        }
    }
    const auto add_text = [&](const fs::path& goal, const auto& make) {
        if (!goal.empty()) {
            outputs.add_text(goal, make());
        }
    };
    add_text(o.line_vertices, [&] { return vertex_list_text(outcome.move.correspondence.line); });
    add_text(o.report, [&] { return html_report(job, outcome, pictures, stage); });
    add_text(job.command.save_job, [&] { return job_text(job, job.command.save_job.parent_path()); });
    add_text(o.stats, [&] { return stats_text(job, outcome); });
    if (!progress.report(0.8, "write")) {
        return fail(ErrorKind::cancelled, "cancelled");
    }
    return outputs.commit().map([&] { watch.lap("write"); });
}

} // namespace tapeline
