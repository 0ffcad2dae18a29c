// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/rings.h"

#include "kernel/asan_system.h"
#include "kernel/baselines/ring_cells.h"

namespace tapeline {

namespace {

class RingSystem final : public AsanSystem {
public:
    static Result<RingSystem> create(const Mesh& rest, const std::vector<int>& constrained, const RingOptions& options)
    {
        if (auto fine = check_triangles(rest); !fine) {
            return tl::unexpected(fine.error());
        }
        RingSystem system(RingCells(rest, options.rings));
        std::vector<TriangleElement> elements = triangle_elements(rest, Material{1, Stiff::along, Vec3::UnitX()});
        if (options.weights == RingWeights::by_cell) {
            for (int t = 0; t < rest.F.rows(); ++t) {
                elements[t].area *= system.cells_.cells_of(t) / 3.0;
            }
        }
        return system.set_up(rest, constrained, std::move(elements)).map([&] { return std::move(system); });
    }

    double exact_energy(const Eigen::MatrixXd& unknowns) const override;

private:
    explicit RingSystem(RingCells cells) : cells_(std::move(cells)) {}

    std::vector<Eigen::Matrix3d> cell_sums(const std::vector<Eigen::Matrix3d>& moments) const override
    {
        std::vector<Eigen::Matrix3d> shares = moments;
        for (size_t t = 0; t < shares.size(); ++t) {
            shares[t] /= cells_.cells_of(static_cast<int>(t));
        }
        return cells_.sum_triangles(shares);
    }
    std::vector<Eigen::Matrix3d> mean_rotations() const override
    {
        std::vector<Eigen::Matrix3d> means = cells_.sum_vertices(rotations_);
        for (size_t t = 0; t < means.size(); ++t) {
            means[t] /= cells_.cells_of(static_cast<int>(t));
        }
        return means;
    }

    RingCells cells_;
};

/// The mean over a triangle's cells of |J - R E|² is |J - R̄ E|² and the rotations' own spread, 2 - |R̄ E|².
double RingSystem::exact_energy(const Eigen::MatrixXd& unknowns) const
{
    const Positions V = assemble(unknowns);
    const std::vector<Eigen::Matrix3d> means = mean_rotations();
    double energy = 0;
    for (int t = 0; t < rest_.F.rows(); ++t) {
        const Eigen::Matrix<double, 3, 2> turned = means[t] * elements_[t].basis;
        energy += elements_[t].area * ((gradient(V, t) - turned).squaredNorm() + 2 - turned.squaredNorm());
    }
    return energy;
}

} // namespace

Result<DeformationResult> deform_rings(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                       const RingOptions& options, const std::optional<Positions>& start,
                                       const Progress& progress)
{
    if (options.rings < 0) {
        return fail(ErrorKind::usage, "the number of rings must be 1 or more, or 0 for the whole region");
    }
    return make_and_iterate([&] { return RingSystem::create(rest, constrained, options); }, targets, options, start,
                            progress);
}

} // namespace tapeline
