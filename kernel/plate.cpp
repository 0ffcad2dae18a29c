// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/plate.h"

#include "kernel/anderson.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr int window = 5;
/// A single fast step is no promise for the next.
constexpr double least_ratio = 0.2;
/// Passes within which the smallest step so far has to halve; where nothing holds a part's turn it rolls on and on.
constexpr int patience = 50;

double largest_row(const Eigen::MatrixXd& M) { return M.rows() == 0 ? 0 : M.rowwise().norm().maxCoeff(); }

struct Passes {
    int count = 0;
    double error_estimate = 0;
    bool converged = false;
    bool cancelled = false;
};

Passes iterate(PlateSystem& system, Positions& V, double tolerance, int max_passes, const Progress& progress)
{
    Passes run;
    Anderson anderson(window);
    const Positions start = V;
    system.fit(V);
    V = system.minimise(V);
    run.count = 1;
    double last_step = largest_row(V - start), smallest = last_step;
    int since = 0;
    while (run.count < max_passes) {
        system.fit(V);
        const Positions G = system.minimise(V);
        ++run.count;
        const double step = largest_row(G - V);
        // What is left after a pass, as a geometric series with the ratio of the last two steps. The first step is the
        // load itself and tells nothing.
        const double ratio = run.count > 2 && last_step > 0 ? std::clamp(step / last_step, least_ratio, 0.9) : 0.5;
        run.error_estimate = step * ratio / (1 - ratio);
        if (!(step < 1e100)) {
            break;
        }
        if (run.error_estimate <= tolerance) {
            V = G;
            run.converged = true;
            break;
        }
        last_step = step;
        ++since;
        if (step < 0.5 * smallest) {
            smallest = step;
            since = 0;
        }
        if (since >= patience) {
            V = G;
            break;
        }
        V = anderson.next(V, G);
        if (!progress.report(std::min(0.99, run.count / 20.0), "plate")) {
            run.cancelled = true;
            break;
        }
    }
    return run;
}

} // namespace

Result<DeformationResult> bend_plate(const Mesh& rest, const PlateSupport& support, const PlateOptions& options,
                                     const std::optional<Positions>& start, const Progress& progress)
{
    const auto begin = std::chrono::steady_clock::now();
    if (static_cast<Eigen::Index>(support.constrained.size()) != support.targets.rows()) {
        return fail(ErrorKind::usage, fmt::format("{} targets were given for {} constrained vertices",
                                                  support.targets.rows(), support.constrained.size()));
    }
    auto system = PlateSystem::create(rest, support, options.material);
    if (!system) {
        return tl::unexpected(system.error());
    }
    const double tolerance = options.tolerance_mm > 0 ? options.tolerance_mm : 1e-5 * rotation_free_size(rest.V);
    DeformationResult result;
    result.V = system->start();
    if (start) {
        result.V = *start;
        for (size_t i = 0; i < support.constrained.size(); ++i) {
            result.V.row(support.constrained[i]) = support.targets.row(static_cast<Eigen::Index>(i));
        }
    }
    const Passes run = iterate(*system, result.V, tolerance, options.max_passes, progress);
    if (run.cancelled) {
        return fail(ErrorKind::cancelled, "the plate's deformation was cancelled");
    }
    if (!result.V.allFinite()) {
        return fail(ErrorKind::not_converged,
                    "the plate left the range of numbers: the region's triangles are too thin, remesh it (--max-edge)");
    }
    result.iterations = run.count;
    result.error_estimate_mm = run.error_estimate;
    result.converged = run.converged;
    result.energy = system->energy(result.V);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace tapeline
