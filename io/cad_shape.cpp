// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cad_shape.h"

#include "io/cad_envelope.h"
#include "io/file_content.h"
#include "io/quiet_occt.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <mutex>
#include <sstream>

namespace tapeline
{

namespace
{

std::string unit_symbol(std::string name)
{
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::pair<const char*, const char*> known[] = {
        {"millimetre", "mm"}, {"millimeter", "mm"}, {"centimetre", "cm"}, {"centimeter", "cm"}, {"metre", "m"},
        {"meter", "m"},       {"kilometre", "km"},  {"micrometre", "um"}, {"in", "inch"},       {"ft", "foot"}};
    for (const auto& [word, symbol] : known) {
        if (name == word) {
            return symbol;
        }
    }
    return name;
}

/// Names of files that an assembly without geometry of its own refers to.
std::string external_files(std::string_view content)
{
    std::string names;
    for (size_t at = content.find("DOCUMENT_FILE("); at != std::string_view::npos;
         at = content.find("DOCUMENT_FILE(", at + 1)) {
        const size_t open = content.find('\'', at);
        const size_t close = open == std::string_view::npos ? open : content.find('\'', open + 1);
        if (close != std::string_view::npos && close > open + 1 && close - open < 200) {
            names += (names.empty() ? "" : ", ") + std::string(content.substr(open + 1, close - open - 1));
        }
    }
    return names;
}

Result<TopoDS_Shape> read_step(const std::string& path, std::string_view content, CadShape& result)
{
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM"); // a host program may have set another one
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{} is not valid STEP: its syntax cannot be parsed; export the file again", path));
    }
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    for (int i = 1; i <= lengths.Length(); ++i) {
        const std::string unit = unit_symbol(lengths(i).ToCString());
        if (result.units.empty()) {
            result.units = unit;
        } else if (result.units != unit) {
            result.warnings.push_back(fmt::format("{} holds lengths in {} and {}; each part was converted by its own",
                                                  path, result.units, unit));
        }
    }
    const int roots = reader.NbRootsForTransfer();
    reader.TransferRoots();
    TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) {
        const std::string files = external_files(content);
        if (!files.empty()) {
            return fail(ErrorKind::rejected,
                        fmt::format("{} has no geometry of its own, its parts lie in other files ({}); "
                                    "read those, or export the assembly as one file",
                                    path, files));
        }
        return fail(ErrorKind::rejected,
                    fmt::format("{} has no geometry that can be read ({} entities, {} shapes); "
                                "export the part's surfaces or solids as STEP AP203, AP214 or AP242",
                                path, reader.StepModel()->NbEntities(), roots));
    }
    return shape;
}

Result<TopoDS_Shape> read_iges(const std::string& path, CadShape& result)
{
    IGESControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
        return fail(ErrorKind::unreadable, fmt::format("{} is not valid IGES; export the file again", path));
    }
    const Handle(IGESData_IGESModel) model = reader.IGESModel();
    if (!model.IsNull() && !model->GlobalSection().UnitName().IsNull()) {
        result.units = unit_symbol(model->GlobalSection().UnitName()->ToCString());
    }
    reader.TransferRoots();
    TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) {
        return fail(ErrorKind::rejected,
                    fmt::format("{} has no surfaces that can be read; export trimmed surfaces (entity 144) or a B-rep "
                                "(entity 186)",
                                path));
    }
    return shape;
}

Result<TopoDS_Shape> read_brep(const std::string& path, std::string_view content, FileFormat format)
{
    TopoDS_Shape shape;
    std::istringstream stream{std::string(content)};
    if (format == FileFormat::brep_binary) {
        BinTools::Read(shape, stream);
    } else {
        BRepTools::Read(shape, stream, BRep_Builder());
    }
    if (shape.IsNull()) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{} is not a valid BREP file: no shape could be built; export the file again", path));
    }
    return shape;
}

Result<TopoDS_Shape> read_shape(const std::string& path, FileFormat format, CadShape& result)
{
    const auto content = read_file_content(path);
    if (!content) {
        return tl::unexpected(content.error());
    }
    if (const auto whole = check_cad_envelope(format, content->view(), path); !whole) {
        return tl::unexpected(whole.error());
    }
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    const QuietOcct quiet;
    switch (format) {
    case FileFormat::step:
        return read_step(path, content->view(), result);
    case FileFormat::iges:
        return read_iges(path, result);
    case FileFormat::brep:
    case FileFormat::brep_binary:
        result.units = "mm";
        return read_brep(path, content->view(), format);
    default:
        return fail(ErrorKind::unreadable, fmt::format("{} is not a STEP, IGES or BREP file", path));
    }
}

} // namespace

Result<CadShape> read_cad_shape(const std::filesystem::path& path, FileFormat format, CadContent content)
{
    const std::string name = path.string();
    try {
        CadShape result;
        auto shape = read_shape(name, format, result);
        if (!shape) {
            return tl::unexpected(shape.error());
        }
        const bool curves = TopExp_Explorer(*shape, TopAbs_EDGE).More();
        if (content == CadContent::curves && !curves) {
            return fail(ErrorKind::rejected, fmt::format("{} holds no curve; export the line as a curve or edge", name));
        }
        if (content == CadContent::faces && !TopExp_Explorer(*shape, TopAbs_FACE).More()) {
            return fail(ErrorKind::rejected,
                        fmt::format("{} holds {} but no surface; export the part's faces or solids", name,
                                    curves ? "curves" : "points"));
        }
        result.shape = std::make_shared<TopoDS_Shape>(std::move(*shape));
        return result;
    } catch (const Standard_Failure& failure) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{} cannot be read: OpenCASCADE reports {} {}; export the file again", name,
                                failure.DynamicType()->Name(), failure.GetMessageString()));
    } catch (const std::exception& failure) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{} cannot be read: {}; export the file again", name, failure.what()));
    }
}

} // namespace tapeline
