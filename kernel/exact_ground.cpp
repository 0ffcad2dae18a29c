// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/exact_ground.h"

#include "kernel/curve.h"

#include <algorithm>

namespace tapeline {

ExactGround::ExactGround(const Model& model, std::span<const int> faces) : model_(model)
{
    if (!model.surface || model.cad_face.empty()) {
        return;
    }
    topology_.emplace(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    if (faces.empty()) {
        tree_.emplace(model.mesh);
        return;
    }
    inside_.assign(model.mesh.F.rows(), 0);
    for (const int t : faces) {
        inside_[t] = 1;
    }
    tree_.emplace(model.mesh, faces);
}

std::optional<Vec3> ExactGround::closest(const Vec3& p) const
{
    const int near = tree_ ? tree_->closest(p).face : -1;
    if (near < 0) {
        return std::nullopt;
    }
    std::vector<int> candidates;
    for (int k = 0; k < 3; ++k) {
        for (const int t : topology_->vertex_faces(model_.mesh.F(near, k))) {
            if ((inside_.empty() || inside_[t]) && std::ranges::count(candidates, model_.cad_face[t]) == 0) {
                candidates.push_back(model_.cad_face[t]);
            }
        }
    }
    // Ascending, so that equally near places do not depend on the triangles' order.
    std::ranges::sort(candidates);
    std::optional<Vec3> best;
    for (const int face : candidates) {
        const auto foot = face < 0 ? std::nullopt : model_.surface->closest(face, p);
        if (foot && foot->point.allFinite() && (!best || (foot->point - p).norm() < (*best - p).norm())) {
            best = foot->point;
        }
    }
    return best;
}

} // namespace tapeline
