// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/preparation.h"

#include "kernel/correspondence.h"
#include "kernel/remesh.h"
#include "kernel/rim_cut.h"
#include "plugin/runner/line_refinement.h"
#include "plugin/runner/preparation_memory.h"
#include "plugin/runner/region_choice.h"
#include "plugin/runner/remeshing.h"
#include "plugin/runner/strips.h"
#include "plugin/runner/vertex_list.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr double sliver_angle = 5; ///< below this smallest angle the region is called unfit [deg]

/// The steps of a preparation; each returns whether it worked and leaves its part in `made`.
class Preparer {
public:
    Preparer(const Job& job, const JobInputs& inputs, Stopwatch& watch, const Progress& progress)
        : job_(job), inputs_(inputs), watch_(watch), progress_(progress)
    {
    }

    Result<void> check() const { return inputs_.line.empty() ? check_line_chosen(job_.lines.line) : Result<void>(); }

    Result<void> read()
    {
        return stage("import", 0.0).and_then([&]() -> Result<void> {
            if (inputs_.model) {
                made.model = inputs_.model->imported.model;
                made.import = inputs_.model->imported.report;
                return {};
            }
            return read_model(job_.input, import_options(job_.import)).map([&](ImportedModel imported) {
                made.model = std::move(imported.model);
                made.import = std::move(imported.report);
            });
        });
    }

    Result<void> find_line()
    {
        return stage("lines", 0.2).and_then([&] {
            std::vector<FeatureLine> lines = all_lines();
            return refine_chosen(lines)
                .and_then([&] { return choose(lines); })
                .and_then([&](FeatureLine line) {
                    made.line = std::move(line);
                    for (const FeatureLine& known : lines) {
                        made.lines.push_back({known.id, line_points(made.model.mesh, known)});
                        if (known.closed) {
                            made.lines.back().points.push_back(made.lines.back().points.front());
                        }
                    }
                    return region_options(made.model, lines, made.line, job_.region);
                })
                .map([&](RegionOptions options) { region_options_ = std::move(options); });
        });
    }

    Result<void> find_target()
    {
        return stage("target", 0.3).and_then([&] { return find_target_again(); });
    }

    Result<void> remesh()
    {
        if (!remeshes(made.model, job_.remesh)) {
            return {};
        }
        return stage("remesh", 0.4).and_then([&] { return faces_to_remesh(); }).and_then([&](const auto& faces) {
            return remesh_faces(faces);
        });
    }

    Result<void> find_region()
    {
        return stage("region", 0.8).and_then([&] { return region_around_line(); }).map([&](Region region) {
            made.region = std::move(region);
            made.remesh.min_angle_after = min_angle(made.model.mesh, made.region.faces);
            warn_about_slivers();
        });
    }

    Preparation finish()
    {
        watch_.lap(stage_);
        return std::move(made);
    }

    Preparation made;

private:
    Result<void> stage(const std::string& name, double fraction)
    {
        if (!stage_.empty()) {
            watch_.lap(stage_);
        }
        stage_ = name;
        if (!progress_.report(fraction, name)) {
            return fail(ErrorKind::cancelled, "cancelled");
        }
        return {};
    }

    std::vector<FeatureLine> all_lines() const
    {
        const auto known = inputs_.memory ? inputs_.memory->lines() : nullptr;
        if (known) {
            return *known;
        }
        std::vector<FeatureLine> lines = find_feature_lines(made.model, line_options(job_.lines));
        if (inputs_.memory) {
            inputs_.memory->keep_lines(lines);
        }
        return lines;
    }

    Result<Remeshed> remeshed(const std::vector<int>& faces, double max_edge) const
    {
        const auto known = inputs_.memory ? inputs_.memory->remeshed(faces, max_edge) : nullptr;
        if (known) {
            return *known;
        }
        const double crease = std::min(job_.lines.crease_angle_low, job_.lines.crease_angle);
        auto again = remesh_around(made.model, faces, made.line, region_options_, max_edge, crease);
        if (again && inputs_.memory) {
            inputs_.memory->keep_remeshed(faces, max_edge, *again);
        }
        return again;
    }

    Result<FeatureLine> choose(const std::vector<FeatureLine>& lines) const
    {
        return inputs_.line.empty() ? choose_line(made.model, lines, job_.lines.line)
                                    : line_through(made.model, inputs_.line);
    }

    Result<void> refine_chosen(std::vector<FeatureLine>& lines)
    {
        if (!inputs_.line.empty() || !job_.lines.line.names_line()) {
            return {};
        }
        const std::string& selector = job_.lines.line.text;
        return select_line(made.model, lines, selector.substr(0, selector.find('@')))
            .and_then([&](const FeatureLine& whole) { return refine_before_choice(made.model, whole, job_.remesh); })
            .map([&](std::optional<RefinedLine> refined) {
                if (refined) {
                    made.model = std::move(refined->model);
                    lines.at(static_cast<std::size_t>(refined->line.id)) = std::move(refined->line);
                }
            });
    }

    CorrespondenceOptions correspondence_options() const
    {
        CorrespondenceOptions options;
        options.mode = job_.target.correspondence == "arc-length" ? CorrespondenceMode::arc_length
                                                                  : CorrespondenceMode::projection;
        return options;
    }

    Result<Correspondence> matched() const
    {
        return correspond(made.model, made.line, made.target->line, correspondence_options());
    }

    Result<Region> region_around_line()
    {
        return matched().and_then([&](const Correspondence& map) {
            return make_region(made.model, map.line, map.targets, region_options_).map([&](Region region) {
                // Where the surface may kink at the rim, the teeth of a band would show.
                if (job_.move.rim != "position") {
                    return region;
                }
                RimCut cut = cut_rim(made.model, map.line, map.targets, region, region_options_);
                made.model = std::move(cut.model);
                made.rim_cut = std::move(cut.appended);
                return std::move(cut.region);
            });
        });
    }

    /// A generous part around the line and its target: the region itself is found again on the new triangles.
    Result<std::vector<int>> faces_to_remesh()
    {
        return matched().and_then([&](const Correspondence& map) -> Result<std::vector<int>> {
            const bool by_distance =
                region_options_.cad_faces.empty() && region_options_.bounding_lines.empty() && !region_options_.box;
            if (!by_distance) {
                return make_region(made.model, map.line, map.targets, region_options_).map([](const Region& region) {
                    return region.faces;
                });
            }
            const double distance = region_options_.distance_mm > 0
                                        ? region_options_.distance_mm
                                        : automatic_roi_distance(map.line, map.displacements);
            std::vector<Vec3> points = line_points(made.model.mesh, map.line);
            points.insert(points.end(), map.targets.begin(), map.targets.end());
            return faces_near(made.model.mesh, map.line, points, 1.05 * distance);
        });
    }

    Result<void> remesh_faces(const std::vector<int>& faces)
    {
        const double max_edge =
            job_.remesh.max_edge > 0 ? job_.remesh.max_edge : automatic_max_edge(made.model.mesh, faces, made.line);
        Result<Remeshed> again = remeshed(faces, max_edge);
        if (!again) {
            return tl::unexpected(again.error());
        }
        made.remesh = {true,
                       max_edge,
                       again->min_angle_before,
                       again->min_angle_after,
                       static_cast<int>(again->model.mesh.V.rows() - made.model.mesh.V.rows()),
                       again->projected};
        std::ranges::move(again->warnings, std::back_inserter(made.warnings));
        made.model = std::move(again->model);
        made.line = std::move(again->line);
        region_options_ = std::move(again->options);
        // The remeshed line and surface lie closer to the exact ones than the tessellation, so the target made from
        // them does too.
        return find_target_again();
    }

    Result<void> find_target_again()
    {
        return make_target(made.model, made.line, job_.target, inputs_.target, strip_width(job_.move))
            .map([&](TargetChoice choice) { made.target = std::move(choice); });
    }

    void warn_about_slivers()
    {
        if (!made.remesh.applied) {
            made.remesh.min_angle_before = made.remesh.min_angle_after;
        }
        if (made.remesh.min_angle_after < sliver_angle && !made.remesh.applied) {
            made.warnings.push_back(fmt::format("the region's triangles are slivers (smallest angle {:.2f} deg): "
                                                "--remesh on would give it even ones",
                                                made.remesh.min_angle_after));
        }
    }

    const Job& job_;
    const JobInputs& inputs_;
    Stopwatch& watch_;
    const Progress& progress_;
    std::string stage_;
    RegionOptions region_options_;
};

} // namespace

double unit_length_mm(const std::string& unit)
{
    return unit == "cm" ? 10 : unit == "m" ? 1000 : unit == "in" ? 25.4 : unit == "ft" ? 304.8 : 1;
}

ImportOptions import_options(const ImportSettings& settings)
{
    ImportOptions options;
    options.linear_deflection_mm = settings.linear_deflection;
    options.angular_deflection = settings.angular_deflection;
    options.sew_tolerance_mm = settings.sew_tolerance;
    options.units_mm = unit_length_mm(settings.units);
    return options;
}

Result<Preparation> prepare_target(const Job& job, Stopwatch& watch, const Progress& progress, const JobInputs& inputs)
{
    const bool on_surface = !job.target.slide.empty() || job.target.on_surface;
    Preparer preparer(job, inputs, watch, progress);
    return preparer.check()
        .and_then([&] { return preparer.read(); })
        .and_then([&] { return preparer.find_line(); })
        .and_then([&] { return preparer.find_target(); })
        .and_then([&] { return on_surface ? preparer.remesh() : Result<void>(); })
        .map([&] { return preparer.finish(); });
}

Result<Preparation> prepare(const Job& job, Stopwatch& watch, const Progress& progress, const JobInputs& inputs)
{
    if (!changes_line(job.target) && !inputs.target) {
        return fail(ErrorKind::usage, "no goal is given for the line: give --target FILE, --slide MM or --edit FILE");
    }
    Preparer preparer(job, inputs, watch, progress);
    return preparer.check()
        .and_then([&] { return preparer.read(); })
        .and_then([&] { return preparer.find_line(); })
        .and_then([&] { return preparer.find_target(); })
        .and_then([&] { return preparer.remesh(); })
        .and_then([&] { return preparer.find_region(); })
        .map([&] { return preparer.finish(); });
}

} // namespace tapeline
