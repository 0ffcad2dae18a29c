// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax1.hxx>
#include <initializer_list>

namespace tapeline::models {

namespace {

/// A Bézier arc of the profile; points are (radius, height) in mm.
TopoDS_Edge arc(std::initializer_list<std::pair<double, double>> points)
{
    TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
    int i = 1;
    for (const auto& [r, z] : points) {
        poles(i++) = gp_Pnt(r, 0, z);
    }
    return BRepBuilderAPI_MakeEdge(Handle(Geom_BezierCurve)(new Geom_BezierCurve(poles)));
}

} // namespace

TopoDS_Shape pawn()
{
    BRepBuilderAPI_MakeWire profile;
    profile.Add(arc({{0, 0}, {16, 0}}));                                                   // bottom
    profile.Add(arc({{16, 0}, {17.5, 1.5}, {17.5, 6}, {16, 8}}));                          // foot
    profile.Add(arc({{16, 8}, {14, 9}, {12.5, 11}, {12, 13}}));                            // hollow above the foot
    profile.Add(arc({{12, 13}, {12.5, 15}, {11, 17}, {10, 18}}));                          // ring
    profile.Add(arc({{10, 18}, {7, 24}, {5.5, 32}, {5.5, 40}}));                           // neck
    profile.Add(arc({{5.5, 40}, {7, 41}, {9.5, 42}, {10.5, 43.5}}));                       // under the collar
    profile.Add(arc({{10.5, 43.5}, {9, 45.5}, {7, 46.5}, {5.5, 47}}));                     // over the collar
    profile.Add(arc({{5.5, 47}, {9, 49}, {11, 54}, {10, 59}, {8, 66}, {4, 68}, {0, 68}})); // head
    profile.Add(arc({{0, 68}, {0, 0}}));                                                   // axis
    const TopoDS_Shape section = BRepBuilderAPI_MakeFace(profile.Wire(), true).Face();
    const TopoDS_Shape solid = BRepPrimAPI_MakeRevol(section, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
    return BRepBuilderAPI_NurbsConvert(solid).Shape();
}

} // namespace tapeline::models
