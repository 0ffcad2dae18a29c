// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/placement.h"
#include "kernel/retraction_steps.h"

#include <algorithm>
#include <cmath>

namespace tapeline {

namespace {

constexpr int equalizing_rounds = 3;
/// A round that costs the worst triangle more than this share of what was left of it is not taken.
constexpr double may_lose = 0.02;
constexpr int smoothing_passes = 30;
/// Compression below this counts as this, so that one spoilt triangle does not stiffen without bound.
constexpr double least_compression = 0.05;

using Frames = std::vector<Eigen::Matrix3d>;

/// Unknowns per vertex: the three components of a vector, or one, the share along its rail.
struct Unknowns {
    std::vector<int> first;             ///< of each vertex, and at last the number of all
    std::vector<Eigen::MatrixXd> basis; ///< 3×3 or 3×1, in the components of the vertex's frame

    Unknowns(const RetractionTask& task, const Frames& frames)
    {
        int count = 0;
        for (int v = 0; v < static_cast<int>(frames.size()); ++v) {
            const bool railed = task.rails().slides(v);
            first.push_back(count);
            basis.emplace_back(railed ? Eigen::MatrixXd(frames[v].transpose() * task.rails().tangent(v))
                                      : Eigen::MatrixXd(Eigen::Matrix3d::Identity()));
            count += railed ? 1 : 3;
        }
        first.push_back(count);
    }
    int size(int v) const { return first[v + 1] - first[v]; }
};

/// The stiffness of all components together, which the rails couple.
Eigen::SparseMatrix<double> railed_stiffness(const Eigen::SparseMatrix<double>& K, const Unknowns& unknowns)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * static_cast<size_t>(K.nonZeros()));
    for (int column = 0; column < K.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it) {
            const int row = static_cast<int>(it.row());
            const Eigen::MatrixXd block = it.value() * unknowns.basis[row].transpose() * unknowns.basis[column];
            for (int i = 0; i < block.rows(); ++i) {
                for (int j = 0; j < block.cols(); ++j) {
                    if (block(i, j) != 0) {
                        entries.emplace_back(unknowns.first[row] + i, unknowns.first[column] + j, block(i, j));
                    }
                }
            }
        }
    }
    Eigen::SparseMatrix<double> all(unknowns.first.back(), unknowns.first.back());
    all.setFromTriplets(entries.begin(), entries.end());
    return all;
}

/// As `harmonic_extension` of n×6 values (two vectors per vertex), where the vectors of vertices on rails may only point
/// along them.
Eigen::MatrixXd railed_extension(const RetractionTask& task, const Frames& frames, const Eigen::SparseMatrix<double>& K,
                                 const std::vector<int>& constrained, const Eigen::MatrixXd& values)
{
    const Unknowns unknowns(task, frames);
    std::vector<int> rows;
    Eigen::MatrixXd given(3 * values.rows(), 2);
    for (size_t i = 0; i < constrained.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto row = static_cast<Eigen::Index>(i);
            given.row(static_cast<Eigen::Index>(rows.size())) << values(row, k), values(row, 3 + k);
            rows.push_back(unknowns.first[constrained[i]] + k);
        }
    }
    const Eigen::MatrixXd solved = harmonic_extension(railed_stiffness(K, unknowns), rows, given);
    Eigen::MatrixXd u(static_cast<Eigen::Index>(frames.size()), 6);
    for (int v = 0; v < u.rows(); ++v) {
        const Eigen::MatrixXd both = unknowns.basis[v] * solved.middleRows(unknowns.first[v], unknowns.size(v));
        u.row(v) << both.col(0).transpose(), both.col(1).transpose();
    }
    return u;
}

/// n×6, per vertex its move in space and its arc along the surface: the harmonic extension, in the components of the
/// frames, of what the line, the free borders and the rim do.
Eigen::MatrixXd extend(const RetractionTask& task, const std::vector<TriangleElement>& elements, const Frames& frames)
{
    const Mesh& inner = task.inner();
    std::vector<int> constrained;
    for (int v = 0; v < inner.V.rows(); ++v) {
        if (!task.free(v)) {
            constrained.push_back(v);
        }
    }
    Eigen::MatrixXd values(static_cast<Eigen::Index>(constrained.size()), 6);
    for (size_t i = 0; i < constrained.size(); ++i) {
        const int v = constrained[i], entry = task.line_entry(v);
        const Vec3 shift = task.start().row(v) - inner.V.row(v);
        const Vec3 u = entry >= 0 ? task.moves()[entry] : shift, arc = entry >= 0 ? task.arcs()[entry] : shift;
        values.row(static_cast<Eigen::Index>(i)) << u.transpose() * frames[v], arc.transpose() * frames[v];
    }
    const Eigen::SparseMatrix<double> K = stiffness_matrix(inner, elements);
    Eigen::MatrixXd u = task.rails().empty() ? harmonic_extension(K, constrained, values)
                                             : railed_extension(task, frames, K, constrained, values);
    for (int v = 0; v < u.rows(); ++v) {
        u.row(v).head<3>() *= frames[v].transpose();
        u.row(v).tail<3>() *= frames[v].transpose();
    }
    return u;
}

void place_all(const RetractionTask& task, const Eigen::MatrixXd& u, const std::vector<int>& vertices, Positions& V)
{
    parallel_for(static_cast<int>(vertices.size()), [&](int i) {
        const int v = vertices[i];
        const Vec3 move = u.row(v).head<3>(), arc = u.row(v).tail<3>();
        if (!move.isZero(0) || !arc.isZero(0)) {
            V.row(v) = task.place(v, move, arc);
        }
    });
}

std::vector<int> free_vertices(const RetractionTask& task)
{
    std::vector<int> free;
    for (int v = 0; v < task.inner().V.rows(); ++v) {
        if (task.free(v)) {
            free.push_back(v);
        }
    }
    return free;
}

/// The free vertices within `rings` rings of the listed triangles, ascending.
std::vector<int> patch(const RetractionTask& task, const std::vector<int>& faces, int rings)
{
    const Triangles& F = task.inner().F;
    std::vector<char> in(task.inner().V.rows(), 0);
    for (const int t : faces) {
        in[F(t, 0)] = in[F(t, 1)] = in[F(t, 2)] = 1;
    }
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<char> before = in;
        for (const MeshEdge& edge : task.topology().edges()) {
            in[edge.a] |= before[edge.b];
            in[edge.b] |= before[edge.a];
        }
    }
    std::vector<int> vertices;
    for (int v = 0; v < static_cast<int>(in.size()); ++v) {
        if (in[v] && task.free(v)) {
            vertices.push_back(v);
        }
    }
    return vertices;
}

/// Per triangle how much of its length is left in the direction of strongest compression: the smaller singular value
/// of the map from rest to V, in [least_compression, 1].
std::vector<double> compressions(const Mesh& inner, const std::vector<TriangleElement>& elements, const Positions& V,
                                 const FoldReport& folds)
{
    std::vector<double> left(inner.F.rows());
    for (int t = 0; t < inner.F.rows(); ++t) {
        Eigen::Matrix3d X;
        for (int k = 0; k < 3; ++k) {
            X.col(k) = V.row(inner.F(t, k));
        }
        const Eigen::Matrix<double, 3, 2> J = X * elements[t].gradient.transpose();
        const Eigen::Matrix2d C = J.transpose() * J;
        const double half = 0.5 * C.trace(), det = std::max(0.0, C.determinant());
        const double largest = half + std::sqrt(std::max(0.0, half * half - det));
        left[t] = std::clamp(largest > 0 ? std::sqrt(det / largest) : 0, least_compression, 1.0);
    }
    for (const int t : folds.flipped) {
        left[t] = least_compression;
    }
    return left;
}

struct Attempt {
    Eigen::MatrixXd u;
    Positions V;
    FoldReport folds;
    std::vector<double> left;

    double least() const { return left.empty() ? 1 : *std::ranges::min_element(left); }
    bool better_than(const Attempt& other) const
    {
        const size_t mine = folds.flipped.size(), theirs = other.folds.flipped.size();
        return mine < theirs || (mine == theirs && least() > other.least() * (1 + 1e-9));
    }
    /// How much of this attempt to take after `last`: all where its worst triangle keeps as much, nothing where it loses
    /// clearly more; in between gradually, for the next slide may differ by little.
    double worth(const Attempt& last) const
    {
        const size_t mine = folds.flipped.size(), theirs = last.folds.flipped.size();
        if (mine != theirs) {
            return mine < theirs ? 1 : 0;
        }
        return smooth_step(least() / last.least(), 1 - may_lose, 1);
    }
};

/// How much stiffer a round makes a triangle of whose length this share is left.
double strongly(double left) { return 1 / left; }

/// Where a triangle has more of its length left than this, a calm round is a strong one.
constexpr double alike = 0.5;

/// Along a row of springs the compression c = 1 - left is force over stiffness, and stiffness · c makes it even in one
/// round. 1 / left does more than that from c = 1/2 on, and overshoots where all is compressed; below it is the calmer.
double calmly(double left) { return left > alike ? 1 / left : (1 - left) / (alike * alike); }

/// Extends, places, and equalises: the linear extension spreads displacement evenly but not compression, which is worst
/// where the line turns most (the material shears there as well). Each round stiffens the compressed triangles, strongly
/// or, where that overshoots, calmly, so that they pass the compression on.
class Equalizer {
public:
    Equalizer(const RetractionTask& task, const Material& material, const Frames& frames)
        : task_(task), frames_(frames), own_(triangle_elements(task.inner(), material)), vertices_(free_vertices(task))
    {
    }

    Attempt run() const
    {
        std::vector<double> stiffness(own_.size(), 1);
        Attempt last = extended(stiffness), taken = last;
        double share = 1;
        for (int round = 0; round < equalizing_rounds && share > 0; ++round) {
            std::vector<double> stiffer = stiffened(stiffness, last, 1);
            Attempt next = extended(stiffer);
            if (const double worth = next.worth(last); worth < 1 && last.least() < alike) {
                next = extended(stiffer = stiffened(stiffness, last, worth));
            }
            stiffness = std::move(stiffer);
            share *= next.worth(last);
            if (share > 0) {
                taken = share == 1 ? next : placed(taken.u + share * (next.u - taken.u));
            }
            last = std::move(next);
        }
        return taken;
    }

private:
    /// By that share of a strong round, the rest of it calm.
    static std::vector<double> stiffened(std::vector<double> stiffness, const Attempt& last, double strong)
    {
        for (size_t t = 0; t < stiffness.size(); ++t) {
            const double left = last.left[t];
            stiffness[t] *= std::pow(strongly(left), strong) * std::pow(calmly(left), 1 - strong);
        }
        return stiffness;
    }

    Attempt extended(const std::vector<double>& stiffness) const
    {
        std::vector<TriangleElement> elements = own_;
        for (size_t t = 0; t < elements.size(); ++t) {
            elements[t].material *= stiffness[t];
        }
        return placed(extend(task_, elements, frames_));
    }

    Attempt placed(Eigen::MatrixXd u) const
    {
        Attempt attempt{std::move(u), task_.start(), {}, {}};
        place_all(task_, attempt.u, vertices_, attempt.V);
        attempt.folds = find_folds(task_.inner(), attempt.V);
        attempt.left = compressions(task_.inner(), own_, attempt.V, attempt.folds);
        return attempt;
    }

    const RetractionTask& task_;
    const Frames& frames_;
    std::vector<TriangleElement> own_;
    std::vector<int> vertices_;
};

/// Averages the displacement over neighbours, around folded triangles only, until they are open or nothing helps.
Attempt smoothed(const RetractionTask& task, const Attempt& folded)
{
    const std::vector<TriangleElement> elements = triangle_elements(task.inner(), {});
    Attempt best = folded, current = folded;
    for (int pass = 0; pass < smoothing_passes && !current.folds.flipped.empty(); ++pass) {
        const std::vector<int> vertices = patch(task, current.folds.flipped, 2);
        const Eigen::MatrixXd before = current.u;
        for (const int v : vertices) {
            Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(before.cols());
            const auto around = task.topology().vertex_edges(v);
            for (const int e : around) {
                sum += before.row(task.topology().other_end(e, v));
            }
            current.u.row(v) = sum / static_cast<double>(around.size());
        }
        place_all(task, current.u, vertices, current.V);
        current.folds = find_folds(task.inner(), current.V);
        current.left = compressions(task.inner(), elements, current.V, current.folds);
        if (current.better_than(best)) {
            best = current;
        }
    }
    return best;
}

} // namespace

Positions retract_harmonic(const RetractionTask& task, const Material& material)
{
    const Frames frames = parallel_frames(task);
    Attempt best = Equalizer(task, material, frames).run();
    const auto try_again = [&](const Material& other_material, const Frames& other_frames) {
        if (best.folds.flipped.empty()) {
            return;
        }
        if (Attempt next = Equalizer(task, other_material, other_frames).run(); next.better_than(best)) {
            best = std::move(next);
        }
    };
    // Frames carried over a surface that closes round itself must part somewhere.
    try_again(material, Frames(frames.size(), Eigen::Matrix3d::Identity()));
    // A softer fibre couples neighbours more: it spreads a fold. Isotropic last, being the worst elsewhere (A2).
    Material softer = material;
    softer.stiffness_ratio = std::max(1.0, std::sqrt(material.stiffness_ratio));
    try_again(softer, frames);
    softer.stiffness_ratio = 1;
    try_again(softer, frames);
    return best.folds.flipped.empty() ? best.V : smoothed(task, best).V;
}

} // namespace tapeline
