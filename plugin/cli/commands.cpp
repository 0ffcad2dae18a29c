// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/cli/commands.h"

#include "io/model_file.h"
#include "io/target_file.h"
#include "kernel/remesh.h"
#include "plugin/runner/check.h"
#include "plugin/runner/compare_outputs.h"
#include "plugin/runner/guard.h"
#include "plugin/runner/job_file.h"
#include "plugin/runner/job_outputs.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/output_set.h"
#include "plugin/runner/pictures.h"
#include "plugin/runner/stats.h"
#include "plugin/runner/vertex_list.h"

#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Writes the outputs, a JSON file among them, then prints the table, or the JSON where standard output was asked for.
Result<void> answer(Console& console, OutputSet& outputs, const Job& job, const std::string& json,
                    const std::string& table)
{
    const bool json_out = job.command.json == "-";
    if (!job.command.json.empty() && !json_out) {
        outputs.add_text(job.command.json, json);
    }
    return outputs.check(job.input).and_then([&] { return outputs.commit(); }).map([&] {
        console.print(json_out ? json : table);
    });
}

Result<ImportedModel> read_input(const Job& job, const Progress& progress)
{
    if (!progress.report(0, "import")) {
        return fail(ErrorKind::cancelled, "cancelled");
    }
    auto model = read_model(job.input, import_options(job.import));
    if (model && !progress.report(0.5, "import")) {
        return fail(ErrorKind::cancelled, "cancelled");
    }
    return model;
}

/// Remeshes the whole model; the report then counts the new triangles.
Result<void> remesh_all(ImportedModel& imported, double max_edge, Console& console)
{
    std::vector<int> faces(imported.model.mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    RemeshOptions options;
    options.max_edge_mm = max_edge;
    return remesh_region(imported.model, faces, options).map([&](RemeshResult remeshed) {
        imported.model = std::move(remeshed.model);
        imported.report.vertices = static_cast<int>(imported.model.mesh.V.rows());
        imported.report.faces = static_cast<int>(imported.model.mesh.F.rows());
        console.warn(remeshed.warnings);
    });
}

Result<void> run_mesh(const Job& job, Console& console)
{
    OutputSet outputs;
    const ExportOptions options{job.outputs.ascii, unit_length_mm(job.import.units)};
    Result<ImportedModel> imported = fail(ErrorKind::usage, "");
    for (const fs::path& path : job.outputs.out) {
        if (auto fine = check_mesh_name(path); !fine) {
            return fine;
        }
        outputs.add(path, [&](const fs::path& file) { return write_mesh(file, imported->model.mesh, options); });
    }
    return outputs.check(job.input)
        .and_then([&]() -> Result<void> {
            imported = read_input(job, console.progress());
            return imported ? Result<void>() : tl::unexpected(imported.error());
        })
        .and_then([&] {
            console.warn(imported->report.warnings);
            return job.remesh.max_edge > 0 ? remesh_all(*imported, job.remesh.max_edge, console) : Result<void>();
        })
        .and_then([&] {
            return answer(console, outputs, job, json_text(import_json(imported->report)),
                          import_table(imported->report));
        });
}

ordered_json lines_json(const std::vector<FeatureLine>& lines)
{
    ordered_json list = ordered_json::array();
    for (const FeatureLine& line : lines) {
        list.push_back({{"id", line.id},
                        {"vertices", line.vertices},
                        {"closed", line.closed},
                        {"length_mm", line.length_mm},
                        {"crease_angle_mean", line.crease_angle_mean},
                        {"crease_angle_min", line.crease_angle_min},
                        {"crease_angle_max", line.crease_angle_max},
                        {"cad_edges", line.cad_edges}});
    }
    return {{"lines", list}};
}

std::string lines_table(const std::vector<FeatureLine>& lines)
{
    std::vector<std::vector<std::string>> rows = {
        {"line", "length [mm]", "crease mean [deg]", "min", "max", "vertices", "closed"}};
    for (const FeatureLine& line : lines) {
        rows.push_back({std::to_string(line.id), fmt::format("{:.6g}", line.length_mm),
                        fmt::format("{:.3f}", line.crease_angle_mean), fmt::format("{:.3f}", line.crease_angle_min),
                        fmt::format("{:.3f}", line.crease_angle_max), std::to_string(line.vertices.size()),
                        line.closed ? "yes" : "no"});
    }
    return text_table(rows);
}

Result<void> run_lines(const Job& job, Console& console)
{
    OutputSet outputs;
    return read_input(job, console.progress()).and_then([&](const ImportedModel& imported) {
        console.warn(imported.report.warnings);
        const std::vector<FeatureLine> lines = find_feature_lines(imported.model, line_options(job.lines));
        if (!job.command.picture.empty()) {
            outputs.add(job.command.picture,
                        [&](const fs::path& path) { return draw_lines(path, imported.model.mesh, lines); });
        }
        if (lines.empty()) {
            console.warn({fmt::format("{} has no feature line of {} deg or more; --crease-angle sets the limit",
                                      job.input.string(), job.lines.crease_angle)});
        }
        return answer(console, outputs, job, json_text(lines_json(lines)), lines_table(lines));
    });
}

std::string target_table(const TargetChoice& target)
{
    const BSplineData data = target.line.data();
    return text_table({{"control points", std::to_string(data.control_points.size())},
                       {"degree", std::to_string(data.degree)},
                       {"closed", data.closed ? "yes" : "no"},
                       {"length", fmt::format("{:.6g} mm", target.line.length())},
                       {"largest distance of the line to its fit", fmt::format("{:.3g} mm", target.fit_error_mm)}});
}

Result<void> run_target(const Job& job, Console& console)
{
    if (auto fine = check_target_name(job.command.out_target); !fine) {
        return fine;
    }
    OutputSet outputs;
    Stopwatch watch;
    return prepare_target(job, watch, console.progress()).and_then([&](const Preparation& made) {
        for (const auto* warnings : {&made.import.warnings, &made.warnings, &made.target->warnings}) {
            console.warn(*warnings);
        }
        outputs.add(job.command.out_target,
                    [&](const fs::path& path) { return write_target(path, made.target->line); });
        return outputs.check(job.input).and_then([&] { return outputs.commit(); }).map([&] {
            console.print(target_table(*made.target));
        });
    });
}

Result<void> gates_passed(const std::vector<GateResult>& gates)
{
    if (const auto missed = gate_failure(gates)) {
        return tl::unexpected(*missed);
    }
    return {};
}

Result<void> run_move(const Job& job, Console& console)
{
    return run_job(job, console.progress()).and_then([&](const JobOutcome& outcome) {
        console.warn(outcome.warnings);
        console.print(outcome_table(outcome));
        return gates_passed(outcome.gates);
    });
}

Result<void> run_job_file(const Job& job, Console& console)
{
    return read_job(job.command.job).and_then([&](Job read) {
        read.command = job.command;
        if (read.input.empty()) {
            return Result<void>(fail(ErrorKind::usage, fmt::format("{}: key 'input' is missing; name the model file",
                                                                   job.command.job.string())));
        }
        return run_move(read, console);
    });
}

Result<void> run_compare(const Job& job, Console& console)
{
    return read_job(job.command.job).and_then([&](Job read) -> Result<void> {
        read.command = job.command;
        read.move.check_unique = read.move.check_unique || job.move.check_unique;
        if (read.input.empty()) {
            return fail(ErrorKind::usage,
                        fmt::format("{}: key 'input' is missing; name the model file", job.command.job.string()));
        }
        const Progress progress = console.progress();
        return check_compare_outputs(read)
            .and_then([&] { return compare_methods(read, progress.part(0.0, 0.7)); })
            .and_then([&](Comparison comparison) {
                return write_comparison(read, comparison, progress.part(0.7, 1.0)).and_then([&]() -> Result<void> {
                    console.warn(comparison.warnings);
                    console.print(comparison_table(comparison));
                    if (comparison.ranking.empty()) {
                        return fail(comparison.runs.front().failure->kind,
                                    "no method gave a result that can be ranked");
                    }
                    return {};
                });
            });
    });
}

Result<void> run_check(const Job& job, Console& console)
{
    OutputSet outputs;
    return check_result(job, console.progress()).and_then([&](const CheckOutcome& outcome) {
        console.warn(outcome.warnings);
        console.warn(outcome.measures.omitted);
        return answer(console, outputs, job, check_json(outcome), measures_table(outcome.measures)).and_then([&] {
            return gates_passed(outcome.gates);
        });
    });
}

Result<void> run(const Invocation& invocation, Console& console)
{
    switch (invocation.command) {
    case mesh_command:
        return run_mesh(invocation.job, console);
    case lines_command:
        return run_lines(invocation.job, console);
    case target_command:
        return run_target(invocation.job, console);
    case move_command:
        return run_move(invocation.job, console);
    case check_command:
        return run_check(invocation.job, console);
    case compare_command:
        return run_compare(invocation.job, console);
    default:
        return run_job_file(invocation.job, console);
    }
}

} // namespace

Result<void> run_invocation(const Invocation& invocation, Console& console)
{
    return guarded([&] { return run(invocation, console); });
}

} // namespace tapeline
