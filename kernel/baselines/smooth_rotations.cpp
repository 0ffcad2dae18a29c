// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/smooth_rotations.h"

#include "kernel/baselines/spokes_system.h"
#include "kernel/deformation.h"
#include "kernel/linear_solver.h"
#include "kernel/parallel.h"

#include <Eigen/Geometry>

namespace tapeline {

namespace {

Eigen::Matrix3d rotation_by(const Vec3& axis)
{
    const double angle = axis.norm();
    return angle > 0 ? Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
}

class SmoothRotationSystem final : public SpokesSystem {
public:
    static Result<SmoothRotationSystem> create(const Mesh& rest, const std::vector<int>& constrained, double smoothness)
    {
        SmoothRotationSystem system;
        return system.set_up(rest, constrained).and_then([&] { return system.couple(smoothness); }).map([&] {
            return std::move(system);
        });
    }

    double fit_rotations(const Eigen::MatrixXd& unknowns) override;
    double exact_energy(const Eigen::MatrixXd& unknowns) const override;
    bool descends() const override { return false; }

private:
    Result<void> couple(double smoothness);
    double misfit(const std::vector<Eigen::Matrix3d>& M, const std::vector<Eigen::Matrix3d>& R) const;
    Eigen::MatrixXd descent(const std::vector<Eigen::Matrix3d>& M) const;
    int neighbours(int v) const { return static_cast<int>(edges_at(v).size()); }
    int other(int e, int v) const { return edges_[e].a == v ? edges_[e].b : edges_[e].a; }

    double coupling_ = 0; ///< α A
    CholeskySolver curvature_;
};

Result<void> SmoothRotationSystem::couple(double smoothness)
{
    double area = 0;
    for (int t = 0; t < rest_.F.rows(); ++t) {
        area += triangle_area(rest_, t);
    }
    coupling_ = smoothness * area;
    // The rotations' second derivative at rest: 2 α A times the graph Laplacian, and |N(i)| times that of the fit,
    // whose three eigenvalues tr C - c lie between half of tr C and tr C on a flat cell; their middle is taken.
    const int n = static_cast<int>(rest_.V.rows());
    std::vector<WeightedEdge> graph = edges_;
    std::vector<double> mass(n, 0);
    for (WeightedEdge& e : graph) {
        const double length2 = (rest_.V.row(e.a) - rest_.V.row(e.b)).squaredNorm();
        for (const int v : {e.a, e.b}) {
            mass[v] += 0.75 * neighbours(v) * e.weight * length2;
        }
        e.weight = 2 * coupling_;
    }
    Eigen::SparseMatrix<double> H = edge_laplacian(n, graph);
    for (int v = 0; v < n; ++v) {
        H.coeffRef(v, v) += mass[v];
    }
    if (!curvature_.factorize(H)) {
        return fail(ErrorKind::not_converged, "the rotations' stiffness cannot be factorised because the region's "
                                              "triangles are too thin: remesh the region (--max-edge)");
    }
    return {};
}

/// -Σ_i tr(R_iᵀ M_i) - α A Σ_edges tr(R_iᵀ R_j), M_i = |N(i)| S_i: what the coupled rotations minimise.
double SmoothRotationSystem::misfit(const std::vector<Eigen::Matrix3d>& M, const std::vector<Eigen::Matrix3d>& R) const
{
    double sum = 0;
    for (const WeightedEdge& e : edges_) {
        sum -= coupling_ * R[e.a].cwiseProduct(R[e.b]).sum();
    }
    for (size_t v = 0; v < M.size(); ++v) {
        sum -= R[v].cwiseProduct(M[v]).sum();
    }
    return sum;
}

/// Rotation vectors, one row a vertex, of a Newton step with the second derivative at rest.
Eigen::MatrixXd SmoothRotationSystem::descent(const std::vector<Eigen::Matrix3d>& M) const
{
    Eigen::MatrixXd torque(static_cast<Eigen::Index>(M.size()), 3);
    parallel_for(static_cast<int>(M.size()), [&](int v) {
        Eigen::Matrix3d pull = M[v];
        for (const int e : edges_at(v)) {
            pull += coupling_ * rotations_[other(e, v)];
        }
        const Eigen::Matrix3d B = pull * rotations_[v].transpose();
        torque.row(v) << B(2, 1) - B(1, 2), B(0, 2) - B(2, 0), B(1, 0) - B(0, 1);
    });
    return curvature_.solve(torque);
}

double SmoothRotationSystem::fit_rotations(const Eigen::MatrixXd& unknowns)
{
    constexpr int max_steps = 200;
    std::vector<Eigen::Matrix3d> M = moments(assemble(unknowns));
    for (size_t v = 0; v < M.size(); ++v) {
        M[v] *= neighbours(static_cast<int>(v));
    }
    double value = misfit(M, rotations_);
    const double noise = 1e-13 * std::abs(value);
    std::vector<Eigen::Matrix3d> turned(rotations_.size());
    for (int step = 0; step < max_steps; ++step) {
        const Eigen::MatrixXd direction = descent(M);
        double share = 1, turned_value = 0;
        do {
            parallel_for(static_cast<int>(turned.size()),
                         [&](int v) { turned[v] = rotation_by(share * direction.row(v).transpose()) * rotations_[v]; });
            turned_value = misfit(M, turned);
            share /= 2;
        } while (turned_value > value + noise && share > 1e-6);
        if (turned_value > value + noise) {
            break;
        }
        std::swap(rotations_, turned);
        value = turned_value;
        if (direction.rowwise().norm().maxCoeff() < 1e-12) {
            break;
        }
    }
    // Products of many rotations drift away from being one.
    parallel_for(static_cast<int>(rotations_.size()), [&](int v) { rotations_[v] = polar_rotation(rotations_[v]); });
    return value;
}

double SmoothRotationSystem::exact_energy(const Eigen::MatrixXd& unknowns) const
{
    double energy = SpokesSystem::exact_energy(unknowns);
    for (const WeightedEdge& e : edges_) {
        const double share = 0.5 / neighbours(e.a) + 0.5 / neighbours(e.b);
        energy += coupling_ * share * (rotations_[e.a] - rotations_[e.b]).squaredNorm();
    }
    return energy;
}

} // namespace

Result<DeformationResult> deform_smooth_rotations(const Mesh& rest, const std::vector<int>& constrained,
                                                  const Positions& targets, const SmoothRotationOptions& options,
                                                  const std::optional<Positions>& start, const Progress& progress)
{
    if (!(options.smoothness >= 0)) {
        return fail(ErrorKind::usage, "the smoothness of the rotations must be 0 or more");
    }
    return make_and_iterate([&] { return SmoothRotationSystem::create(rest, constrained, options.smoothness); },
                            targets, options, start, progress);
}

} // namespace tapeline
