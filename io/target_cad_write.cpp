// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/quiet_occt.h"
#include "io/target_formats.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Edge.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>
#include <sstream>

namespace tapeline {

namespace {

/// Every double keeps its value.
constexpr const char* number_format = "%.16E"; // STEP wants a decimal point in every real

Handle(Geom_BSplineCurve) make_curve(const BSplineData& data)
{
    const int n = static_cast<int>(data.control_points.size());
    TColgp_Array1OfPnt poles(1, n);
    TColStd_Array1OfReal weights(1, n);
    for (int i = 0; i < n; ++i) {
        const Vec3& p = data.control_points[i];
        poles(i + 1) = gp_Pnt(p.x(), p.y(), p.z());
        weights(i + 1) = data.weights.empty() ? 1 : data.weights[i];
    }
    std::vector<double> values;
    std::vector<int> counts;
    for (const double u : data.knots) {
        if (values.empty() || values.back() != u) {
            values.push_back(u);
            counts.push_back(0);
        }
        ++counts.back();
    }
    TColStd_Array1OfReal knots(1, static_cast<int>(values.size()));
    TColStd_Array1OfInteger multiplicities(1, static_cast<int>(values.size()));
    for (size_t i = 0; i < values.size(); ++i) {
        knots(static_cast<int>(i) + 1) = values[i];
        multiplicities(static_cast<int>(i) + 1) = counts[i];
    }
    return new Geom_BSplineCurve(poles, weights, knots, multiplicities, data.degree);
}

Result<std::string> unwritable(std::string_view format)
{
    return fail(ErrorKind::rejected, fmt::format("the target line cannot be written as {}; write it as .json", format));
}

Result<std::string> write_step(const TopoDS_Edge& edge)
{
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", "MM");
    if (writer.Transfer(edge, STEPControl_GeometricCurveSet) != IFSelect_RetDone) {
        return unwritable("STEP");
    }
    const Handle(StepData_StepModel) model = writer.Model();
    // The same bytes at any time: OpenCASCADE numbers products through the process and stamps the date.
    for (int i = 1; i <= model->NbEntities(); ++i) {
        if (const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i)); !product.IsNull()) {
            product->SetId(new TCollection_HAsciiString("target line"));
            product->SetName(new TCollection_HAsciiString("target line"));
        }
    }
    APIHeaderSection_MakeHeader header(model);
    header.SetTimeStamp(new TCollection_HAsciiString("1970-01-01T00:00:00"));
    header.SetName(new TCollection_HAsciiString("target line"));
    header.Apply(model);
    StepData_StepWriter text(model);
    text.FloatWriter().SetFormat(number_format);
    text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    std::ostringstream stream;
    if (!text.Print(stream)) {
        return unwritable("STEP");
    }
    return stream.str();
}

Result<std::string> write_iges(const TopoDS_Edge& edge)
{
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", 0);
    if (!writer.AddShape(edge)) {
        return unwritable("IGES");
    }
    writer.ComputeModel();
    const Handle(IGESData_IGESModel) model = writer.Model();
    IGESData_GlobalSection global = model->GlobalSection();
    global.SetDate(new TCollection_HAsciiString("700101.000000"));
    global.SetLastChangeDate(new TCollection_HAsciiString("700101.000000"));
    model->SetGlobalSection(global);
    IGESData_IGESWriter text(model);
    text.FloatWriter().SetFormat(number_format);
    text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
    std::ostringstream stream;
    if (!text.Print(stream)) {
        return unwritable("IGES");
    }
    return stream.str();
}

} // namespace

Result<std::string> target_to_cad(const TargetLine& line, FileFormat format)
try {
    const QuietOcct quiet;
    BRepBuilderAPI_MakeEdge builder(make_curve(line.data()));
    if (!builder.IsDone()) {
        return fail(ErrorKind::rejected,
                    "the target line is too small for a CAD file (its ends are closer than 1e-7 mm "
                    "yet not closed); write it as .json");
    }
    const TopoDS_Edge& shape = builder.Edge();
    if (format == FileFormat::step) {
        return write_step(shape);
    }
    if (format == FileFormat::iges) {
        return write_iges(shape);
    }
    std::ostringstream stream;
    BRepTools::Write(shape, stream);
    return stream.str();
} catch (const Standard_Failure& failure) {
    return fail(ErrorKind::rejected, fmt::format("the target line cannot be written as CAD ({} {}); write it as .json",
                                                 failure.DynamicType()->Name(), failure.GetMessageString()));
}

} // namespace tapeline
