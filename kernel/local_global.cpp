// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/local_global.h"

#include "kernel/anderson.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace tapeline {

namespace {

std::string place(const Mesh& mesh, int v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
}

/// First vertex that no path along triangles joins to a constraint; -1 when there is none.
int unreached_vertex(const Triangles& F, int vertex_count, const std::vector<int>& constrained)
{
    std::vector<int> parent(vertex_count);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v) {
            v = parent[v] = parent[parent[v]];
        }
        return v;
    };
    for (int t = 0; t < F.rows(); ++t) {
        parent[root(F(t, 1))] = root(F(t, 0));
        parent[root(F(t, 2))] = root(F(t, 0));
    }
    std::vector<char> held(vertex_count, 0);
    for (const int v : constrained) {
        held[root(v)] = 1;
    }
    for (int v = 0; v < vertex_count; ++v) {
        if (!held[root(v)]) {
            return v;
        }
    }
    return -1;
}

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

/// Judges iterates: by the energy where both steps lower it, otherwise by the size of the step that follows.
class Merit {
public:
    explicit Merit(LocalGlobalSystem& system) : system_(system), noise_(1e-13 * system.energy_scale()) {}

    /// Fits the rotations to x and says what it is worth; smaller is better.
    double at(const Eigen::MatrixXd& x)
    {
        if (!x.allFinite()) {
            return std::numeric_limits<double>::infinity();
        }
        const double energy = system_.fit_rotations(x);
        if (system_.descends()) {
            return energy;
        }
        plain_ = system_.solve_positions();
        return (plain_ - x).norm();
    }
    bool accepts(double candidate, double current) const
    {
        // Steps of an accelerated iteration rise now and then on their way down.
        return system_.descends() ? candidate <= current + noise_ : candidate <= 2 * current;
    }
    /// The plain step from the x of the last `at`.
    Eigen::MatrixXd plain() const { return system_.descends() ? system_.solve_positions() : plain_; }

private:
    LocalGlobalSystem& system_;
    double noise_;
    Eigen::MatrixXd plain_;
};

struct Iteration {
    int count = 0;
    double error_estimate = 0;
    bool converged = false;
    bool cancelled = false;
};

/// Local/global iterations from `x` until the error estimate is below `tolerance`.
Iteration iterate_from(LocalGlobalSystem& system, Eigen::MatrixXd& x, double tolerance, const IterationOptions& options,
                       const Progress& progress)
{
    Iteration run;
    StepMonitor monitor(options.anderson_window > 0);
    Anderson anderson(options.anderson_window);
    Merit merit(system);
    double value = merit.at(x);
    double first_estimate = 0, done = 0;
    while (run.count < options.max_iterations) {
        const Eigen::MatrixXd plain = merit.plain();
        Eigen::MatrixXd candidate = anderson.next(x, plain);
        double candidate_value = merit.at(candidate);
        if (!merit.accepts(candidate_value, value)) {
            candidate = plain;
            candidate_value = merit.at(candidate);
        }
        monitor.record(largest_row(candidate - x));
        x = std::move(candidate);
        value = candidate_value;
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

/// The targets after `share` of the way from the rest shape.
Positions part_way(const LocalGlobalSystem& system, const Positions& targets, double share)
{
    Positions goal = targets;
    for (size_t i = 0; share < 1 && i < system.constrained_vertices().size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const Eigen::RowVector3d from = system.rest().V.row(system.constrained_vertices()[i]);
        goal.row(row) = from + (targets.row(row) - from) * share;
    }
    return goal;
}

} // namespace

Result<void> check_triangles(const Mesh& rest)
{
    const double diagonal = bounding_diagonal(rest.V);
    for (int t = 0; t < rest.F.rows(); ++t) {
        if (!(triangle_area(rest, t) > 1e-16 * diagonal * diagonal)) {
            return fail(
                ErrorKind::rejected,
                fmt::format("the region has a triangle without area at {} mm: remesh the region (--max-edge) or "
                            "repair the model there",
                            place(rest, rest.F(t, 0))));
        }
    }
    return {};
}

Result<void> LocalGlobalSystem::set_up(const Mesh& rest, const Eigen::SparseMatrix<double>& K,
                                       const std::vector<int>& constrained)
{
    const int n = static_cast<int>(rest.V.rows());
    if (const int v = unreached_vertex(rest.F, n, constrained); v >= 0) {
        return fail(ErrorKind::rejected,
                    fmt::format("a part of the region at {} mm touches neither the line nor a fixed rim, so nothing "
                                "holds it: choose a region that is one piece",
                                place(rest, v)));
    }
    rest_ = rest;
    rotations_.assign(n, Eigen::Matrix3d::Identity());
    if (!elimination_.factorize(K, constrained)) {
        return fail(ErrorKind::not_converged,
                    "the region's stiffness matrix cannot be factorised because its triangles "
                    "are too thin: remesh the region (--max-edge)");
    }
    return {};
}

Eigen::MatrixXd LocalGlobalSystem::harmonic_start(const Positions& from) const
{
    Eigen::MatrixXd displacement = elimination_.values();
    for (size_t i = 0; i < constrained_vertices().size(); ++i) {
        displacement.row(static_cast<Eigen::Index>(i)) -= from.row(constrained_vertices()[i]);
    }
    return extract(from) + elimination_.response(displacement);
}

double LocalGlobalSystem::residual(const Eigen::MatrixXd& unknowns) const
{
    return free_count() == 0 ? 0 : elimination_.residual(unknowns, forces()).norm() / force_scale_;
}

Result<DeformationResult> iterate(LocalGlobalSystem& system, const Positions& targets, const IterationOptions& options,
                                  const std::optional<Positions>& start, const Progress& progress)
{
    const double tolerance =
        options.tolerance_mm > 0 ? options.tolerance_mm : 1e-5 * rotation_free_size(system.rest().V);
    DeformationResult result;
    Positions from = system.rest().V;
    Eigen::MatrixXd x;
    const int steps = std::max(1, options.load_steps);
    for (int step = 1; step <= steps; ++step) {
        system.constrain(part_way(system, targets, static_cast<double>(step) / steps));
        x = start && step == 1 ? system.extract(*start) : system.harmonic_start(from);
        // Intermediate load steps only lead to the right basin and need not be exact.
        const Progress share = progress.part((step - 1.0) / steps, static_cast<double>(step) / steps);
        const Iteration run = iterate_from(system, x, step < steps ? 100 * tolerance : tolerance, options, share);
        if (run.cancelled) {
            return fail(ErrorKind::cancelled, "the deformation was cancelled");
        }
        result.iterations += run.count;
        result.error_estimate_mm = run.error_estimate;
        result.converged = run.converged;
        from = system.assemble(x);
    }
    result.V = from;
    result.residual = system.residual(x);
    result.energy = system.exact_energy(x);
    if (!result.V.allFinite()) {
        return fail(ErrorKind::not_converged,
                    "the deformation left the range of numbers: the region's triangles are too "
                    "thin, remesh it (--max-edge)");
    }
    return result;
}

} // namespace tapeline
