// SPDX-License-Identifier: GPL-3.0-or-later
// The solver against CGAL's deformer (same energy, same mesh, same constraints), and its rotations against Eigen's
// singular value decomposition. A counter "..._ratio" is the peer's time over ours: above 1, ours is faster.
#include "kernel/deformation.h"
#include "tests/benchmarks/seconds.h"
#include "tests/support/cgal_peer.h"
#include "tests/support/shapes.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <benchmark/benchmark.h>
#include <random>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

/// The panel pulled up along its crease: border fixed, crease 40 mm higher.
struct Pull {
    Mesh rest;
    std::vector<int> constrained;
    Positions targets;

    Pull(int nx, int ny) : rest(crease_panel(nx, ny))
    {
        std::vector<Vec3> goals;
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                const bool border = i == 0 || j == 0 || i == nx || j == ny;
                const bool line = j == ny / 2 && i > nx / 4 && i < 3 * nx / 4;
                if (border || line) {
                    constrained.push_back(j * (nx + 1) + i);
                    goals.push_back(Vec3(rest.V.row(constrained.back())) + Vec3(0, 0, line ? 40 : 0));
                }
            }
        }
        targets.resize(static_cast<Eigen::Index>(goals.size()), 3);
        for (std::size_t i = 0; i < goals.size(); ++i) {
            targets.row(static_cast<Eigen::Index>(i)) = goals[i];
        }
    }
};

/// Ours to its own error estimate of 0.05 mm; the peer for as many iterations as it takes to come equally near to the
/// minimiser, found by doubling.
void solver_against_cgal(benchmark::State& state)
{
    const Pull pull(static_cast<int>(state.range(0)), static_cast<int>(state.range(0)) * 3 / 4);
    DeformationOptions options;
    options.material.stiffness_ratio = 1;
    options.tolerance_mm = 0.05;
    DeformationOptions exact = options;
    exact.tolerance_mm = 1e-5;
    const Positions minimiser = deform(pull.rest, pull.constrained, pull.targets, exact)->V;
    int iterations = 4;
    while (iterations < 4096 &&
           (cgal_spokes_and_rims(pull.rest, pull.constrained, pull.targets, iterations) - minimiser)
                   .rowwise()
                   .norm()
                   .maxCoeff() > options.tolerance_mm) {
        iterations *= 2;
    }
    const double peer =
        seconds_of([&] { cgal_spokes_and_rims(pull.rest, pull.constrained, pull.targets, iterations); });
    double ours = 0;
    for (auto _ : state) {
        ours += seconds_of([&] {
            const auto solved = deform(pull.rest, pull.constrained, pull.targets, options);
            benchmark::DoNotOptimize(solved->V.data());
        });
    }
    state.counters["vertices"] = static_cast<double>(pull.rest.V.rows());
    state.counters["cgal_iterations"] = iterations;
    state.counters["cgal_ratio"] = peer / (ours / static_cast<double>(state.iterations()));
}
BENCHMARK(solver_against_cgal)->Name("solver_against_cgal/small")->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(solver_against_cgal)->Name("solver_against_cgal/large")->Arg(160)->Unit(benchmark::kMillisecond);

Eigen::Matrix3d svd_rotation(const Eigen::Matrix3d& S)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(S, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d U = svd.matrixU();
    if ((U * svd.matrixV().transpose()).determinant() < 0) {
        U.col(2) *= -1;
    }
    return U * svd.matrixV().transpose();
}

void rotation_against_svd(benchmark::State& state)
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<Eigen::Matrix3d> matrices(1000);
    for (auto& S : matrices) {
        S = Eigen::Matrix3d::NullaryExpr([&] { return normal(random); });
    }
    double ours = 0, peer = 0;
    for (auto _ : state) {
        ours += seconds_of([&] {
            for (const auto& S : matrices) {
                benchmark::DoNotOptimize(polar_rotation(S));
            }
        });
        peer += seconds_of([&] {
            for (const auto& S : matrices) {
                benchmark::DoNotOptimize(svd_rotation(S));
            }
        });
    }
    state.counters["svd_ratio"] = peer / ours;
}
BENCHMARK(rotation_against_svd);

} // namespace
