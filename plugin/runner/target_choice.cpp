// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/target_choice.h"

#include "bspline/edit.h"
#include "io/target_file.h"
#include "plugin/runner/strips.h"

#include <fmt/format.h>

namespace tapeline {

namespace {

Result<TargetChoice> first_line(const Model& model, const FeatureLine& line, const TargetSettings& settings,
                                const std::optional<TargetLine>& given)
{
    if (given) {
        return TargetChoice{*given, "given", 0, {}};
    }
    if (!settings.target.empty()) {
        return read_target(settings.target).map([](TargetLine read) {
            return TargetChoice{std::move(read), "file", 0, {}};
        });
    }
    FitOptions options;
    options.control_points = settings.control_points;
    options.tolerance_mm = settings.tolerance;
    FitReport report;
    return fit_polyline(line_points(model.mesh, line), line.closed, options, &report).map([&](TargetLine fitted) {
        return TargetChoice{std::move(fitted), "fit", report.max_error_mm, {}};
    });
}

/// One distance holds everywhere; several are spread evenly over the line.
SlideLaw slide_law(const std::vector<double>& distances)
{
    SlideLaw law;
    const double last = static_cast<double>(distances.size()) - 1;
    for (std::size_t k = 0; k < distances.size(); ++k) {
        law.values.emplace_back(last > 0 ? static_cast<double>(k) / last : 0.0, distances[k]);
    }
    return law;
}

} // namespace

std::vector<Vec3> line_points(const Mesh& mesh, const FeatureLine& line)
{
    std::vector<Vec3> points;
    points.reserve(line.vertices.size());
    for (const int v : line.vertices) {
        points.emplace_back(mesh.V.row(v).transpose());
    }
    return points;
}

bool changes_line(const TargetSettings& settings)
{
    return !settings.target.empty() || !settings.edit.empty() || !settings.slide.empty();
}

Result<TargetChoice> make_target(const Model& model, const FeatureLine& line, const TargetSettings& settings,
                                 const std::optional<TargetLine>& given, const std::optional<double>& strip_width)
{
    Result<TargetChoice> choice = first_line(model, line, settings, given);
    std::optional<ExactGround> exact;
    if (settings.on_surface || !settings.slide.empty()) {
        exact.emplace(model);
    }
    const ExactGround* ground = exact ? &*exact : nullptr;
    const auto change = [&](auto&& step) {
        choice = std::move(choice).and_then([&](TargetChoice made) -> Result<TargetChoice> {
            return step(made.line).map([&](TargetLine changed) {
                made.line = std::move(changed);
                return made;
            });
        });
    };
    if (!settings.edit.empty()) {
        change([&](const TargetLine& made) {
            return read_edits(settings.edit).and_then([&](const std::vector<ControlPointEdit>& edits) {
                return move_control_points(made, edits);
            });
        });
    }
    double off = 0; // the surface, where the settings say how many control points
    if (!settings.slide.empty()) {
        const SlideLaw law = slide_law(settings.slide);
        const bool bare = !choice || choice->source != "fit" || !settings.edit.empty();
        change([&](const TargetLine& made) {
            return slide_on_surface(made, model.mesh, law, settings.tolerance, ground, settings.surface_points, &off);
        });
        change([&](const TargetLine& slid) {
            return slide_on_strips(model, line, slid, law, settings, bare ? 0.0 : strip_width, ground);
        });
    }
    if (settings.fair) {
        change([&](const TargetLine& made) {
            return fair(made, settings.fair_limit > 0 ? settings.fair_limit : 1e-3 * made.length());
        });
    }
    if (settings.on_surface) {
        change([&](const TargetLine& made) {
            return lay_on_surface(made, model.mesh, settings.tolerance, ground, settings.surface_points, &off);
        });
    }
    if (choice && off > 1e-4 * choice->line.length()) {
        choice->warnings.push_back(fmt::format(
            "with {} control points the target strays {:.3g} mm from the surface or its slide, which comes back as a "
            "bulge: allow more (--surface-points)",
            settings.surface_points, off));
    }
    return choice;
}

} // namespace tapeline
