// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/asan_system.h"

#include "kernel/parallel.h"

#include <Eigen/LU>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

std::string place(const Mesh& mesh, int v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
}

/// First vertex that no path of K's non-zeros joins to a constraint; -1 when there is none.
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

} // namespace

Result<AsanSystem> AsanSystem::create(const Mesh& rest, const std::vector<int>& constrained, const Material& material)
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
    const int n = static_cast<int>(rest.V.rows());
    if (const int v = unreached_vertex(rest.F, n, constrained); v >= 0) {
        return fail(ErrorKind::rejected,
                    fmt::format("a part of the region at {} mm touches neither the line nor a fixed rim, so nothing "
                                "holds it: choose a region that is one piece",
                                place(rest, v)));
    }

    AsanSystem system;
    system.rest_ = rest;
    system.elements_ = triangle_elements(rest, material);
    system.constrained_ = constrained;
    system.unknown_of_.assign(n, 0);
    for (size_t i = 0; i < constrained.size(); ++i) {
        system.unknown_of_[constrained[i]] = -1 - static_cast<int>(i);
    }
    for (int v = 0; v < n; ++v) {
        if (system.unknown_of_[v] >= 0) {
            system.unknown_of_[v] = system.free_count();
            system.free_.push_back(v);
        }
    }
    system.rotations_.assign(n, Eigen::Matrix3d::Identity());
    system.build_incidence();

    const Eigen::SparseMatrix<double> K = stiffness_matrix(rest, system.elements_);
    std::vector<Eigen::Triplet<double>> free_entries, coupling_entries;
    for (int column = 0; column < n; ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it) {
            const int row = system.unknown_of_[it.row()];
            const int other = system.unknown_of_[column];
            if (row >= 0 && other >= 0) {
                free_entries.emplace_back(row, other, it.value());
            } else if (row >= 0) {
                coupling_entries.emplace_back(row, -1 - other, it.value());
            }
        }
    }
    system.K_free_.resize(system.free_count(), system.free_count());
    system.K_free_.setFromTriplets(free_entries.begin(), free_entries.end());
    system.K_coupling_.resize(system.free_count(), static_cast<Eigen::Index>(constrained.size()));
    system.K_coupling_.setFromTriplets(coupling_entries.begin(), coupling_entries.end());
    if (system.free_count() > 0 && !system.solver_.factorize(system.K_free_)) {
        return fail(ErrorKind::not_converged,
                    "the region's stiffness matrix cannot be factorised because its triangles "
                    "are too thin: remesh the region (--max-edge)");
    }
    return system;
}

void AsanSystem::build_incidence()
{
    const int n = static_cast<int>(rest_.V.rows());
    corner_start_.assign(n + 1, 0);
    for (int t = 0; t < rest_.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            ++corner_start_[rest_.F(t, k) + 1];
        }
    }
    std::partial_sum(corner_start_.begin(), corner_start_.end(), corner_start_.begin());
    corners_.resize(corner_start_.back());
    std::vector<int> next(corner_start_.begin(), corner_start_.end() - 1);
    for (int t = 0; t < rest_.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            corners_[next[rest_.F(t, k)]++] = {t, k};
        }
    }
    std::vector<double> force(n, 0);
    for (int t = 0; t < rest_.F.rows(); ++t) {
        const TriangleElement& element = elements_[t];
        energy_scale_ += element.area * element.material.trace();
        for (int k = 0; k < 3; ++k) {
            force[rest_.F(t, k)] += element.area * (element.material * element.gradient.col(k)).norm();
        }
    }
    for (const double f : force) {
        force_scale_ += f * f;
    }
    force_scale_ = std::sqrt(force_scale_);
}

void AsanSystem::constrain(const Positions& targets) { targets_ = targets; }

Positions AsanSystem::assemble(const Eigen::MatrixXd& unknowns) const
{
    Positions V(rest_.V.rows(), 3);
    for (int i = 0; i < free_count(); ++i) {
        V.row(free_[i]) = unknowns.row(i);
    }
    for (size_t i = 0; i < constrained_.size(); ++i) {
        V.row(constrained_[i]) = targets_.row(static_cast<Eigen::Index>(i));
    }
    return V;
}

Eigen::MatrixXd AsanSystem::extract(const Positions& V) const
{
    Eigen::MatrixXd unknowns(free_count(), 3);
    for (int i = 0; i < free_count(); ++i) {
        unknowns.row(i) = V.row(free_[i]);
    }
    return unknowns;
}

Eigen::MatrixXd AsanSystem::harmonic_start(const Positions& from) const
{
    Eigen::MatrixXd displacement(static_cast<Eigen::Index>(constrained_.size()), 3);
    for (size_t i = 0; i < constrained_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        displacement.row(row) = targets_.row(row) - from.row(constrained_[i]);
    }
    if (free_count() == 0) {
        return Eigen::MatrixXd(0, 3);
    }
    return extract(from) - solver_.solve(K_coupling_ * displacement);
}

Eigen::Matrix<double, 3, 2> AsanSystem::gradient(const Positions& V, int t) const
{
    Eigen::Matrix3d X;
    for (int k = 0; k < 3; ++k) {
        X.col(k) = V.row(rest_.F(t, k)).transpose();
    }
    // Differences to the first corner keep the digits that large coordinates would cost.
    X.col(1) -= X.col(0);
    X.col(2) -= X.col(0);
    return X.rightCols<2>() * elements_[t].gradient.rightCols<2>().transpose();
}

double AsanSystem::fit_rotations(const Eigen::MatrixXd& unknowns)
{
    const Positions V = assemble(unknowns);
    const int faces = static_cast<int>(rest_.F.rows());
    std::vector<Eigen::Matrix3d> moments(faces);
    std::vector<double> energies(faces);
    parallel_for(faces, [&](int t) {
        const TriangleElement& element = elements_[t];
        const Eigen::Matrix<double, 3, 2> JD = gradient(V, t) * element.material;
        moments[t] = element.area / 3 * JD * element.basis.transpose();
        energies[t] = element.area * (JD.cwiseProduct(gradient(V, t)).sum() + element.material.trace());
    });
    std::vector<double> fits(rest_.V.rows());
    parallel_for(static_cast<int>(rest_.V.rows()), [&](int v) {
        Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
        for (int c = corner_start_[v]; c < corner_start_[v + 1]; ++c) {
            S += moments[corners_[c].first];
        }
        rotations_[v] = polar_rotation(S);
        fits[v] = rotations_[v].cwiseProduct(S).sum();
    });
    return std::accumulate(energies.begin(), energies.end(), 0.0) - 2 * std::accumulate(fits.begin(), fits.end(), 0.0);
}

double AsanSystem::exact_energy(const Eigen::MatrixXd& unknowns) const
{
    const Positions V = assemble(unknowns);
    double energy = 0;
    for (int t = 0; t < rest_.F.rows(); ++t) {
        const TriangleElement& element = elements_[t];
        const Eigen::Matrix<double, 3, 2> J = gradient(V, t);
        for (int k = 0; k < 3; ++k) {
            const Eigen::Matrix<double, 3, 2> strain = J - rotations_[rest_.F(t, k)] * element.basis;
            energy += element.area / 3 * (strain * element.material).cwiseProduct(strain).sum();
        }
    }
    return energy;
}

Eigen::MatrixXd AsanSystem::right_hand_side() const
{
    const int faces = static_cast<int>(rest_.F.rows());
    std::vector<Eigen::Matrix3d> forces(faces);
    parallel_for(faces, [&](int t) {
        const TriangleElement& element = elements_[t];
        const Eigen::Matrix3d mean =
            (rotations_[rest_.F(t, 0)] + rotations_[rest_.F(t, 1)] + rotations_[rest_.F(t, 2)]) / 3;
        forces[t] = element.area * mean * element.basis * element.material * element.gradient;
    });
    Eigen::MatrixXd B(free_count(), 3);
    parallel_for(free_count(), [&](int i) {
        const int v = free_[i];
        Vec3 sum = Vec3::Zero();
        for (int c = corner_start_[v]; c < corner_start_[v + 1]; ++c) {
            sum += forces[corners_[c].first].col(corners_[c].second);
        }
        B.row(i) = sum.transpose();
    });
    B -= K_coupling_ * targets_;
    return B;
}

Eigen::MatrixXd AsanSystem::solve_positions() const
{
    return free_count() == 0 ? Eigen::MatrixXd(0, 3) : solver_.solve(right_hand_side());
}

double AsanSystem::residual(const Eigen::MatrixXd& unknowns) const
{
    return free_count() == 0 ? 0 : (K_free_ * unknowns - right_hand_side()).norm() / force_scale_;
}

} // namespace tapeline
