// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/remesh_surface.h"

#include "kernel/curve.h"
#include "kernel/parallel.h"

#include <Eigen/Geometry>
#include <optional>

namespace tapeline {

namespace {

std::optional<Vec3> exact_place(const Model& model, const SurfaceSite& site)
{
    const Vec3 p = model.mesh.V.row(site.vertex);
    std::optional<Vec3> place;
    if (site.cad_edge >= 0) {
        place = model.surface->closest_on_edge(site.cad_edge, p);
    } else if (site.cad_face >= 0) {
        if (const auto foot = model.surface->closest(site.cad_face, p)) {
            place = foot->point;
        }
    }
    const bool usable = place && place->allFinite() && (*place - p).norm() <= site.reach;
    return usable ? place : std::nullopt;
}

Vec3 area_vector(const Positions& V, const Triangles& F, int t)
{
    const Vec3 a = V.row(F(t, 0)), b = V.row(F(t, 1)), c = V.row(F(t, 2));
    return (b - a).cross(c - a);
}

} // namespace

void take_back_folds(const Triangles& F, const Positions& before, Positions& V, std::vector<char>& moved)
{
    for (bool flipped = true; flipped;) {
        flipped = false;
        for (int t = 0; t < F.rows(); ++t) {
            if (!moved[F(t, 0)] && !moved[F(t, 1)] && !moved[F(t, 2)]) {
                continue;
            }
            const Vec3 old_area = area_vector(before, F, t), area = area_vector(V, F, t);
            if (area.dot(old_area) >= 0.5 * area.norm() * old_area.norm() && area.norm() >= 0.05 * old_area.norm()) {
                continue;
            }
            flipped = true;
            for (int k = 0; k < 3; ++k) {
                V.row(F(t, k)) = before.row(F(t, k));
                moved[F(t, k)] = 0;
            }
        }
    }
}

SurfacePlacement place_on_surface(Model& model, const std::vector<SurfaceSite>& sites)
{
    SurfacePlacement result;
    if (!model.surface) {
        return result;
    }
    const int count = static_cast<int>(sites.size());
    std::vector<std::optional<Vec3>> places(count);
    parallel_for(
        count, [&](int i) { places[i] = exact_place(model, sites[i]); }, 64);

    const Positions before = model.mesh.V;
    Positions& V = model.mesh.V;
    std::vector<char> moved(V.rows(), 0);
    for (int i = 0; i < count; ++i) {
        if (places[i]) {
            V.row(sites[i].vertex) = *places[i];
            moved[sites[i].vertex] = 1;
        }
    }
    take_back_folds(model.mesh.F, before, V, moved);
    for (const SurfaceSite& site : sites) {
        const bool wanted = site.cad_edge >= 0 || site.cad_face >= 0;
        result.placed += moved[site.vertex] ? 1 : 0;
        result.left += wanted && !moved[site.vertex] ? 1 : 0;
    }
    return result;
}

} // namespace tapeline
