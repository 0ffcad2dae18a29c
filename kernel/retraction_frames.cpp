// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/orthotropic.h"
#include "kernel/retraction_steps.h"

#include <Eigen/Geometry>
#include <array>

namespace tapeline {

namespace {

using Tangents = Eigen::Matrix<double, 3, 2>;

/// An orthonormal basis of the tangent plane per vertex.
std::vector<Tangents> tangent_planes(const RetractionTask& task)
{
    std::vector<Tangents> planes(task.normals().rows());
    for (size_t v = 0; v < planes.size(); ++v) {
        Vec3 normal = task.normals().row(static_cast<Eigen::Index>(v));
        if (normal.isZero(0)) {
            normal = Vec3::UnitZ();
        }
        planes[v].col(0) = normal.unitOrthogonal();
        planes[v].col(1) = normal.cross(planes[v].col(0));
    }
    return planes;
}

/// Dirichlet energy of tangent fields: two rows and columns per vertex.
Eigen::SparseMatrix<double> connection_matrix(const RetractionTask& task, const std::vector<Tangents>& planes)
{
    const Mesh& inner = task.inner();
    const std::vector<TriangleElement> elements = triangle_elements(inner, {1, Stiff::along, Vec3::UnitX()});
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * elements.size());
    for (int t = 0; t < inner.F.rows(); ++t) {
        const TriangleElement& element = elements[t];
        const Vec3 normal = triangle_normal(inner, t);
        std::array<Eigen::Matrix2d, 3> turn;
        for (int k = 0; k < 3; ++k) {
            const int v = inner.F(t, k);
            const Vec3 at_corner = task.normals().row(v);
            turn[k] = element.basis.transpose() *
                      (Eigen::Quaterniond::FromTwoVectors(at_corner, normal).toRotationMatrix() * planes[v]);
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const double weight = element.area * element.gradient.col(i).dot(element.gradient.col(j));
                const Eigen::Matrix2d block = weight * turn[i].transpose() * turn[j];
                for (int k = 0; k < 4; ++k) {
                    entries.emplace_back(2 * inner.F(t, i) + k / 2, 2 * inner.F(t, j) + k % 2, block(k / 2, k % 2));
                }
            }
        }
    }
    Eigen::SparseMatrix<double> K(2 * inner.V.rows(), 2 * inner.V.rows());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

} // namespace

std::vector<Eigen::Matrix3d> parallel_frames(const RetractionTask& task)
{
    const std::vector<Tangents> planes = tangent_planes(task);
    Vec3 direction = Vec3::Zero();
    for (const Vec3& u : task.moves()) {
        direction += u;
    }
    std::vector<int> constrained;
    std::vector<double> values;
    for (size_t i = 0; i < task.line().size(); ++i) {
        const int v = task.line()[i];
        const Eigen::Vector2d t = planes[v].transpose() * direction;
        // Where the direction is nearly normal to the surface its projection says nothing; the neighbours decide.
        if (t.norm() > 0.3 * direction.norm()) {
            constrained.insert(constrained.end(), {2 * v, 2 * v + 1});
            values.insert(values.end(), {t.normalized().x(), t.normalized().y()});
        }
    }
    std::vector<Eigen::Matrix3d> frames(planes.size(), Eigen::Matrix3d::Identity());
    if (constrained.empty()) {
        return frames;
    }
    const Eigen::Map<const Eigen::VectorXd> given(values.data(), static_cast<Eigen::Index>(values.size()));
    const Eigen::VectorXd field = harmonic_extension(connection_matrix(task, planes), constrained, given);
    for (size_t v = 0; v < frames.size(); ++v) {
        const Vec3 tangent = planes[v] * field.segment<2>(2 * static_cast<Eigen::Index>(v));
        const Vec3 first = tangent.norm() > 1e-9 ? Vec3(tangent.normalized()) : Vec3(planes[v].col(0));
        const Vec3 normal = planes[v].col(0).cross(planes[v].col(1));
        frames[v] << first, normal.cross(first), normal;
    }
    return frames;
}

} // namespace tapeline
