// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/compare_outputs.h"

#include "io/model_file.h"
#include "plugin/runner/html_report.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/output_set.h"
#include "plugin/runner/stats.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tapeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr PictureSize small{560, 420, false, false};
constexpr int comb_stations = 3;

std::string mesh_name(const std::string& method) { return method + ".obj"; }

const char* state_word(const MethodRun& run)
{
    if (!run.move) {
        return "failed";
    }
    return !run.failure ? "done" : (run.move->converged() ? "ambiguous" : "not_converged");
}

/// What the page's table says in its second column.
std::string verdict(const MethodRun& run)
{
    if (run.failure) {
        return !run.move ? "failed" : (run.move->converged() ? "ambiguous" : "not converged");
    }
    const auto missed = std::ranges::count_if(run.gates, [](const GateResult& gate) { return !gate.passed; });
    return run.gates.empty() ? "converged"
           : missed == 0     ? "keeps all limits"
                             : fmt::format("misses {} limit{}", missed, missed == 1 ? "" : "s");
}

std::string missed_limits(const MethodRun& run)
{
    std::vector<std::string> missed;
    for (const GateResult& gate : run.gates) {
        if (!gate.passed) {
            missed.push_back(fmt::format("{}: {} (limit {:g})", gate.name,
                                         gate.value ? fmt::format("{:.3g}", *gate.value) : "not measured", gate.limit));
        }
    }
    return fmt::format("{}", fmt::join(missed, "; "));
}

ordered_json run_json(const MethodRun& run, const std::vector<int>& ranking, int index)
{
    const auto place = std::ranges::find(ranking, index);
    ordered_json json = {
        {"method", run.method},
        {"state", state_word(run)},
        {"reason", run.failure ? ordered_json(run.failure->message) : ordered_json(nullptr)},
        {"rank", place == ranking.end() ? ordered_json(nullptr) : ordered_json(place - ranking.begin() + 1)},
        {"mesh", run.move ? ordered_json(mesh_name(run.method)) : ordered_json(nullptr)}};
    if (run.move) {
        json["placement"] = placement_json(run.move->placement);
        json["retraction"] = retraction_json(run.move->retraction);
        json["solve"] = solve_json(run.move->solves);
        json["uniqueness"] = uniqueness_json(*run.move);
        json["quality"] = measures_json(run.measures);
        json["inner_lines"] = inner_lines_json(run.inner_lines);
        json["gates"] = gates_json(run.gates);
        json["warnings"] = run.move->warnings;
    } else {
        for (const char* key :
             {"placement", "retraction", "solve", "uniqueness", "quality", "inner_lines", "gates", "warnings"}) {
            json[key] = nullptr;
        }
    }
    json["seconds"] = run.seconds;
    return json;
}

/// Entries in the order of the page: ranked ones, then the others.
std::vector<int> page_order(const Comparison& c)
{
    std::vector<int> order = c.ranking;
    for (const bool with_result : {true, false}) {
        for (int k = 0; k < static_cast<int>(c.runs.size()); ++k) {
            if (!c.runs[k].sound() && c.runs[k].move.has_value() == with_result) {
                order.push_back(k);
            }
        }
    }
    return order;
}

/// Draws everything for the page; the run's pictures get its name.
class Painter {
public:
    Painter(const Comparison& comparison, Progress progress)
        : c_(comparison), target_(comparison.preparation.target->line), progress_(std::move(progress))
    {
    }

    Result<void> paint(Page& page, const Stage& stage, const std::vector<int>& order)
    {
        for (std::size_t e = 0; e < order.size(); ++e) {
            const MethodRun& run = c_.runs[order[e]];
            if (!run.move) {
                continue;
            }
            if (!progress_.report(static_cast<double>(e) / static_cast<double>(order.size()), "pictures")) {
                return fail(ErrorKind::cancelled, "cancelled");
            }
            if (page.before.empty()) {
                auto before = draw_state(*run.move, target_, false, stage, small);
                if (!before) {
                    return tl::unexpected(before.error());
                }
                page.before = std::move(*before);
            }
            auto after = draw_state(*run.move, target_, true, stage, small);
            if (!after) {
                return tl::unexpected(after.error());
            }
            page.entries[e].pictures = std::move(*after);
            auto sections = draw_section_panels(*run.move, target_, comb_stations);
            if (!sections) {
                return tl::unexpected(sections.error());
            }
            page.entries[e].sections = std::move(*sections);
        }
        return {};
    }

private:
    const Comparison& c_;
    const TargetCurve& target_;
    Progress progress_;
};

Page make_page(const Job& job, const Comparison& c, const std::vector<int>& order)
{
    Page page;
    page.title = fmt::format("{}: {} methods compared", model_name(job), c.runs.size());
    page.headline = comparison_headline(c.runs, c.ranking);
    page.description = job.description;
    for (const int k : order) {
        const MethodRun& run = c.runs[k];
        PageEntry entry;
        entry.name = run.method;
        entry.title = method_title(run.method);
        entry.move = run.move ? &*run.move : nullptr;
        entry.measures = &run.measures;
        entry.inner_lines = run.inner_lines;
        entry.verdict = verdict(run);
        entry.missed = missed_limits(run);
        entry.reason = run.failure ? run.failure->message : "";
        entry.sound = run.sound();
        entry.seconds = run.seconds;
        page.entries.push_back(std::move(entry));
    }
    const auto* with_result = order.empty() ? nullptr : page.entries.front().move;
    page.facts = job_facts(job, c.preparation, with_result);
    page.warnings = c.warnings;
    page.notes = reading_notes();
    page.notes.push_back(
        fmt::format("Methods that keep all limits come first; then they are ranked by flips, by bulge, "
                    "where less than 0.1 % of the slide is no difference, by new inflections and by "
                    "squash. Time: {} thread{} a method.",
                    c.threads_per_method, c.threads_per_method == 1 ? "" : "s"));
    page.target = &c.preparation.target->line;
    page.footer = fmt::format("tapeline {}, input SHA-256 {}", version(), c.input_sha256);
    return page;
}

void add_pictures(OutputSet& outputs, const fs::path& folder, const Page& page)
{
    const auto add = [&](const std::string& prefix, const Picture& picture) {
        const std::size_t word = picture.name.find('_');
        const std::string kind = word == std::string::npos ? picture.name : picture.name.substr(word + 1);
        outputs.add_text(folder / "pictures" / fmt::format("{}_{}", prefix, kind), picture.png);
    };
    for (const Picture& picture : page.before) {
        add("before", picture);
    }
    for (const PageEntry& entry : page.entries) {
        for (const Picture& picture : entry.pictures) {
            add(entry.name, picture);
        }
        if (entry.sections) {
            add(entry.name, *entry.sections);
        }
    }
}

} // namespace

Result<void> check_compare_outputs(const Job& job)
{
    const fs::path& folder = job.command.out_folder;
    std::error_code error;
    if (folder.empty() || (fs::exists(folder, error) && !fs::is_directory(folder, error))) {
        return fail(ErrorKind::usage, fmt::format("the output {} is no folder; give the name of one", folder.string()));
    }
    return compared_methods(job).and_then([&](const std::vector<std::string>& methods) {
        OutputSet names;
        names.add_text(folder / "compare.html", {});
        names.add_text(folder / "compare.json", {});
        for (const std::string& method : methods) {
            names.add_text(folder / mesh_name(method), {});
        }
        return names.check(job.input).and_then([&] { return names.check(job.command.job); });
    });
}

std::string compare_json(const Job& job, const Comparison& c)
{
    ordered_json json;
    json["tool_version"] = version();
    json["description"] = job.description;
    json["input"] = {{"path", job.input.string()},
                     {"sha256", c.input_sha256},
                     {"units", c.preparation.import.units},
                     {"vertices", c.preparation.import.vertices},
                     {"faces", c.preparation.import.faces}};
    json["line"] = {{"id", c.preparation.line.id},
                    {"length_mm", c.preparation.line.length_mm},
                    {"crease_angle_mean", c.preparation.line.crease_angle_mean}};
    json["region"] = {{"vertices", c.preparation.region.vertices.size()},
                      {"faces", c.preparation.region.faces.size()},
                      {"distance_mm", c.preparation.region.distance_mm}};
    json["headline"] = comparison_headline(c.runs, c.ranking);
    json["winner"] = c.ranking.empty() ? ordered_json(nullptr) : ordered_json(c.runs[c.ranking.front()].method);
    json["threads_per_method"] = c.threads_per_method;
    json["methods"] = ordered_json::array();
    for (std::size_t k = 0; k < c.runs.size(); ++k) {
        json["methods"].push_back(run_json(c.runs[k], c.ranking, static_cast<int>(k)));
    }
    json["warnings"] = c.warnings;
    for (const auto& [stage, seconds] : c.seconds) {
        json["seconds"][stage] = seconds;
    }
    return json_text(json);
}

Result<void> write_comparison(const Job& job, Comparison& c, const Progress& progress)
{
    Stopwatch watch;
    const std::vector<int> order = page_order(c);
    Page page = make_page(job, c, order);
    Stage stage;
    if (!order.empty() && page.entries.front().move != nullptr) {
        const Preparation& p = c.preparation;
        stage = make_stage(p.model.mesh, p.region, *page.entries.front().move, p.target->line);
        page.stage = &stage;
    }
    if (auto painted = Painter(c, progress.part(0.0, 0.8)).paint(page, stage, order); !painted) {
        return painted;
    }
    watch.lap("pictures");
    c.seconds.insert(c.seconds.end(), watch.seconds().begin(), watch.seconds().end());
    const fs::path& folder = job.command.out_folder;
    OutputSet outputs;
    outputs.add_text(folder / "compare.html", page_html(page));
    outputs.add_text(folder / "compare.json", compare_json(job, c));
    const ExportOptions options{job.outputs.ascii, unit_length_mm(job.import.units)};
    for (const MethodRun& run : c.runs) {
        if (run.move) {
            outputs.add(folder / mesh_name(run.method), [&run, options](const fs::path& path) {
                return write_mesh(path, Mesh{run.move->V, run.move->rest.mesh.F}, options);
            });
        }
    }
    add_pictures(outputs, folder, page);
    if (!progress.report(0.9, "write")) {
        return fail(ErrorKind::cancelled, "cancelled");
    }
    return outputs.commit();
}

} // namespace tapeline
