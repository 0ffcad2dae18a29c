// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/deformation.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace tapeline {

namespace {

/// Horn's symmetric 4×4 matrix: tr(R(q)ᵀ S) = qᵀ N q for a unit quaternion q = (w, x, y, z).
Eigen::Matrix4d horn_matrix(const Eigen::Matrix3d& S)
{
    Eigen::Matrix4d N;
    N(0, 0) = S(0, 0) + S(1, 1) + S(2, 2);
    N(1, 1) = S(0, 0) - S(1, 1) - S(2, 2);
    N(2, 2) = -S(0, 0) + S(1, 1) - S(2, 2);
    N(3, 3) = -S(0, 0) - S(1, 1) + S(2, 2);
    N(0, 1) = N(1, 0) = S(2, 1) - S(1, 2);
    N(0, 2) = N(2, 0) = S(0, 2) - S(2, 0);
    N(0, 3) = N(3, 0) = S(1, 0) - S(0, 1);
    N(1, 2) = N(2, 1) = S(0, 1) + S(1, 0);
    N(1, 3) = N(3, 1) = S(0, 2) + S(2, 0);
    N(2, 3) = N(3, 2) = S(1, 2) + S(2, 1);
    return N;
}

/// Column k of the adjugate of a symmetric matrix.
Eigen::Vector4d adjugate_column(const Eigen::Matrix4d& M, int k)
{
    Eigen::Vector4d column;
    for (int j = 0; j < 4; ++j) {
        Eigen::Matrix3d minor;
        for (int r = 0, mr = 0; r < 4; ++r) {
            if (r == k) {
                continue;
            }
            for (int c = 0, mc = 0; c < 4; ++c) {
                if (c != j) {
                    minor(mr, mc++) = M(r, c);
                }
            }
            ++mr;
        }
        column[j] = ((k + j) % 2 == 0 ? 1 : -1) * minor.determinant();
    }
    return column;
}

Eigen::Matrix3d rotation_of(const Eigen::Vector4d& q)
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    Eigen::Matrix3d R;
    R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), //
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),  //
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
    return R;
}

Eigen::Matrix3d rotation_by_svd(const Eigen::Matrix3d& S)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(S, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d& U = svd.matrixU();
    const Eigen::Matrix3d& V = svd.matrixV();
    Vec3 signs(1, 1, (U * V.transpose()).determinant() < 0 ? -1 : 1);
    return U * signs.asDiagonal() * V.transpose();
}

/// Largest root of λ⁴ + c2 λ² + c1 λ + c0, by Newton from above, where the polynomial is convex and increasing.
double largest_eigenvalue(double c2, double c1, double c0)
{
    double x = std::sqrt(3.0);
    for (int i = 0; i < 60; ++i) {
        const double f = ((x * x + c2) * x + c1) * x + c0;
        const double slope = (4 * x * x + 2 * c2) * x + c1;
        if (!(slope > 0)) {
            break;
        }
        const double step = f / slope;
        x -= step;
        if (std::abs(step) < 1e-15) {
            break;
        }
    }
    return x;
}

} // namespace

Eigen::Matrix3d polar_rotation(const Eigen::Matrix3d& S)
{
    const double norm = S.norm();
    if (!(norm > 0)) {
        return Eigen::Matrix3d::Identity();
    }
    const Eigen::Matrix3d scaled = S / norm;
    const Eigen::Matrix4d N = horn_matrix(scaled);
    const double lambda = largest_eigenvalue(-2, -8 * scaled.determinant(), N.determinant());
    const Eigen::Matrix4d M = N - lambda * Eigen::Matrix4d::Identity();
    Eigen::Vector4d q = Eigen::Vector4d::Zero();
    for (int k = 0; k < 4 && q.squaredNorm() < 1e-6; ++k) {
        const Eigen::Vector4d column = adjugate_column(M, k);
        if (column.squaredNorm() > q.squaredNorm()) {
            q = column;
        }
    }
    // A vanishing adjugate is a double eigenvalue: the best rotation is not unique, and SVD picks one stably.
    if (q.norm() < 1e-9) {
        return rotation_by_svd(S);
    }
    return rotation_of(q.normalized());
}

} // namespace tapeline
