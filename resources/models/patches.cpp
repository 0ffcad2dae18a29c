// SPDX-License-Identifier: GPL-3.0-or-later
#include "patches.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BSplCLib.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <stdexcept>

namespace tapeline::models {

namespace {

/// Knots of one direction with repetition, and the parameters at which to interpolate.
struct Basis {
    explicit Basis(const Direction& direction)
        : degree(direction.degree), poles(static_cast<int>(direction.breaks.size()) - 1 + degree),
          knots(1, static_cast<int>(direction.breaks.size())), multiplicities(1, knots.Length()),
          flat(1, poles + degree + 1), greville(1, poles)
    {
        for (int i = 1; i <= knots.Length(); ++i) {
            knots(i) = direction.breaks[i - 1];
            multiplicities(i) = i == 1 || i == knots.Length() ? degree + 1 : 1;
        }
        for (int i = 1; i <= flat.Length(); ++i) {
            flat(i) = knots(std::clamp(i - degree, 1, knots.Length()));
        }
        for (int i = 1; i <= poles; ++i) {
            double sum = 0;
            for (int k = 1; k <= degree; ++k) {
                sum += flat(i + k);
            }
            greville(i) = sum / degree;
        }
        greville(1) = knots.First();
        greville(poles) = knots.Last();
    }

    /// Replaces points on the Greville parameters by the poles of the curve through them.
    void solve(TColgp_Array1OfPnt& points) const
    {
        const TColStd_Array1OfInteger contact = [this] {
            TColStd_Array1OfInteger zeros(1, poles);
            zeros.Init(0);
            return zeros;
        }();
        int problem = 0;
        BSplCLib::Interpolate(degree, flat, greville, contact, points, problem);
        if (problem != 0) {
            throw std::runtime_error("no B-spline through these points: singular knots");
        }
    }

    int degree, poles;
    TColStd_Array1OfReal knots;
    TColStd_Array1OfInteger multiplicities;
    TColStd_Array1OfReal flat, greville;
};

} // namespace

Direction uniform(double first, double last, int spans, int degree)
{
    Direction direction{{}, degree};
    for (int i = 0; i <= spans; ++i) {
        direction.breaks.push_back(i == spans ? last : first + (last - first) * i / spans);
    }
    return direction;
}

Handle(Geom_BSplineSurface)
    interpolate(const Direction& u, const Direction& v, const std::function<gp_Pnt(double, double)>& point)
{
    const Basis along(u), across(v);
    TColgp_Array2OfPnt poles(1, along.poles, 1, across.poles);
    for (int j = 1; j <= across.poles; ++j) {
        TColgp_Array1OfPnt row(1, along.poles);
        for (int i = 1; i <= along.poles; ++i) {
            row(i) = point(along.greville(i), across.greville(j));
        }
        along.solve(row);
        for (int i = 1; i <= along.poles; ++i) {
            poles(i, j) = row(i);
        }
    }
    for (int i = 1; i <= along.poles; ++i) {
        TColgp_Array1OfPnt column(1, across.poles);
        for (int j = 1; j <= across.poles; ++j) {
            column(j) = poles(i, j);
        }
        const gp_Pnt first = column.First(), last = column.Last();
        across.solve(column);
        // Exact by theory; set so that a neighbour's border has the same bits.
        column.ChangeFirst() = first;
        column.ChangeLast() = last;
        for (int j = 1; j <= across.poles; ++j) {
            poles(i, j) = column(j);
        }
    }
    return new Geom_BSplineSurface(poles, along.knots, across.knots, along.multiplicities, across.multiplicities,
                                   along.degree, across.degree);
}

TopoDS_Face face_of(const Handle(Geom_BSplineSurface) & surface)
{
    return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TopoDS_Shape shell_of(const std::vector<TopoDS_Face>& faces)
{
    BRepBuilderAPI_Sewing sewing(1e-6);
    for (const TopoDS_Face& face : faces) {
        sewing.Add(face);
    }
    sewing.Perform();
    return sewing.SewedShape();
}

TopoDS_Shape compound_of(const std::vector<TopoDS_Face>& faces)
{
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Face& face : faces) {
        builder.Add(compound, face);
    }
    return compound;
}

} // namespace tapeline::models
