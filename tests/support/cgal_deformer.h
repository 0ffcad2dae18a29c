// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's deformer behind plain arrays; each kind takes most of a minute to compile, so one source a kind includes this.
#pragma once

#define CGAL_EIGEN3_ENABLED
#include "kernel/mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <vector>

namespace tapeline::testing {

/// Positions after `iterations` iterations from the rest shape. `smoothness` only matters for SRE_ARAP.
template <CGAL::Deformation_algorithm_tag kind>
Positions cgal_deformed(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets, int iterations,
                        double smoothness)
{
    using Point = CGAL::Simple_cartesian<double>::Point_3;
    using Surface = CGAL::Surface_mesh<Point>;
    using Vertex = Surface::Vertex_index;
    Surface surface;
    for (const Vec3 p : rest.V.rowwise()) {
        surface.add_vertex(Point(p.x(), p.y(), p.z()));
    }
    for (int t = 0; t < rest.F.rows(); ++t) {
        surface.add_face(Vertex(rest.F(t, 0)), Vertex(rest.F(t, 1)), Vertex(rest.F(t, 2)));
    }
    CGAL::Surface_mesh_deformation<Surface, CGAL::Default, CGAL::Default, kind> deformer(surface);
    deformer.set_sre_arap_alpha(smoothness);
    deformer.insert_roi_vertices(vertices(surface).begin(), vertices(surface).end());
    for (const int v : constrained) {
        deformer.insert_control_vertex(Vertex(v));
    }
    deformer.preprocess();
    for (size_t i = 0; i < constrained.size(); ++i) {
        const Vec3 p = targets.row(static_cast<Eigen::Index>(i));
        deformer.set_target_position(Vertex(constrained[i]), Point(p.x(), p.y(), p.z()));
    }
    deformer.deform(iterations, 0);
    Positions V(rest.V.rows(), 3);
    for (int v = 0; v < V.rows(); ++v) {
        const Point& p = surface.point(Vertex(v));
        V.row(v) << p.x(), p.y(), p.z();
    }
    return V;
}

} // namespace tapeline::testing
