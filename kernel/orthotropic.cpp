// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/orthotropic.h"

#include "kernel/linear_solver.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tapeline {

namespace {

Eigen::Matrix2d material_metric(const Material& material, const Eigen::Matrix<double, 3, 2>& basis)
{
    const Eigen::Vector2d p = basis.transpose() * material.stiff_direction;
    const double excess = material.stiffness_ratio - 1;
    const Eigen::Matrix2d pp = p * p.transpose();
    if (material.stiff == Stiff::along) {
        return Eigen::Matrix2d::Identity() + excess * pp;
    }
    return Eigen::Matrix2d::Identity() - excess / (1 + excess * p.squaredNorm()) * pp;
}

} // namespace

std::vector<TriangleElement> triangle_elements(const Mesh& rest, const Material& material)
{
    std::vector<TriangleElement> elements(rest.F.rows());
    for (int t = 0; t < rest.F.rows(); ++t) {
        const Vec3 p = rest.V.row(rest.F(t, 0));
        const Vec3 e1 = Vec3(rest.V.row(rest.F(t, 1))) - p;
        const Vec3 e2 = Vec3(rest.V.row(rest.F(t, 2))) - p;
        const Vec3 normal = e1.cross(e2);
        TriangleElement& element = elements[t];
        element.area = 0.5 * normal.norm();
        element.basis.col(0) = e1.normalized();
        element.basis.col(1) = normal.normalized().cross(element.basis.col(0));
        Eigen::Matrix2d edges;
        edges.col(0) = element.basis.transpose() * e1;
        edges.col(1) = element.basis.transpose() * e2;
        const Eigen::Matrix2d inverse = edges.inverse();
        element.gradient.col(1) = inverse.row(0).transpose();
        element.gradient.col(2) = inverse.row(1).transpose();
        element.gradient.col(0) = -element.gradient.col(1) - element.gradient.col(2);
        element.material = material_metric(material, element.basis);
    }
    return elements;
}

Eigen::SparseMatrix<double> stiffness_matrix(const Mesh& rest, const std::vector<TriangleElement>& elements)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * elements.size());
    for (size_t t = 0; t < elements.size(); ++t) {
        const TriangleElement& element = elements[t];
        const Eigen::Matrix3d local = element.area * element.gradient.transpose() * element.material * element.gradient;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                entries.emplace_back(rest.F(t, i), rest.F(t, j), 0.5 * (local(i, j) + local(j, i)));
            }
        }
    }
    Eigen::SparseMatrix<double> K(rest.V.rows(), rest.V.rows());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

Eigen::MatrixXd harmonic_extension(const Eigen::SparseMatrix<double>& K, const std::vector<int>& constrained,
                                   const Eigen::MatrixXd& values)
{
    const int n = static_cast<int>(K.rows());
    Eigen::MatrixXd X = Eigen::MatrixXd::Zero(n, values.cols());
    std::vector<int> unknown(n, 0);
    for (size_t i = 0; i < constrained.size(); ++i) {
        X.row(constrained[i]) = values.row(static_cast<Eigen::Index>(i));
        unknown[constrained[i]] = -1;
    }
    // Only what hangs together with a constraint has an answer; the rest stays zero.
    std::vector<int> front(constrained.begin(), constrained.end());
    std::vector<char> reached(n, 0);
    for (const int v : front) {
        reached[v] = 1;
    }
    while (!front.empty()) {
        const int v = front.back();
        front.pop_back();
        for (Eigen::SparseMatrix<double>::InnerIterator it(K, v); it; ++it) {
            if (!reached[it.row()]) {
                reached[it.row()] = 1;
                front.push_back(static_cast<int>(it.row()));
            }
        }
    }
    int count = 0;
    for (int v = 0; v < n; ++v) {
        unknown[v] = unknown[v] == 0 && reached[v] ? count++ : -1;
    }
    if (count == 0) {
        return X;
    }
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(count, values.cols());
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < n; ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it) {
            const int row = unknown[it.row()];
            if (row < 0) {
                continue;
            }
            if (unknown[column] >= 0) {
                entries.emplace_back(row, unknown[column], it.value());
            } else {
                B.row(row) -= it.value() * X.row(column);
            }
        }
    }
    Eigen::SparseMatrix<double> free(count, count);
    free.setFromTriplets(entries.begin(), entries.end());
    CholeskySolver solver;
    if (!solver.factorize(free)) {
        return X;
    }
    const Eigen::MatrixXd solution = solver.solve(B);
    for (int v = 0; v < n; ++v) {
        if (unknown[v] >= 0) {
            X.row(v) = solution.row(unknown[v]);
        }
    }
    return X;
}

} // namespace tapeline
