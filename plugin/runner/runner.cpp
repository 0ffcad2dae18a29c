// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/runner.h"

#include "kernel/rim.h"
#include "plugin/runner/guard.h"
#include "plugin/runner/job_outputs.h"
#include "plugin/runner/sha256.h"
#include "plugin/runner/strips.h"

#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// The option that a text names, or none for "auto".
template <class T>
std::optional<T> named(const std::string& text, std::initializer_list<std::pair<const char*, T>> names)
{
    for (const auto& [name, value] : names) {
        if (text == name) {
            return value;
        }
    }
    return std::nullopt;
}

void collect_warnings(JobOutcome& outcome)
{
    const Preparation& p = outcome.preparation;
    const MoveResult& move = outcome.move;
    for (const auto* warnings : {&p.import.warnings, &p.warnings, &p.target->warnings, &p.region.warnings,
                                 &move.correspondence.warnings, &move.warnings}) {
        for (const std::string& warning : *warnings) {
            if (std::ranges::find(outcome.warnings, warning) == outcome.warnings.end()) {
                outcome.warnings.push_back(warning);
            }
        }
    }
}

/// From this change of the angle across the rim on, mean and largest, a move is said to change it [deg].
constexpr double rim_crease_mean = 0.5, rim_crease_max = 1.5;

void warn_of_rim_crease(JobOutcome& outcome, const MoveOptions& options)
{
    const auto counts = [](double mean, double max) { return mean > rim_crease_mean || max > rim_crease_max; };
    const QualityReport& q = outcome.measures.quality;
    if (!counts(q.rim_crease_mean_change, q.rim_crease_max_change)) {
        return;
    }
    const MoveResult& move = outcome.move;
    const auto [smooth, creased] = rim_changes(move.rest, move.V, move.region, options.rim_crease_angle);
    const bool tangent = options.rim == RimControl::tangent;
    if (counts(smooth.mean, smooth.max)) {
        outcome.warnings.push_back(fmt::format(
            "the move leaves a crease where the region ends, {:.2g} deg in the mean and {:.2g} deg at most: {}",
            smooth.mean, smooth.max,
            tangent ? "widen it (--roi-distance)" : "ask for --rim tangent or widen it (--roi-distance)"));
    }
    if (counts(creased.mean, creased.max)) {
        outcome.warnings.push_back(fmt::format(
            "where the region ends on a crease of {:.2g} deg, the move changes its angle by {:.2g} deg in the mean and "
            "{:.2g} deg at most: {}",
            creased.at_rest, creased.mean, creased.max,
            tangent ? "slide less, or widen the region beyond it (--roi-distance)" : "--rim tangent keeps it"));
    }
}

void warn_of_intersections(JobOutcome& outcome)
{
    const QualityReport& q = outcome.measures.quality;
    if (q.self_intersections > 0) {
        const Vec3& at = q.self_intersection_at;
        outcome.warnings.push_back(fmt::format(
            "the moved surface cuts through itself, {} pairs of triangles, as at ({:.6g}, {:.6g}, {:.6g}) mm: "
            "shorten the slide, or move the line in a smaller region (--roi-distance)",
            q.self_intersections, at.x(), at.y(), at.z()));
    }
}

/// From this change of its mean crease angle on, another line is said to lose its crease [deg].
constexpr double inner_crease_change = 2;

void warn_of_inner_lines(JobOutcome& outcome)
{
    for (const InnerLine& line : outcome.inner_lines) {
        if (line.id >= 0 && std::abs(line.crease_after - line.crease_before) > inner_crease_change) {
            outcome.warnings.push_back(fmt::format("line {} in the region changes its crease angle from {:.3g} to "
                                                   "{:.3g} deg: a region that ends before it "
                                                   "(--roi-distance) leaves it out, --hold {} keeps it in its place",
                                                   line.id, line.crease_before, line.crease_after, line.id));
        }
    }
}

std::string mm(double x) { return fmt::format("{:.4g} mm", x); }

} // namespace

std::string_view version() { return TAPELINE_VERSION; }

Error not_converged(const MoveResult& move)
{
    for (const SolveReport& solve : move.solves) {
        if (!solve.converged) {
            return {ErrorKind::not_converged,
                    fmt::format("the solver did not converge on the {} side: error estimate {:.3g} mm after {} "
                                "iterations, wanted {:.3g} mm; choose a region that ends before other feature lines "
                                "(--roi-distance), raise --max-iterations or --solver-tolerance, or give "
                                "--allow-unconverged",
                                solve.side, solve.error_estimate_mm, solve.iterations, solve.tolerance_mm)};
        }
    }
    return {ErrorKind::not_converged, "the solver did not converge from its second start, so that uniqueness cannot be "
                                      "judged; raise --max-iterations or --solver-tolerance, or give "
                                      "--allow-unconverged"};
}

Error ambiguity(const MoveResult& move)
{
    return {ErrorKind::not_converged,
            fmt::format("the result is ambiguous: from another start the method ends {:.3g} mm away, more than the "
                        "{:.3g} mm that count as the same; choose another --method, or give --allow-ambiguous",
                        move.uniqueness.distance_mm, move.uniqueness.limit_mm)};
}

MoveOptions move_options(const Job& job)
{
    const MoveSettings& s = job.move;
    MoveOptions options;
    options.method = method_named(s.method).value_or(options.method);
    options.correspondence.mode =
        job.target.correspondence == "arc-length" ? CorrespondenceMode::arc_length : CorrespondenceMode::projection;
    options.retraction = named<RetractionMode>(s.retraction, {{"harmonic", RetractionMode::harmonic},
                                                              {"planes", RetractionMode::planes},
                                                              {"sequential", RetractionMode::sequential}});
    options.active_radius_mm = s.active_radius;
    options.extension_path = s.extension_path == "edges" ? ExtensionPath::edges : ExtensionPath::geodesic;
    options.extension_target = named<ExtensionTarget>(
        s.extension_target, {{"tapered", ExtensionTarget::tapered}, {"free", ExtensionTarget::free}});
    options.end_slide_mm = s.end_slide;
    options.stiffness_ratio = s.stiffness_ratio;
    options.stiff = named<Stiff>(s.stiff, {{"along", Stiff::along}, {"across", Stiff::across}});
    options.placement =
        named<Placement>(s.placement, {{"on-surface", Placement::on_surface}, {"off-surface", Placement::off_surface}});
    options.compressed_side =
        named<LineSide>(s.compressed_side, {{"left", LineSide::left}, {"right", LineSide::right}});
    options.crease =
        named<CreaseRestoration>(s.restore_crease, {{"on", CreaseRestoration::on}, {"off", CreaseRestoration::off}})
            .value_or(CreaseRestoration::automatic);
    options.crease_loss = s.crease_loss;
    options.tolerance_mm = s.solver_tolerance;
    options.max_iterations = s.max_iterations;
    options.clamp_rings = s.clamp_rings;
    options.rings = s.rings;
    options.ring_weights = s.ring_weights == "by-cell" ? RingWeights::by_cell : RingWeights::even;
    options.smoothness = s.smoothness;
    options.check_unique = s.check_unique;
    options.rim = named<RimControl>(s.rim, {{"position", RimControl::position}, {"tangent", RimControl::tangent}})
                      .value_or(RimControl::automatic);
    options.rim_width_mm = s.rim_width;
    options.rim_crease_angle = std::min(job.lines.crease_angle_low, job.lines.crease_angle);
    options.line_crease = s.crease == "keep" ? LineCrease::keep : LineCrease::free;
    options.plate_stiffness_ratio = s.plate_stiffness_ratio;
    options.exact_surface = s.exact_surface != "off";
    options.strip_width_mm = strip_width(s);
    return options;
}

namespace {

Result<JobOutcome> solve_steps(const Job& job, const JobInputs& inputs, Stopwatch& watch, const Progress& progress)
{
    JobOutcome outcome;
    const Progress moving = progress.part(0.3, 0.9);
    return prepare(job, watch, progress.part(0.0, 0.3), inputs)
        .and_then([&](Preparation prepared) {
            outcome.preparation = std::move(prepared);
            watch.restart();
            const Preparation& p = outcome.preparation;
            return move_feature_line(p.model, p.line, p.target->line, p.region, move_options(job), moving);
        })
        .and_then([&](MoveResult moved) -> Result<void> {
            outcome.move = std::move(moved);
            const std::vector<AppendedVertex>& cut = outcome.preparation.rim_cut;
            outcome.move.appended.insert(outcome.move.appended.begin(), cut.begin(), cut.end());
            for (const auto& [stage, seconds] : outcome.move.seconds) {
                watch.add(stage, seconds);
            }
            watch.restart();
            if (!outcome.move.converged() && !job.move.allow_unconverged) {
                return tl::unexpected(not_converged(outcome.move));
            }
            if (outcome.move.ambiguous() && !job.move.allow_ambiguous) {
                return tl::unexpected(ambiguity(outcome.move));
            }
            return progress.report(0.9, "quality") ? Result<void>() : fail(ErrorKind::cancelled, "cancelled");
        })
        .and_then([&] { return measure_move(outcome.move, outcome.preparation.target->line); })
        .and_then([&](Measures measures) {
            outcome.measures = std::move(measures);
            outcome.inner_lines = measure_inner_lines(outcome.move, outcome.preparation.lines);
            watch.lap("quality");
            return inputs.model ? Result<std::string>(inputs.model->sha256) : file_sha256(job.input);
        })
        .map([&](std::string sum) {
            outcome.input_sha256 = std::move(sum);
            outcome.gates = evaluate_gates(job.gate, outcome.measures);
            collect_warnings(outcome);
            warn_of_rim_crease(outcome, move_options(job));
            warn_of_intersections(outcome);
            warn_of_inner_lines(outcome);
            outcome.seconds = watch.seconds();
            return std::move(outcome);
        });
}

Result<JobOutcome> run_steps(const Job& job, const Progress& progress)
{
    Stopwatch watch;
    return check_outputs(job)
        .and_then([&] { return solve_steps(job, {}, watch, progress); })
        .and_then([&](JobOutcome outcome) {
            return write_outputs(job, outcome, watch, progress.part(0.93, 1.0)).map([&] {
                outcome.seconds = watch.seconds();
                return std::move(outcome);
            });
        });
}

} // namespace

Result<JobOutcome> run_job(const Job& job, const Progress& progress)
{
    return guarded([&] { return run_steps(job, progress); });
}

Result<JobOutcome> solve_job(const Job& job, const JobInputs& inputs, const Progress& progress)
{
    Stopwatch watch;
    return guarded([&] { return solve_steps(job, inputs, watch, progress); });
}

std::string outcome_table(const JobOutcome& o)
{
    const QualityReport& q = o.measures.quality;
    const PlacementResult& p = o.move.placement;
    const bool on = p.verdict == Placement::on_surface;
    const bool compressed = o.measures.has_compressed;
    const bool from_exact = q.bulge_reference == BulgeReference::exact;
    const auto change = [](const SectionMeasure& m) {
        return fmt::format("{}, {}", m.inflections_before, m.inflections_after);
    };
    const UniquenessReport& u = o.move.uniqueness;
    std::vector<std::vector<std::string>> rows = {
        {"method", std::string(method_info(o.move.method).name)},
        {"verdict", fmt::format("{} (off fraction {:.3f})", on ? "on surface" : "off surface", p.off_fraction)},
        {"compressed side", !compressed                      ? "none"
                            : p.compressed == LineSide::left ? "left"
                                                             : "right"},
        {"largest slide", mm(q.slide_max_mm)},
        {"bulge", compressed ? mm(q.bulge_max_mm) + (from_exact ? " from the exact faces" : "") : "-"},
        {"inflections, compressed side", compressed ? change(q.compressed_sections) : "-"},
        {fmt::format("inflections, {} side", compressed ? "tension" : "either"), change(q.tension_sections)},
        {"crease angle before, after", fmt::format("{:.3f}, {:.3f} deg", q.crease_before, q.crease_after)},
        {"rim crease mean, max", fmt::format("{:.3f}, {:.3f} deg", q.rim_crease_mean_change, q.rim_crease_max_change)},
        {"crown change, tension side", q.crown ? fmt::format("{:+.3f}", q.crown->change) : "-"},
        {"line error", fmt::format("{:.2e} mm", q.line_error_max_mm)},
        {"squash", fmt::format("{:.3f}", q.squash)},
        {"flipped triangles", std::to_string(q.flipped)},
        {"distance to the exact faces",
         o.move.exact_surface.applied ? fmt::format("{:.2e} mm", o.move.exact_surface.distance_after_mm) : "-"},
        {"region",
         fmt::format("{} vertices, {} triangles", o.move.region.vertices.size(), o.move.region.faces.size())}};
    rows.push_back({"solver iterations, error estimate",
                    fmt::format("{}, {:.2g} mm", o.move.iterations(), o.move.error_estimate_mm())});
    if (const std::string strip = strip_text(o.move); !strip.empty()) {
        rows.push_back({"strip", strip});
    }
    if (u.checked) {
        rows.push_back({"uniqueness: distance from a second start",
                        mm(u.distance_mm) + (o.move.ambiguous() ? ", ambiguous" : "")});
    }
    double total = 0;
    for (const auto& [stage, seconds] : o.seconds) {
        rows.push_back({fmt::format("seconds, {}", stage), fmt::format("{:.2f}", seconds)});
        total += seconds;
    }
    rows.push_back({"seconds, total", fmt::format("{:.2f}", total)});
    return text_table(rows);
}

} // namespace tapeline
