// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/retraction.h"

#include "kernel/retraction_steps.h"

#include <exception>
#include <fmt/format.h>

namespace tapeline {

namespace {

std::optional<Error> refusal(const SideMesh& side, const std::vector<Vec3>& displacements)
{
    if (displacements.size() != side.line.size()) {
        return Error{ErrorKind::usage, fmt::format("{} displacements were given for the {} vertices of the line",
                                                   displacements.size(), side.line.size())};
    }
    for (size_t i = 0; i < displacements.size(); ++i) {
        if (!displacements[i].allFinite()) {
            return Error{ErrorKind::rejected,
                         fmt::format("the displacement of entry {} of the line is not a number; give every vertex of "
                                     "the line a target before the side is retracted",
                                     i)};
        }
    }
    const double diagonal = bounding_diagonal(side.mesh.V);
    for (int t = 0; t < side.inner_faces; ++t) {
        if (!(triangle_area(side.mesh, t) > 1e-14 * diagonal * diagonal)) {
            const Vec3 p = side.mesh.V.row(side.mesh.F(t, 0));
            return Error{ErrorKind::rejected,
                         fmt::format("a triangle of the region has no area, at ({:.6g}, {:.6g}, {:.6g}) mm: remesh the "
                                     "region (--max-edge)",
                                     p.x(), p.y(), p.z())};
        }
    }
    return {};
}

} // namespace

Result<RetractionResult> retract(const SideMesh& side, const std::vector<Vec3>& displacements,
                                 const RetractionOptions& options)
{
    try {
        if (const auto error = refusal(side, displacements)) {
            return tl::unexpected(*error);
        }
        const RetractionTask task(side, displacements, options.mode == RetractionMode::harmonic);
        RetractionResult result;
        switch (options.mode) {
        case RetractionMode::harmonic:
            result.V = retract_harmonic(task, options.material);
            break;
        case RetractionMode::planes:
            result.V = retract_planes(task, result.crossings);
            break;
        case RetractionMode::sequential:
            result.V = retract_sequentially(task, options.active_radius_mm);
            break;
        }
        if (!result.V.allFinite()) {
            return fail(ErrorKind::rejected, "the retraction gave positions that are not numbers: the side's triangles "
                                             "are too thin, remesh the region (--max-edge)");
        }
        const FoldReport folds = find_folds(task.inner(), result.V);
        result.min_area_ratio = folds.min_area_ratio;
        result.flipped = static_cast<int>(folds.flipped.size());
        return result;
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("the retraction failed: {}", e.what()));
    }
}

FoldReport find_folds(const Mesh& inner, const Positions& V)
{
    const Mesh slid{V, inner.F};
    FoldReport report;
    for (int t = 0; t < inner.F.rows(); ++t) {
        report.min_area_ratio = std::min(report.min_area_ratio, triangle_area(slid, t) / triangle_area(inner, t));
        if (triangle_normal(slid, t).dot(triangle_normal(inner, t)) < 0) {
            report.flipped.push_back(t);
        }
    }
    return report;
}

} // namespace tapeline
