// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/deformation.h"
#include "kernel/local_global.h"

#include <utility>
#include <vector>

namespace tapeline {

/// The discretised ASAN energy with its constraints, factorised once (method.md B2, B5): per vertex one rotation, per
/// triangle the mean deviation from the rotations of its corners. Derived classes may share rotations more widely.
class AsanSystem : public LocalGlobalSystem {
public:
    /// Rejected when a triangle has no area, a vertex hangs on no constraint, or the matrix cannot be factorised.
    static Result<AsanSystem> create(const Mesh& rest, const std::vector<int>& constrained, const Material& material);

    double fit_rotations(const Eigen::MatrixXd& unknowns) override;
    double exact_energy(const Eigen::MatrixXd& unknowns) const override;

protected:
    AsanSystem() = default;
    Result<void> set_up(const Mesh& rest, const std::vector<int>& constrained, std::vector<TriangleElement> elements);
    Positions forces() const override;

    /// Per vertex the sum of `moments` over the triangles of its cell, each divided by the number of cells it is in.
    virtual std::vector<Eigen::Matrix3d> cell_sums(const std::vector<Eigen::Matrix3d>& moments) const;
    /// Per triangle the mean of the rotations of the cells that it is in.
    virtual std::vector<Eigen::Matrix3d> mean_rotations() const;

    Eigen::Matrix<double, 3, 2> gradient(const Positions& V, int t) const;

    std::vector<TriangleElement> elements_;

private:
    void build_incidence();

    std::vector<int> corner_start_;
    std::vector<std::pair<int, int>> corners_; ///< (triangle, corner) around each vertex
};

} // namespace tapeline
