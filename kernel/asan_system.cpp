// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/asan_system.h"

#include "kernel/parallel.h"

#include <cmath>
#include <numeric>

namespace tapeline {

Result<AsanSystem> AsanSystem::create(const Mesh& rest, const std::vector<int>& constrained, const Material& material)
{
    AsanSystem system;
    return check_triangles(rest)
        .and_then([&] { return system.set_up(rest, constrained, triangle_elements(rest, material)); })
        .map([&] { return std::move(system); });
}

Result<void> AsanSystem::set_up(const Mesh& rest, const std::vector<int>& constrained,
                                std::vector<TriangleElement> elements)
{
    elements_ = std::move(elements);
    auto done = LocalGlobalSystem::set_up(rest, stiffness_matrix(rest, elements_), constrained);
    build_incidence();
    return done;
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

std::vector<Eigen::Matrix3d> AsanSystem::cell_sums(const std::vector<Eigen::Matrix3d>& moments) const
{
    std::vector<Eigen::Matrix3d> sums(rest_.V.rows());
    parallel_for(static_cast<int>(rest_.V.rows()), [&](int v) {
        Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
        for (int c = corner_start_[v]; c < corner_start_[v + 1]; ++c) {
            S += moments[corners_[c].first];
        }
        sums[v] = S / 3;
    });
    return sums;
}

std::vector<Eigen::Matrix3d> AsanSystem::mean_rotations() const
{
    std::vector<Eigen::Matrix3d> means(rest_.F.rows());
    parallel_for(static_cast<int>(rest_.F.rows()), [&](int t) {
        means[t] = (rotations_[rest_.F(t, 0)] + rotations_[rest_.F(t, 1)] + rotations_[rest_.F(t, 2)]) / 3;
    });
    return means;
}

double AsanSystem::fit_rotations(const Eigen::MatrixXd& unknowns)
{
    const Positions V = assemble(unknowns);
    const int faces = static_cast<int>(rest_.F.rows());
    std::vector<Eigen::Matrix3d> moments(faces);
    std::vector<double> energies(faces);
    parallel_for(faces, [&](int t) {
        const TriangleElement& element = elements_[t];
        const Eigen::Matrix<double, 3, 2> J = gradient(V, t);
        const Eigen::Matrix<double, 3, 2> JD = J * element.material;
        moments[t] = element.area * JD * element.basis.transpose();
        energies[t] = element.area * (JD.cwiseProduct(J).sum() + element.material.trace());
    });
    const std::vector<Eigen::Matrix3d> sums = cell_sums(moments);
    std::vector<double> fits(rest_.V.rows());
    parallel_for(static_cast<int>(rest_.V.rows()), [&](int v) {
        rotations_[v] = polar_rotation(sums[v]);
        fits[v] = rotations_[v].cwiseProduct(sums[v]).sum();
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

Positions AsanSystem::forces() const
{
    const int faces = static_cast<int>(rest_.F.rows());
    const std::vector<Eigen::Matrix3d> means = mean_rotations();
    std::vector<Eigen::Matrix3d> by_corner(faces);
    parallel_for(faces, [&](int t) {
        const TriangleElement& element = elements_[t];
        by_corner[t] = element.area * means[t] * element.basis * element.material * element.gradient;
    });
    Positions B(rest_.V.rows(), 3);
    parallel_for(static_cast<int>(rest_.V.rows()), [&](int v) {
        Vec3 sum = Vec3::Zero();
        for (int c = corner_start_[v]; c < corner_start_[v + 1]; ++c) {
            sum += by_corner[corners_[c].first].col(corners_[c].second);
        }
        B.row(v) = sum.transpose();
    });
    return B;
}

} // namespace tapeline
