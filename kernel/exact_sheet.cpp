// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/exact_sheet.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tapeline {

ExactSheet::ExactSheet(const Model& model, std::span<const int> faces) : model_(model)
{
    std::map<int, std::vector<int>> parts;
    for (const int t : faces) {
        parts[model.cad_face[t]].push_back(t);
    }
    for (const auto& [cad_face, part] : parts) {
        Eigen::AlignedBox3d box;
        double depth = 0;
        for (const int t : part) {
            depth = std::max(depth, depth_at(t));
            for (int k = 0; k < 3; ++k) {
                box.extend(model.mesh.V.row(model.mesh.F(t, k)).transpose());
            }
        }
        pieces_.push_back({cad_face, ClosestPoint(model.mesh, part), box, depth});
    }
}

double ExactSheet::depth_at(int face) const
{
    constexpr double share = 0.25; // of the triangle's longest edge
    const Mesh& mesh = model_.mesh;
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (mesh.V.row(mesh.F(face, k)) - mesh.V.row(mesh.F(face, (k + 1) % 3))).norm());
    }
    return share * longest;
}

size_t ExactSheet::nearest_piece(const Vec3& p, MeshFoot& near) const
{
    size_t nearest = pieces_.size();
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < pieces_.size(); ++i) {
        if (pieces_[i].box.exteriorDistance(p) >= least) {
            continue;
        }
        const MeshFoot foot = pieces_[i].triangles.closest(p);
        if (foot.face >= 0 && foot.distance < least) {
            least = foot.distance;
            near = foot;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<ExactSheet::Place> ExactSheet::place_on(const Piece& piece, const Vec3& p) const
{
    const auto foot = piece.cad_face < 0 ? std::nullopt : model_.surface->closest(piece.cad_face, p);
    if (!foot || !foot->point.allFinite() || !foot->normal.allFinite()) {
        return std::nullopt;
    }
    const MeshFoot before = piece.triangles.closest(foot->point);
    if (before.face < 0 || before.distance > depth_at(before.face)) {
        return std::nullopt;
    }
    return Place{*foot, (foot->point - p).norm()};
}

SheetFoot ExactSheet::foot(const Vec3& p) const
{
    SheetFoot result;
    MeshFoot& near = result.triangle;
    const size_t own = nearest_piece(p, near);
    if (own == pieces_.size() || pieces_[own].cad_face < 0) {
        return result;
    }
    std::optional<Place> best = place_on(pieces_[own], p);
    std::vector<Place> places;
    if (best) {
        places.push_back(*best);
    }
    for (size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& piece = pieces_[i];
        const double wanted = (best ? best->distance : near.distance + pieces_[own].depth) + piece.depth;
        if (i == own || piece.box.exteriorDistance(p) > wanted || piece.triangles.closest(p).distance > wanted) {
            continue;
        }
        if (const auto place = place_on(piece, p)) {
            places.push_back(*place);
            best = !best || place->distance < best->distance ? place : best;
        }
    }
    if (!best) {
        return result;
    }
    if (best->distance > near.distance) {
        const auto behind = model_.surface->closest(pieces_[own].cad_face, near.point);
        constexpr double rounding = 1e-9;
        if (!behind || !(best->distance <= (behind->point - p).norm() + rounding * depth_at(near.face))) {
            return result;
        }
    }
    result.exact = {best->foot.point, Vec3::Zero()};
    constexpr double same = 1e-6;
    for (const Place& place : places) {
        if ((place.foot.point - best->foot.point).norm() <= same * depth_at(near.face)) {
            result.exact->normal += place.foot.normal;
        }
    }
    return result;
}

} // namespace tapeline
