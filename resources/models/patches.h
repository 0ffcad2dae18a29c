// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Pnt.hxx>
#include <vector>

namespace tapeline::models {

/// A parameter direction of a B-spline surface: distinct break points (ascending, simple inner knots) and a degree.
struct Direction {
    std::vector<double> breaks;
    int degree = 3;
};

/// `spans` equal spans over [first, last].
Direction uniform(double first, double last, int spans, int degree);

/// The tensor-product B-spline surface that agrees with `point(u, v)` at the Greville points of both directions. Two
/// patches with the same u direction and the same points along a border have bit-identical poles there.
Handle(Geom_BSplineSurface)
    interpolate(const Direction& u, const Direction& v, const std::function<gp_Pnt(double, double)>& point);

/// The whole surface as a face with edges of its own.
TopoDS_Face face_of(const Handle(Geom_BSplineSurface) & surface);

/// Faces joined along equal borders, which become shared edges.
TopoDS_Shape shell_of(const std::vector<TopoDS_Face>& faces);

/// Faces side by side, no edge shared.
TopoDS_Shape compound_of(const std::vector<TopoDS_Face>& faces);

} // namespace tapeline::models
