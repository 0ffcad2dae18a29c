// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/elimination.h"
#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/progress.h"

#include <chrono>
#include <optional>
#include <vector>

namespace tapeline {

/// How a deformation is iterated.
struct IterationOptions {
    double tolerance_mm = 0; ///< wanted largest vertex error [mm]; 0 = 1e-5 of the mesh's size
    int max_iterations = 2000;
    int anderson_window = 5; ///< differences kept for Anderson acceleration; 0 = plain local/global
    int load_steps = 1;      ///< the displacement is applied in this many equal steps from the rest shape
};

struct DeformationResult {
    Positions V; ///< deformed positions, n×3
    int iterations = 0;
    double error_estimate_mm = 0; ///< estimate of the largest vertex distance to the solution (method.md I7)
    double residual = 0;          ///< relative force residual (method.md I7)
    double energy = 0;            ///< of the method's own energy [mm²]
    bool converged = false;
    double seconds = 0;
};

/// A deformation energy of positions and one rotation per vertex, with some vertices given (method.md B5). State: the
/// rotations of the last local step. Unknowns are the free vertices' positions, one row each, in ascending order.
class LocalGlobalSystem {
public:
    virtual ~LocalGlobalSystem() = default;
    LocalGlobalSystem(LocalGlobalSystem&&) = default;
    LocalGlobalSystem& operator=(LocalGlobalSystem&&) = default;

    int free_count() const { return elimination_.free_count(); }
    const std::vector<int>& free_vertices() const { return elimination_.free_rows(); }
    const std::vector<int>& constrained_vertices() const { return elimination_.given_rows(); }
    const Mesh& rest() const { return rest_; }
    /// Of the last local step, one per vertex.
    const std::vector<Eigen::Matrix3d>& rotations() const { return rotations_; }

    /// Sets where the constrained vertices are (rows in the order given at creation).
    void constrain(const Positions& targets) { elimination_.set(targets); }

    /// Positions of all vertices from the unknowns and the constraints.
    Positions assemble(const Eigen::MatrixXd& unknowns) const { return elimination_.assemble(unknowns); }
    /// The unknowns' rows of full positions.
    Eigen::MatrixXd extract(const Positions& V) const { return elimination_.extract(V); }
    /// The harmonic start: `from` plus the K-harmonic extension of the constraints' displacements from there.
    Eigen::MatrixXd harmonic_start(const Positions& from) const;

    /// Local step: fits the rotations to the unknowns; returns the energy [mm²].
    virtual double fit_rotations(const Eigen::MatrixXd& unknowns) = 0;
    /// Global step: the unknowns that minimise the energy for the fitted rotations.
    Eigen::MatrixXd solve_positions() const { return elimination_.solve(forces()); }
    /// Whether both steps lower one and the same energy. Where not, the iteration watches its step instead.
    virtual bool descends() const { return true; }

    /// Force residual relative to that of a unit strain, at these unknowns and the fitted rotations (method.md I7).
    double residual(const Eigen::MatrixXd& unknowns) const;
    /// What the energy's rounding noise is relative to [mm²].
    double energy_scale() const { return energy_scale_; }
    /// The energy without the cancellation of the local step's formula, as far as that can be had.
    virtual double exact_energy(const Eigen::MatrixXd& unknowns) const = 0;

protected:
    LocalGlobalSystem() = default;
    /// Rejected when a vertex hangs on no constraint; not converged when K cannot be factorised.
    Result<void> set_up(const Mesh& rest, const Eigen::SparseMatrix<double>& K, const std::vector<int>& constrained);
    /// b of K x = b for the fitted rotations, n×3.
    virtual Positions forces() const = 0;
    const Elimination& elimination() const { return elimination_; }

    Mesh rest_;
    std::vector<Eigen::Matrix3d> rotations_;
    double energy_scale_ = 0;
    double force_scale_ = 0;

private:
    Elimination elimination_;
};

/// Rejected when a triangle of `rest` has no area (place named).
Result<void> check_triangles(const Mesh& rest);

/// Local/global iterations with Anderson acceleration (Peng et al. 2018; method.md I3) until the estimate of the error
/// is below the tolerance. `targets` has one row per constrained vertex; `start` (n×3) replaces the harmonic start.
/// Not reaching the tolerance is no error: see `converged`. Cancelled through `progress`.
Result<DeformationResult> iterate(LocalGlobalSystem& system, const Positions& targets, const IterationOptions& options,
                                  const std::optional<Positions>& start, const Progress& progress);

/// The same from the making of the system on, which counts in `seconds`. `make` returns a Result of some system.
template <class Make>
Result<DeformationResult> make_and_iterate(const Make& make, const Positions& targets, const IterationOptions& options,
                                           const std::optional<Positions>& start, const Progress& progress)
{
    const auto begin = std::chrono::steady_clock::now();
    auto system = make();
    if (!system) {
        return tl::unexpected(system.error());
    }
    auto result = iterate(*system, targets, options, start, progress);
    if (result) {
        result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    return result;
}

} // namespace tapeline
