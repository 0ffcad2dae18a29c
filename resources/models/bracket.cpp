// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"
#include "patches.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <functional>
#include <gp_Ax2.hxx>
#include <numbers>
#include <stdexcept>

namespace tapeline::models {

namespace {

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1)
{
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

TopoDS_Shape cylinder(const gp_Pnt& foot, const gp_Dir& axis, double radius, double height)
{
    return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, axis), radius, height).Shape();
}

/// The curved front, leaning back: y as a function of x and z, a wave along x that is stronger at the top.
gp_Pnt front(double x, double z)
{
    const double wave = std::sin(std::numbers::pi * x / 140);
    return {x, -44 + (14 + z / 6) * wave * wave + 0.75 * (z - 30) + (z - 30) * (z - 30) / 120, z};
}

/// Rounds the edges whose two ends fulfil `wanted`.
TopoDS_Shape round_edges(const TopoDS_Shape& shape, double radius,
                         const std::function<bool(const gp_Pnt&, const gp_Pnt&)>& wanted)
{
    BRepFilletAPI_MakeFillet fillet(shape);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    int count = 0;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
        if (wanted(BRep_Tool::Pnt(first), BRep_Tool::Pnt(last))) {
            fillet.Add(radius, edge);
            ++count;
        }
    }
    if (count == 0) {
        throw std::runtime_error("no edge to round on the bracket");
    }
    return fillet.Shape();
}

} // namespace

TopoDS_Shape bracket()
{
    // A foot plate with an upright wall at its back.
    TopoDS_Shape solid = BRepAlgoAPI_Fuse(box(0, -60, 0, 140, 40, 30), box(0, 22, 0, 140, 40, 95)).Shape();
    ShapeUpgrade_UnifySameDomain unify(solid);
    unify.Build();
    solid = unify.Shape();
    solid = round_edges(solid, 12, [](const gp_Pnt& a, const gp_Pnt& b) { // between plate and wall
        return std::abs(a.Y() - 22) + std::abs(b.Y() - 22) + std::abs(a.Z() - 30) + std::abs(b.Z() - 30) < 1e-6;
    });
    solid = round_edges(solid, 25, [](const gp_Pnt& a, const gp_Pnt& b) { // upper corners of the wall
        return std::abs(a.Z() - 95) + std::abs(b.Z() - 95) + std::abs(a.X() - b.X()) < 1e-6;
    });
    // The front of the plate is cut away along a free-form surface.
    const TopoDS_Face cutter = face_of(interpolate(uniform(-10, 150, 8, 5), uniform(-10, 40, 2, 3), front));
    solid = BRepAlgoAPI_Cut(solid, BRepPrimAPI_MakePrism(cutter, gp_Vec(0, -120, 0)).Shape()).Shape();
    solid = BRepAlgoAPI_Cut(solid, cylinder({35, -5, -10}, {0, 0, 1}, 8, 60)).Shape();
    solid = BRepAlgoAPI_Cut(solid, cylinder({105, -5, -10}, {0, 0, 1}, 8, 60)).Shape();
    return BRepAlgoAPI_Cut(solid, cylinder({70, 10, 66}, {0, 1, 0}, 14, 60)).Shape();
}

} // namespace tapeline::models
