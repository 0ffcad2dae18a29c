// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/spokes.h"

#include "kernel/baselines/spokes_system.h"
#include "kernel/deformation.h"
#include "kernel/parallel.h"
#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

namespace tapeline {

std::vector<WeightedEdge> clamped_cotangents(const Mesh& mesh)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<WeightedEdge> edges;
    for (const MeshEdge& edge : topology.edges()) {
        edges.push_back({edge.a, edge.b, 0});
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 apex = mesh.V.row(mesh.F(t, (k + 2) % 3));
            const Vec3 to_a = Vec3(mesh.V.row(mesh.F(t, k))) - apex;
            const Vec3 to_b = Vec3(mesh.V.row(mesh.F(t, (k + 1) % 3))) - apex;
            const double cotangent = to_a.dot(to_b) / to_a.cross(to_b).norm();
            edges[topology.face_edges(t)[k]].weight += std::max(0.0, cotangent) / 2;
        }
    }
    return edges;
}

Eigen::SparseMatrix<double> edge_laplacian(int vertex_count, const std::vector<WeightedEdge>& edges)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * edges.size());
    for (const WeightedEdge& edge : edges) {
        entries.emplace_back(edge.a, edge.a, edge.weight);
        entries.emplace_back(edge.b, edge.b, edge.weight);
        entries.emplace_back(edge.a, edge.b, -edge.weight);
        entries.emplace_back(edge.b, edge.a, -edge.weight);
    }
    Eigen::SparseMatrix<double> K(vertex_count, vertex_count);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

Result<SpokesSystem> SpokesSystem::create(const Mesh& rest, const std::vector<int>& constrained)
{
    SpokesSystem system;
    return system.set_up(rest, constrained).map([&] { return std::move(system); });
}

Result<void> SpokesSystem::set_up(const Mesh& rest, const std::vector<int>& constrained)
{
    if (auto fine = check_triangles(rest); !fine) {
        return fine;
    }
    const int n = static_cast<int>(rest.V.rows());
    edges_ = clamped_cotangents(rest);
    edge_start_.assign(n + 1, 0);
    for (const WeightedEdge& edge : edges_) {
        ++edge_start_[edge.a + 1];
        ++edge_start_[edge.b + 1];
    }
    std::partial_sum(edge_start_.begin(), edge_start_.end(), edge_start_.begin());
    edge_list_.resize(edge_start_.back());
    std::vector<int> next(edge_start_.begin(), edge_start_.end() - 1);
    std::vector<double> force(n, 0);
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
        const WeightedEdge& edge = edges_[e];
        const double length = (rest.V.row(edge.a) - rest.V.row(edge.b)).norm();
        for (const int v : {edge.a, edge.b}) {
            edge_list_[next[v]++] = e;
            force[v] += edge.weight * length;
        }
        energy_scale_ += edge.weight * length * length;
    }
    for (const double f : force) {
        force_scale_ += f * f;
    }
    force_scale_ = std::sqrt(force_scale_);
    return LocalGlobalSystem::set_up(rest, edge_laplacian(n, edges_), constrained);
}

std::span<const int> SpokesSystem::edges_at(int v) const
{
    return std::span(edge_list_).subspan(edge_start_[v], edge_start_[v + 1] - edge_start_[v]);
}

std::vector<Eigen::Matrix3d> SpokesSystem::moments(const Positions& V) const
{
    std::vector<Eigen::Matrix3d> result(V.rows());
    parallel_for(static_cast<int>(V.rows()), [&](int v) {
        Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
        for (const int e : edges_at(v)) {
            const Vec3 now = V.row(edges_[e].a) - V.row(edges_[e].b);
            const Vec3 before = rest_.V.row(edges_[e].a) - rest_.V.row(edges_[e].b);
            S += edges_[e].weight * now * before.transpose();
        }
        result[v] = S;
    });
    return result;
}

double SpokesSystem::fit_rotations(const Eigen::MatrixXd& unknowns)
{
    const Positions V = assemble(unknowns);
    const std::vector<Eigen::Matrix3d> S = moments(V);
    double energy = 0;
    for (const WeightedEdge& edge : edges_) {
        energy += edge.weight * ((V.row(edge.a) - V.row(edge.b)).squaredNorm() +
                                 (rest_.V.row(edge.a) - rest_.V.row(edge.b)).squaredNorm());
    }
    parallel_for(static_cast<int>(S.size()), [&](int v) { rotations_[v] = polar_rotation(S[v]); });
    for (size_t v = 0; v < S.size(); ++v) {
        energy -= rotations_[v].cwiseProduct(S[v]).sum();
    }
    return energy;
}

double SpokesSystem::exact_energy(const Eigen::MatrixXd& unknowns) const
{
    const Positions V = assemble(unknowns);
    double energy = 0;
    for (const WeightedEdge& edge : edges_) {
        const Vec3 now = V.row(edge.a) - V.row(edge.b);
        const Vec3 before = rest_.V.row(edge.a) - rest_.V.row(edge.b);
        for (const int v : {edge.a, edge.b}) {
            energy += edge.weight / 2 * (now - rotations_[v] * before).squaredNorm();
        }
    }
    return energy;
}

Positions SpokesSystem::forces() const
{
    Positions B(rest_.V.rows(), 3);
    parallel_for(static_cast<int>(B.rows()), [&](int v) {
        Vec3 sum = Vec3::Zero();
        for (const int e : edges_at(v)) {
            const WeightedEdge& edge = edges_[e];
            const Vec3 before = rest_.V.row(edge.a) - rest_.V.row(edge.b);
            sum += (edge.a == v ? 0.5 : -0.5) * edge.weight * (rotations_[edge.a] + rotations_[edge.b]) * before;
        }
        B.row(v) = sum.transpose();
    });
    return B;
}

Result<DeformationResult> deform_spokes(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                        const IterationOptions& options, const std::optional<Positions>& start,
                                        const Progress& progress)
{
    return make_and_iterate([&] { return SpokesSystem::create(rest, constrained); }, targets, options, start, progress);
}

} // namespace tapeline
