// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/linear_frames.h"

#include "kernel/baselines/spokes_system.h"
#include "kernel/deformation.h"
#include "kernel/parallel.h"

#include <chrono>

namespace tapeline {

namespace {

class LinearFrameSystem final : public SpokesSystem {
public:
    static Result<LinearFrameSystem> create(const Mesh& rest, const std::vector<int>& constrained)
    {
        LinearFrameSystem system;
        return system.set_up(rest, constrained).map([&] { return std::move(system); });
    }

    /// First system: the given turns' harmonic extension, made rotations.
    void spread(const std::vector<Eigen::Matrix3d>& turns)
    {
        Eigen::MatrixXd given(static_cast<Eigen::Index>(turns.size()), 9);
        for (size_t i = 0; i < turns.size(); ++i) {
            given.row(static_cast<Eigen::Index>(i)) = turns[i].reshaped().transpose();
            rotations_[constrained_vertices()[i]] = turns[i];
        }
        const Eigen::MatrixXd spread = elimination().response(given);
        parallel_for(free_count(),
                     [&](int i) { rotations_[free_vertices()[i]] = polar_rotation(spread.row(i).reshaped(3, 3)); });
    }

    /// Size of the step that iterative refinement would still take [mm].
    double refinement(const Eigen::MatrixXd& x) const
    {
        return x.rows() == 0
                   ? 0
                   : elimination().correction(elimination().residual(x, forces())).rowwise().norm().maxCoeff();
    }
};

} // namespace

Result<DeformationResult> deform_linear_frames(const Mesh& rest, const std::vector<int>& constrained,
                                               const Positions& targets, const std::vector<Eigen::Matrix3d>& turns,
                                               const Progress& progress)
{
    if (turns.size() != constrained.size()) {
        return fail(ErrorKind::usage, "every constrained vertex needs a turn of its frame");
    }
    const auto begin = std::chrono::steady_clock::now();
    auto system = LinearFrameSystem::create(rest, constrained);
    if (!system) {
        return tl::unexpected(system.error());
    }
    system->constrain(targets);
    system->spread(turns);
    if (!progress.report(0.5, "deform")) {
        return fail(ErrorKind::cancelled, "the deformation was cancelled");
    }
    const Eigen::MatrixXd x = system->solve_positions();
    DeformationResult result;
    result.V = system->assemble(x);
    if (!result.V.allFinite()) {
        return fail(ErrorKind::not_converged, "the deformation left the range of numbers: the region's triangles are "
                                              "too thin, remesh it (--max-edge)");
    }
    result.iterations = 1;
    result.error_estimate_mm = system->refinement(x);
    result.residual = system->residual(x);
    result.energy = system->exact_energy(x);
    result.converged = result.error_estimate_mm <= 1e-9 * rotation_free_size(rest.V);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace tapeline
