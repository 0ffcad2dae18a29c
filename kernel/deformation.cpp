// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/deformation.h"

#include "kernel/anderson.h"
#include "kernel/asan_system.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>

namespace tapeline {

namespace {

/// Turns recent step sizes into an estimate of the distance to the minimiser. The factors are measured bounds:
/// with Anderson acceleration the true error stayed below 10 times the largest of four steps, without it below 200
/// times (method.md I7).
class StepMonitor {
public:
    explicit StepMonitor(bool accelerated) : factor_(accelerated ? 10 : 200) {}
    void record(double step)
    {
        steps_.push_back(step);
        if (steps_.size() > 4) {
            steps_.pop_front();
        }
    }
    double estimate() const
    {
        return steps_.size() < 4 ? std::numeric_limits<double>::infinity()
                                 : factor_ * *std::max_element(steps_.begin(), steps_.end());
    }

private:
    double factor_;
    std::deque<double> steps_;
};

double largest_row(const Eigen::MatrixXd& M) { return M.rows() == 0 ? 0 : M.rowwise().norm().maxCoeff(); }

struct Iteration {
    int count = 0;
    double error_estimate = 0;
    bool converged = false;
    bool cancelled = false;
};

/// Local/global iterations from `x` until the error estimate is below `tolerance`.
Iteration minimise(AsanSystem& system, Eigen::MatrixXd& x, double tolerance, const DeformationOptions& options,
                   const Progress& progress)
{
    Iteration run;
    StepMonitor monitor(options.anderson_window > 0);
    Anderson anderson(options.anderson_window);
    const double noise = 1e-13 * system.energy_scale();
    double energy = system.fit_rotations(x);
    double first_estimate = 0, done = 0;
    while (run.count < options.max_iterations) {
        const Eigen::MatrixXd plain = system.solve_positions();
        Eigen::MatrixXd candidate = anderson.next(x, plain);
        double candidate_energy =
            candidate.allFinite() ? system.fit_rotations(candidate) : std::numeric_limits<double>::infinity();
        if (!(candidate_energy <= energy + noise)) {
            candidate = plain;
            candidate_energy = system.fit_rotations(candidate);
        }
        monitor.record(largest_row(candidate - x));
        x = std::move(candidate);
        energy = candidate_energy;
        ++run.count;
        run.error_estimate = monitor.estimate();
        if (run.error_estimate <= tolerance) {
            run.converged = true;
            break;
        }
        if (std::isfinite(run.error_estimate)) {
            first_estimate = std::max(first_estimate, run.error_estimate);
            const double share =
                std::log(first_estimate / run.error_estimate) / std::log(std::max(first_estimate / tolerance, 2.0));
            done = std::max(done, std::clamp(share, 0.0, 0.999));
            if (!progress.report(done, "deform")) {
                run.cancelled = true;
                break;
            }
        }
    }
    return run;
}

} // namespace

Result<DeformationResult> deform(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                 const DeformationOptions& options, const std::optional<Positions>& start,
                                 const Progress& progress)
{
    const auto begin = std::chrono::steady_clock::now();
    auto system = AsanSystem::create(rest, constrained, options.material);
    if (!system) {
        return tl::unexpected(system.error());
    }
    const double tolerance = options.tolerance_mm > 0 ? options.tolerance_mm : 1e-5 * rotation_free_size(rest.V);

    DeformationResult result;
    Positions from = rest.V;
    Eigen::MatrixXd x;
    const int steps = std::max(1, options.load_steps);
    for (int step = 1; step <= steps; ++step) {
        Positions goal = targets;
        for (size_t i = 0; i < constrained.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            if (step < steps) {
                goal.row(row) = rest.V.row(constrained[i]) +
                                (targets.row(row) - rest.V.row(constrained[i])) * (static_cast<double>(step) / steps);
            }
        }
        system->constrain(goal);
        x = start && step == 1 ? system->extract(*start) : system->harmonic_start(from);
        // Intermediate load steps only lead to the right basin and need not be exact.
        const Progress share = progress.part((step - 1.0) / steps, static_cast<double>(step) / steps);
        const Iteration run = minimise(*system, x, step < steps ? 100 * tolerance : tolerance, options, share);
        if (run.cancelled) {
            return fail(ErrorKind::cancelled, "the deformation was cancelled");
        }
        result.iterations += run.count;
        result.error_estimate_mm = run.error_estimate;
        result.converged = run.converged;
        from = system->assemble(x);
    }
    result.V = from;
    result.residual = system->residual(x);
    result.energy = system->exact_energy(x);
    if (!result.V.allFinite()) {
        return fail(ErrorKind::not_converged,
                    "the deformation left the range of numbers: the region's triangles are too "
                    "thin, remesh it (--max-edge)");
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace tapeline
