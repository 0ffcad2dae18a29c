// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/retraction.h"

#include "kernel/feature_lines.h"
#include "kernel/retraction_steps.h"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <iterator>
#include <memory>

namespace tapeline {

namespace {

/// Feature lines at least this sharp stay even where the target crosses one [deg].
constexpr double sharp_angle = 30;

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

/// The side's feature edges that nothing may be dragged over.
std::vector<VertexPair> sharp_features(const SideMesh& side)
{
    const Topology topology(side.mesh.F, static_cast<int>(side.mesh.V.rows()));
    std::vector<VertexPair> sharp;
    std::ranges::copy_if(side.features, std::back_inserter(sharp), [&](const VertexPair& edge) {
        return std::ranges::binary_search(side.kept, edge) ||
               crease_angle(side.mesh, topology, topology.find_edge(edge[0], edge[1])) >= sharp_angle;
    });
    return sharp;
}

Error crossing(const SideMesh& side, const std::vector<Vec3>& displacements, int entry)
{
    const int v = side.line[entry];
    const Vec3 p = side.mesh.V.row(v), q = p + displacements[entry];
    return {ErrorKind::rejected,
            fmt::format("the target crosses another feature line on the way of {:.4g} mm from ({:.6g}, {:.6g}, {:.6g}) "
                        "to ({:.6g}, {:.6g}, {:.6g}) mm: slide less there, or choose the target on the near side of "
                        "that line",
                        displacements[entry].norm(), p.x(), p.y(), p.z(), q.x(), q.y(), q.z())};
}

} // namespace

Result<RetractionResult> retract(const SideMesh& side, const std::vector<Vec3>& displacements,
                                 const RetractionOptions& options)
{
    try {
        if (const auto error = refusal(side, displacements)) {
            return tl::unexpected(*error);
        }
        const bool on_rails = options.mode == RetractionMode::harmonic;
        const auto task_between = [&](const std::vector<VertexPair>& features) {
            return std::make_unique<RetractionTask>(side, displacements, features, on_rails, options.share,
                                                    on_rails ? options.strip : nullptr);
        };
        auto task = task_between(side.features);
        if (task->crossed() >= 0) {
            // Soft lines give way where the target crosses another one; sharp ones cannot.
            task = task_between(sharp_features(side));
        }
        if (const int entry = task->crossed(); entry >= 0) {
            return tl::unexpected(crossing(side, displacements, entry));
        }
        RetractionResult result;
        switch (options.mode) {
        case RetractionMode::harmonic:
            result.V = retract_harmonic(*task, options.material);
            break;
        case RetractionMode::planes:
            result.V = retract_planes(*task, result.crossings);
            break;
        case RetractionMode::sequential:
            result.V = retract_sequentially(*task, options.active_radius_mm);
            break;
        }
        if (!result.V.allFinite()) {
            return fail(ErrorKind::rejected, "the retraction gave positions that are not numbers: the side's triangles "
                                             "are too thin, remesh the region (--max-edge)");
        }
        const FoldReport folds = find_folds(task->inner(), result.V);
        result.min_area_ratio = folds.min_area_ratio;
        result.flipped = static_cast<int>(folds.flipped.size());
        if (const int worst = folds.flipped.empty() ? folds.smallest : folds.flipped.front(); worst >= 0) {
            result.worst_at = task->inner().V.row(task->inner().F(worst, 0));
        }
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
        if (const double ratio = triangle_area(slid, t) / triangle_area(inner, t); ratio < report.min_area_ratio) {
            report.min_area_ratio = ratio;
            report.smallest = t;
        }
        if (triangle_normal(slid, t).dot(triangle_normal(inner, t)) < 0) {
            report.flipped.push_back(t);
        }
    }
    return report;
}

} // namespace tapeline
