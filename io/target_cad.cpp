// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/join.h"
#include "io/cad_shape.h"
#include "io/target_formats.h"

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr int most_edges = 2000;

/// Edges that belong to no face, or all where there are none of that kind; each once.
TopTools_IndexedMapOfShape curve_edges(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape edges;
    for (TopExp_Explorer it(shape, TopAbs_EDGE, TopAbs_FACE); it.More(); it.Next()) {
        edges.Add(it.Current());
    }
    if (edges.IsEmpty()) {
        TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    }
    return edges;
}

BSplineData data_of(const Handle(Geom_BSplineCurve) & curve)
{
    curve->SetNotPeriodic();
    BSplineData data;
    data.degree = curve->Degree();
    const TColStd_Array1OfReal& knots = curve->KnotSequence();
    data.knots.assign(knots.begin(), knots.end());
    for (int i = 1; i <= curve->NbPoles(); ++i) {
        const gp_Pnt& p = curve->Pole(i);
        data.control_points.emplace_back(p.X(), p.Y(), p.Z());
        if (curve->IsRational()) {
            data.weights.push_back(curve->Weight(i));
        }
    }
    return data;
}

/// The curve of an edge in its own sense; null for a degenerated edge.
Handle(Geom_BSplineCurve) edge_curve(const TopoDS_Edge& edge)
{
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull() || Precision::IsInfinite(first) || Precision::IsInfinite(last)) {
        return {};
    }
    Handle(Geom_BSplineCurve) result = Handle(Geom_BSplineCurve)::DownCast(curve);
    const bool whole = !result.IsNull() && first == result->FirstParameter() && last == result->LastParameter();
    if (whole) {
        result = Handle(Geom_BSplineCurve)::DownCast(result->Copy());
    } else {
        result = GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
    }
    if (edge.Orientation() == TopAbs_REVERSED) {
        result->Reverse();
    }
    return result;
}

/// Curves of all edges, raised to one degree; `tolerance_mm` becomes what joins their ends.
Result<std::vector<BSplineData>> read_curves(const std::string& file, const TopoDS_Shape& shape, double& tolerance_mm)
{
    const TopTools_IndexedMapOfShape edges = curve_edges(shape);
    if (edges.Extent() > most_edges) {
        return fail(ErrorKind::rejected,
                    fmt::format("{} holds {} edges, a target is one line of at most {}: export the "
                                "line alone",
                                file, edges.Extent(), most_edges));
    }
    std::vector<Handle(Geom_BSplineCurve)> curves;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (const auto curve = edge_curve(edge); !curve.IsNull()) {
            curves.push_back(curve);
            for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next()) {
                tolerance_mm = std::max(tolerance_mm, 2 * BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
            }
        }
    }
    int degree = 1;
    for (const auto& curve : curves) {
        degree = std::max(degree, curve->Degree());
    }
    std::vector<BSplineData> result;
    Eigen::Array3d low = Eigen::Array3d::Constant(Precision::Infinite()), high = -low;
    for (const auto& curve : curves) {
        curve->IncreaseDegree(degree);
        result.push_back(data_of(curve));
        for (const Vec3& p : result.back().control_points) {
            low = low.min(p.array());
            high = high.max(p.array());
        }
    }
    if (!result.empty()) {
        tolerance_mm = std::max(tolerance_mm, 1e-6 * (high - low).matrix().norm());
    }
    return result;
}

} // namespace

Result<TargetLine> target_from_cad(const std::filesystem::path& path, FileFormat format)
try {
    const std::string file = path.string();
    const auto shape = read_cad_shape(path, format, CadContent::curves);
    if (!shape) {
        return tl::unexpected(shape.error());
    }
    BRepLib::BuildCurves3d(*shape->shape);
    double tolerance_mm = 0;
    const auto curves = read_curves(file, *shape->shape, tolerance_mm);
    if (!curves) {
        return tl::unexpected(curves.error());
    }
    return join_lines(*curves, tolerance_mm).map_error([&](Error error) {
        error.message = fmt::format("{} holds no target line: {}", file, error.message);
        return error;
    });
} catch (const Standard_Failure& failure) {
    return fail(ErrorKind::unreadable,
                fmt::format("{} cannot be read: OpenCASCADE reports {} {}; export the curve again", path.string(),
                            failure.DynamicType()->Name(), failure.GetMessageString()));
}

} // namespace tapeline
