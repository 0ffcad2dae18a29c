// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/local_global.h"

#include <span>
#include <vector>

namespace tapeline {

/// An edge of the mesh with its weight: half the sum of the opposite cotangents, negative ones taken as 0.
struct WeightedEdge {
    int a = -1;
    int b = -1;
    double weight = 0;
};

/// In ascending order of (a, b), a < b. Triangles must have positive area.
std::vector<WeightedEdge> clamped_cotangents(const Mesh& mesh);

/// K_ab = -w_ab off the diagonal, rows summing to zero.
Eigen::SparseMatrix<double> edge_laplacian(int vertex_count, const std::vector<WeightedEdge>& edges);

/// The spokes energy of Sorkine and Alexa with its constraints, factorised once.
class SpokesSystem : public LocalGlobalSystem {
public:
    /// Rejected when a triangle has no area, a vertex hangs on no constraint, or the matrix cannot be factorised.
    static Result<SpokesSystem> create(const Mesh& rest, const std::vector<int>& constrained);

    double fit_rotations(const Eigen::MatrixXd& unknowns) override;
    double exact_energy(const Eigen::MatrixXd& unknowns) const override;

protected:
    SpokesSystem() = default;
    Result<void> set_up(const Mesh& rest, const std::vector<int>& constrained);
    Positions forces() const override;

    /// Per vertex Σ_j w_ij (x_i - x_j)(p_i - p_j)ᵀ.
    std::vector<Eigen::Matrix3d> moments(const Positions& V) const;
    /// Edges at vertex v, as indices into `edges_`.
    std::span<const int> edges_at(int v) const;

    std::vector<WeightedEdge> edges_;

private:
    std::vector<int> edge_start_, edge_list_;
};

} // namespace tapeline
