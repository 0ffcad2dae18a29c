// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cad_shape.h"

#include "io/cad_envelope.h"
#include "io/child_process.h"
#include "io/file_content.h"

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
#include <charconv>
#include <fmt/format.h>
#include <sstream>

namespace tapeline {

namespace {

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
    stream.exceptions(std::ios::failbit | std::ios::badbit); // the reader itself loops on where a number is not one
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

Result<TopoDS_Shape> read_shape(const std::string& path, FileFormat format, std::string_view content, CadShape& result)
{
    switch (format) {
    case FileFormat::step:
        return read_step(path, content, result);
    case FileFormat::iges:
        return read_iges(path, result);
    case FileFormat::brep:
    case FileFormat::brep_binary:
        result.units = "mm";
        return read_brep(path, content, format);
    default:
        return fail(ErrorKind::unreadable, fmt::format("{} is not a STEP, IGES or BREP file", path));
    }
}

void put(std::string& message, std::string_view part)
{
    message += fmt::format("{}:", part.size());
    message += part;
}

/// The next part of a message made by `put`.
std::string_view take(std::string_view& message)
{
    size_t size = 0;
    const size_t colon = message.find(':');
    std::from_chars(message.data(), message.data() + std::min(colon, message.size()), size);
    const std::string_view part = message.substr(std::min(colon, message.size() - 1) + 1, size);
    message.remove_prefix(std::min(message.size(), colon + 1 + size));
    return part;
}

/// What the reading process sends: kind of error (empty = none) and its sentence, or unit, shape and warnings.
std::string read_and_pack(const std::string& path, FileFormat format, std::string_view content)
{
    std::string message;
    const auto failed = [&message](ErrorKind kind, const std::string& sentence) {
        message.clear();
        put(message, fmt::format("{}", static_cast<int>(kind)));
        put(message, sentence);
        return message;
    };
    try {
        CadShape result;
        const auto shape = read_shape(path, format, content, result);
        if (!shape) {
            return failed(shape.error().kind, shape.error().message);
        }
        std::ostringstream bytes;
        BinTools::Write(*shape, bytes, false, false, BinTools_FormatVersion_CURRENT);
        put(message, "");
        put(message, result.units);
        put(message, bytes.view());
        for (const std::string& warning : result.warnings) {
            put(message, warning);
        }
        return message;
    } catch (const Standard_Failure& failure) {
        return failed(ErrorKind::unreadable,
                      fmt::format("{} cannot be read: OpenCASCADE reports {} {}; export the file again", path,
                                  failure.DynamicType()->Name(), failure.GetMessageString()));
    } catch (const std::exception& failure) {
        return failed(ErrorKind::unreadable,
                      fmt::format("{} cannot be read: {}; export the file again", path, failure.what()));
    }
}

/// Reads in a process of its own: OpenCASCADE's readers end theirs on many a damaged file (an entity of the wrong kind
/// where a point is due is enough), and they write to standard output, where a program's results go.
Result<std::string> packed_shape(const std::string& path, FileFormat format, std::string_view content)
{
    const int limit_seconds = static_cast<int>(60 + std::min<size_t>(content.size() / 50'000, 100'000));
    ChildOutput output = run_in_child([&] { return read_and_pack(path, format, content); }, limit_seconds);
    switch (output.end) {
    case ChildEnd::finished:
        return std::move(output.bytes);
    case ChildEnd::crashed:
        return fail(ErrorKind::unreadable,
                    fmt::format("{} is damaged: OpenCASCADE's reader breaks down on it; export the file again", path));
    case ChildEnd::timed_out:
        return fail(
            ErrorKind::unreadable,
            fmt::format("{} is not read after {} s, it may be damaged; export it again, or only the part needed", path,
                        limit_seconds));
    case ChildEnd::not_started:
        break;
    }
    return fail(ErrorKind::unreadable,
                fmt::format("{} cannot be read: no process can be started; end other programs first", path));
}

} // namespace

Result<CadShape> read_cad_shape(const std::filesystem::path& path, FileFormat format, CadContent wanted)
{
    const std::string name = path.string();
    try {
        const auto content = read_file_content(path);
        if (!content) {
            return tl::unexpected(content.error());
        }
        if (const auto whole = check_cad_envelope(format, content->view(), name); !whole) {
            return tl::unexpected(whole.error());
        }
        const auto packed = packed_shape(name, format, content->view());
        if (!packed) {
            return tl::unexpected(packed.error());
        }
        std::string_view message = *packed;
        if (const std::string_view error = take(message); !error.empty()) {
            return fail(static_cast<ErrorKind>(error.front() - '0'), std::string(take(message)));
        }
        CadShape result;
        result.units = take(message);
        std::istringstream bytes{std::string(take(message))};
        while (!message.empty()) {
            result.warnings.emplace_back(take(message));
        }
        TopoDS_Shape shape;
        BinTools::Read(shape, bytes);
        const bool curves = TopExp_Explorer(shape, TopAbs_EDGE).More();
        if (wanted == CadContent::curves && !curves) {
            return fail(ErrorKind::rejected,
                        fmt::format("{} holds no curve; export the line as a curve or edge", name));
        }
        if (wanted == CadContent::faces && !TopExp_Explorer(shape, TopAbs_FACE).More()) {
            return fail(ErrorKind::rejected,
                        fmt::format("{} holds {} but no surface; export the part's faces or solids", name,
                                    curves ? "curves" : "points"));
        }
        result.shape = std::make_shared<TopoDS_Shape>(std::move(shape));
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
