// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/correspondence.h"

#include "kernel/foot_matching.h"

#include <cmath>
#include <exception>
#include <fmt/format.h>

namespace tapeline {

namespace {

Result<MatchInput> match_input(const Model& model, const FeatureLine& line, const TargetCurve& target)
{
    MatchInput input{{}, line.vertices, line.closed};
    for (const int v : line.vertices) {
        if (v < 0 || v >= model.mesh.V.rows()) {
            return fail(ErrorKind::rejected, fmt::format("the line names vertex {}, but the model has vertices 0 to {}",
                                                         v, model.mesh.V.rows() - 1));
        }
        input.points.push_back(model.mesh.V.row(v));
    }
    if (line.closed != target.closed()) {
        return fail(ErrorKind::rejected,
                    line.closed
                        ? "the line is closed but the target is open; select a part of the line (ID@FROM..TO) or "
                          "give a closed target"
                        : "the line is open but the target is closed; select a closed line or give an open target");
    }
    const size_t edges = input.points.size() - (line.closed ? 0 : 1);
    if (input.points.empty() || edges < 2) {
        return fail(ErrorKind::rejected, fmt::format("the line has {} edge(s), two are needed; select a longer part or "
                                                     "refine the mesh",
                                                     input.points.empty() ? 0 : edges));
    }
    const double length = target.length();
    if (!(length > 0) || !std::isfinite(length)) {
        return fail(ErrorKind::rejected, "the target line has no length");
    }
    for (size_t i = 0; i < edges; ++i) {
        if (!((input.points[i] - input.points[(i + 1) % input.points.size()]).norm() > 0)) {
            return fail(ErrorKind::rejected,
                        fmt::format("line vertices {} and {} lie in the same place; weld the mesh", line.vertices[i],
                                    line.vertices[(i + 1) % input.points.size()]));
        }
    }
    return input;
}

/// Evaluates the curve at the matched parameters and checks the displacements.
Result<Correspondence> evaluate(const Model& model, const FeatureLine& line, const TargetCurve& target,
                                const FootMatch& match, const CorrespondenceOptions& options)
{
    Correspondence result;
    const int n = static_cast<int>(line.vertices.size());
    const bool whole = match.first == 0 && match.last == n - 1;
    if (whole) {
        result.line = line;
    } else {
        const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
        result.line = part_of_line(model, topology, line, match.first, match.last);
    }
    result.before = result.line.before;
    result.after = result.line.after;
    result.parameters = match.parameters;
    result.reversed = match.reversed;
    result.warnings = match.warnings;
    for (size_t i = 0; i < result.line.vertices.size(); ++i) {
        const int v = result.line.vertices[i];
        const Vec3 position = model.mesh.V.row(v);
        const Vec3 goal = target.point(match.parameters[i]);
        const Vec3 tangent = target.tangent(match.parameters[i]);
        if (!goal.allFinite() || !tangent.allFinite()) {
            return fail(ErrorKind::rejected, fmt::format("the target line has no point or tangent at parameter {:.6g}",
                                                         match.parameters[i]));
        }
        result.targets.push_back(goal);
        result.displacements.push_back(goal - position);
        result.tangents.push_back(match.reversed ? Vec3(-tangent) : tangent);
        const double distance = (goal - position).norm();
        if (options.max_distance_mm > 0 && distance > options.max_distance_mm) {
            return fail(
                ErrorKind::rejected,
                fmt::format("line vertex {} at ({:.6g}, {:.6g}, {:.6g}) is {:.6g} mm from the target, more than "
                            "the allowed {:.6g} mm",
                            v, position.x(), position.y(), position.z(), distance, options.max_distance_mm));
        }
    }
    return result;
}

} // namespace

Result<Correspondence> correspond(const Model& model, const FeatureLine& line, const TargetCurve& target,
                                  const CorrespondenceOptions& options)
try {
    const auto input = match_input(model, line, target);
    if (!input) {
        return tl::unexpected(input.error());
    }
    const auto match = options.mode == CorrespondenceMode::projection ? match_by_projection(*input, target)
                                                                      : match_by_arc_length(*input, target);
    if (!match) {
        return tl::unexpected(match.error());
    }
    return evaluate(model, line, target, *match, options);
} catch (const std::exception& problem) {
    return fail(ErrorKind::rejected, fmt::format("the line cannot be matched to the target: {}", problem.what()));
}

} // namespace tapeline
