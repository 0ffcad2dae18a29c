// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/clip.h"

#include <algorithm>
#include <array>
#include <map>

namespace tapeline {

namespace {

class Clipper {
public:
    Clipper(const Mesh& mesh, const CutPlane& plane) : mesh_(mesh), height_(mesh.V.rows())
    {
        for (int v = 0; v < mesh.V.rows(); ++v) {
            height_[v] = plane.height(mesh.V.row(v).transpose());
        }
    }

    ClipResult clip(const std::vector<int>& faces)
    {
        ClipResult result;
        result.vertex.assign(mesh_.V.rows(), -1);
        for (const int t : faces) {
            for (int k = 0; k < 3; ++k) {
                if (const int v = mesh_.F(t, k); stays(v)) {
                    result.vertex[v] = 0;
                }
            }
        }
        for (int v = 0; v < mesh_.V.rows(); ++v) {
            if (result.vertex[v] == 0) {
                result.vertex[v] = static_cast<int>(points_.size());
                points_.emplace_back(mesh_.V.row(v).transpose());
            }
        }
        for (const int t : faces) {
            add(t, result.vertex);
        }
        result.mesh.V.resize(static_cast<Eigen::Index>(points_.size()), 3);
        for (std::size_t v = 0; v < points_.size(); ++v) {
            result.mesh.V.row(static_cast<Eigen::Index>(v)) = points_[v].transpose();
        }
        result.mesh.F.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            result.mesh.F.row(static_cast<Eigen::Index>(t)) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
        }
        return result;
    }

private:
    bool stays(int v) const { return height_[v] >= 0; }

    /// Goes round the triangle and collects the polygon in front of the plane, which has up to four corners.
    void add(int t, const std::vector<int>& vertex)
    {
        std::array<int, 4> corners{};
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const int from = mesh_.F(t, k), to = mesh_.F(t, (k + 1) % 3);
            if (stays(from)) {
                corners[count++] = vertex[from];
            }
            if (stays(from) != stays(to)) {
                corners[count++] = cut(from, to);
            }
        }
        for (int k = 2; k < count; ++k) {
            triangles_.push_back({corners[0], corners[k - 1], corners[k]});
        }
    }

    int cut(int from, int to)
    {
        const int a = std::min(from, to), b = std::max(from, to);
        const auto [at, fresh] = cuts_.try_emplace({a, b}, static_cast<int>(points_.size()));
        if (fresh) {
            const double t = height_[a] / (height_[a] - height_[b]);
            points_.emplace_back((1 - t) * mesh_.V.row(a).transpose() + t * mesh_.V.row(b).transpose());
        }
        return at->second;
    }

    const Mesh& mesh_;
    std::vector<double> height_;
    std::vector<Vec3> points_;
    std::vector<std::array<int, 3>> triangles_;
    std::map<std::pair<int, int>, int> cuts_;
};

} // namespace

Result<ClipResult> clip_mesh(const Mesh& mesh, const std::vector<int>& faces, const CutPlane& plane)
{
    if (!(std::abs(plane.normal.norm() - 1) < 1e-6) || !plane.point.allFinite()) {
        return fail(ErrorKind::rejected, "a plane to cut with needs a finite point and a normal of length 1");
    }
    for (const int t : faces) {
        if (t < 0 || t >= mesh.F.rows()) {
            return fail(ErrorKind::rejected, "a triangle to cut does not exist: number " + std::to_string(t));
        }
        if (mesh.F.row(t).minCoeff() < 0 || mesh.F.row(t).maxCoeff() >= mesh.V.rows()) {
            return fail(ErrorKind::rejected, "a triangle names a vertex that the mesh does not have");
        }
    }
    return Clipper(mesh, plane).clip(faces);
}

} // namespace tapeline
