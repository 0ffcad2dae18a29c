// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shaders.h"
#include "kernel/parallel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::picture {

namespace {

/// The triangles around corner (t, v) that are reached without crossing a sharp edge.
struct Fan {
    std::vector<int> faces;
    bool whole = false; ///< all around the vertex
};

class CornerNormals {
public:
    CornerNormals(const Mesh& mesh, const Topology& topology, const std::vector<char>& sharp)
        : mesh_(mesh), topology_(topology), sharp_(sharp), face_normals_(mesh.F.rows(), 3)
    {
        parallel_for(static_cast<int>(mesh.F.rows()), [&](int t) { face_normals_.row(t) = triangle_normal(mesh, t); });
    }

    Vec3 at(int t, int corner) const
    {
        const int v = mesh_.F(t, corner);
        const Fan around = fan(t, corner);
        Vec3 sum = Vec3::Zero();
        for (const int s : around.faces) {
            sum += weighted_normal(s, v);
        }
        const Vec3 own = face_normals_.row(t);
        const Vec3 mean = sum.norm() > 0 ? Vec3(sum.normalized()) : own;
        return around.whole ? mean : extrapolated(around, v, mean);
    }

private:
    /// Exact at a vertex of any triangles whose corners lie on a sphere, whatever their shapes (Max, Weights for
    /// Computing Vertex Normals from Facet Normals, 1999): a needle or a cap, whose own normal is uncertain, counts little.
    Vec3 weighted_normal(int t, int v) const
    {
        const int k = mesh_.F(t, 0) == v ? 0 : (mesh_.F(t, 1) == v ? 1 : 2);
        const Vec3 p = mesh_.V.row(v);
        const Vec3 e1 = mesh_.V.row(mesh_.F(t, (k + 1) % 3)).transpose() - p;
        const Vec3 e2 = mesh_.V.row(mesh_.F(t, (k + 2) % 3)).transpose() - p;
        const double lengths = e1.squaredNorm() * e2.squaredNorm();
        return lengths > 0 ? Vec3(e1.cross(e2) / lengths) : Vec3(Vec3::Zero());
    }

    /// The next triangle around v from t (-1 at a sharp edge), and the edge to it: the one that `through` is not.
    std::pair<int, int> next_around(int t, int v, int through) const
    {
        for (const int e : topology_.face_edges(t)) {
            if (e != through && (topology_.edge(e).a == v || topology_.edge(e).b == v)) {
                return {sharp_[e] ? -1 : topology_.face_across(t, e), e};
            }
        }
        return {-1, -1};
    }

    Fan fan(int t, int corner) const
    {
        Fan result{{t}, false};
        const int v = mesh_.F(t, corner);
        // One way round; when that ends at a sharp edge, the other way too.
        for (const int start : {topology_.face_edges(t)[corner], topology_.face_edges(t)[(corner + 2) % 3]}) {
            auto [s, e] = next_around(t, v, start);
            for (int guard = 0; s >= 0 && s != t && guard < 1000; ++guard) {
                result.faces.push_back(s);
                std::tie(s, e) = next_around(s, v, e);
            }
            result.whole = s == t;
            if (result.whole) {
                break;
            }
        }
        return result;
    }

    /// At a border or crease the mean belongs to a point inside; stripes would hook there. A linear function fitted to
    /// the normals of the fan and of the triangles next to it is read off at the vertex instead.
    Vec3 extrapolated(const Fan& around, int v, const Vec3& mean) const
    {
        std::vector<int> faces = around.faces;
        for (int ring = 0; ring < 2; ++ring) {
            const std::vector<int> core = faces;
            for (const int t : core) {
                for (const int e : topology_.face_edges(t)) {
                    const int next = sharp_[e] ? -1 : topology_.face_across(t, e);
                    if (next >= 0 && std::find(faces.begin(), faces.end(), next) == faces.end()) {
                        faces.push_back(next);
                    }
                }
            }
        }
        const Vec3 x = mean.unitOrthogonal(), y = mean.cross(x), p = mesh_.V.row(v);
        Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
        double size = 0;
        for (const int t : faces) {
            size = std::max(size, std::sqrt(triangle_area(mesh_, t)));
        }
        for (const int t : faces) {
            const Vec3 centre =
                (mesh_.V.row(mesh_.F(t, 0)) + mesh_.V.row(mesh_.F(t, 1)) + mesh_.V.row(mesh_.F(t, 2))).transpose() / 3;
            const Vec3 row(1, (centre - p).dot(x) / size, (centre - p).dot(y) / size);
            const double weight = triangle_area(mesh_, t);
            normal_matrix += weight * row * row.transpose();
            right += weight * row * face_normals_.row(t);
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spectrum(normal_matrix, Eigen::EigenvaluesOnly);
        if (faces.size() < 4 || spectrum.eigenvalues()[0] < 1e-3 * spectrum.eigenvalues()[2]) {
            return mean;
        }
        const Vec3 fitted = (normal_matrix.inverse() * right).row(0).transpose();
        // On a rough patch the line may point anywhere: no farther from the mean than its triangles are.
        double spread = 1;
        for (const int t : around.faces) {
            spread = std::min(spread, mean.dot(Vec3(face_normals_.row(t))));
        }
        const double allowed = std::max(std::acos(std::clamp(spread, -1.0, 1.0)), 0.02) * 2;
        return fitted.norm() > 0 && fitted.normalized().dot(mean) > std::cos(allowed) ? Vec3(fitted.normalized())
                                                                                      : mean;
    }

    const Mesh& mesh_;
    const Topology& topology_;
    const std::vector<char>& sharp_;
    Positions face_normals_;
};

} // namespace

Positions corner_normals(const Mesh& mesh, const Topology& topology, const std::vector<char>& sharp)
{
    const CornerNormals corners(mesh, topology, sharp);
    Positions normals(3 * mesh.F.rows(), 3);
    parallel_for(static_cast<int>(mesh.F.rows()), [&](int t) {
        for (int k = 0; k < 3; ++k) {
            normals.row(3 * t + k) = corners.at(t, k);
        }
    });
    return normals;
}

} // namespace tapeline::picture
