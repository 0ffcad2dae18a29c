// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_writer.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <stdexcept>

namespace tapeline::models {

namespace {

Handle(TCollection_HAsciiString) text(const char* characters) { return new TCollection_HAsciiString(characters); }

/// The translator numbers product names through the run; each file here holds one, so the number goes.
void name_product(const Handle(Interface_InterfaceModel) & model, const std::string& name)
{
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
        if (!product.IsNull()) {
            product->SetId(text(name.c_str()));
            product->SetName(text(name.c_str()));
        }
    }
}

} // namespace

void write_step(const std::filesystem::path& path, const TopoDS_Shape& shape, const std::string& name)
{
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.product.name", name.c_str());
    Interface_Static::SetIVal("write.step.assembly", 0); // loose patches stay one part, not an assembly of parts
    Interface_Static::SetIVal("write.surfacecurve.mode", 0);
    STEPControl_Writer writer;
    if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) {
        throw std::runtime_error("cannot translate " + name + " to STEP");
    }
    name_product(writer.Model(), name);
    APIHeaderSection_MakeHeader header(writer.Model());
    header.SetName(text((name + ".step").c_str()));
    header.SetTimeStamp(text("2026-01-01T00:00:00"));
    header.SetAuthorValue(1, text("Tapeline"));
    header.SetOrganizationValue(1, text("Tapeline"));
    header.SetOriginatingSystem(text("make_models"));
    header.SetAuthorisation(text(""));
    header.SetDescriptionValue(1, text("Tapeline sample model"));
    if (writer.Write(path.string().c_str()) != IFSelect_RetDone) {
        throw std::runtime_error("cannot write " + path.string());
    }
}

} // namespace tapeline::models
