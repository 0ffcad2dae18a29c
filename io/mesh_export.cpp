// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes.h"
#include "io/model_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

// fmt writes a double as the shortest text that reads back to the same double, in every locale.
using Text = std::string;

template <class Format, class... Values>
void put(Text& text, const Format& format, const Values&... values)
{
    fmt::format_to(std::back_inserter(text), format, values...);
}

std::string obj_text(const Mesh& mesh)
{
    Text text;
    put(text, FMT_COMPILE("# Tapeline: {} vertices, {} triangles\n"), mesh.V.rows(), mesh.F.rows());
    for (int v = 0; v < mesh.V.rows(); ++v) {
        put(text, FMT_COMPILE("v {} {} {}\n"), mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        put(text, FMT_COMPILE("f {} {} {}\n"), mesh.F(t, 0) + 1, mesh.F(t, 1) + 1, mesh.F(t, 2) + 1);
    }
    return text;
}

/// The vertex and face lines that ASCII PLY and OFF have in common.
void put_lists(Text& text, const Mesh& mesh)
{
    for (int v = 0; v < mesh.V.rows(); ++v) {
        put(text, FMT_COMPILE("{} {} {}\n"), mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        put(text, FMT_COMPILE("3 {} {} {}\n"), mesh.F(t, 0), mesh.F(t, 1), mesh.F(t, 2));
    }
}

std::string off_text(const Mesh& mesh)
{
    Text text;
    put(text, FMT_COMPILE("OFF\n{} {} 0\n"), mesh.V.rows(), mesh.F.rows());
    put_lists(text, mesh);
    return text;
}

std::string ply_bytes(const Mesh& mesh, bool ascii)
{
    Text text;
    put(text,
        FMT_COMPILE("ply\nformat {} 1.0\ncomment Tapeline\nelement vertex {}\nproperty double x\nproperty double y\n"
                    "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n"),
        ascii ? "ascii" : "binary_little_endian", mesh.V.rows(), mesh.F.rows());
    if (ascii) {
        put_lists(text, mesh);
        return text;
    }
    text.reserve(text.size() + 24 * static_cast<std::size_t>(mesh.V.rows()) +
                 13 * static_cast<std::size_t>(mesh.F.rows()));
    for (int v = 0; v < mesh.V.rows(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            store(text, mesh.V(v, axis), Endian::little);
        }
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        text += '\3';
        for (int k = 0; k < 3; ++k) {
            store(text, mesh.F(t, k), Endian::little);
        }
    }
    return text;
}

std::string stl_text(const Mesh& mesh, const std::string& name)
{
    Text text;
    put(text, FMT_COMPILE("solid {}\n"), name);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Vec3 n = triangle_normal(mesh, t);
        put(text, FMT_COMPILE("facet normal {} {} {}\nouter loop\n"), n.x(), n.y(), n.z());
        for (int k = 0; k < 3; ++k) {
            const auto p = mesh.V.row(mesh.F(t, k));
            put(text, FMT_COMPILE("vertex {} {} {}\n"), p[0], p[1], p[2]);
        }
        put(text, FMT_COMPILE("endloop\nendfacet\n"));
    }
    put(text, FMT_COMPILE("endsolid {}\n"), name);
    return text;
}

std::string stl_bytes(const Mesh& mesh)
{
    std::string bytes = "Tapeline binary STL"; // must not start with "solid"
    bytes.resize(80, ' ');
    bytes.reserve(84 + 50 * static_cast<std::size_t>(mesh.F.rows()));
    store(bytes, static_cast<std::uint32_t>(mesh.F.rows()), Endian::little);
    const auto put_point = [&bytes](const Vec3& p) {
        for (int axis = 0; axis < 3; ++axis) {
            store(bytes, static_cast<float>(p[axis]), Endian::little);
        }
    };
    for (int t = 0; t < mesh.F.rows(); ++t) {
        put_point(triangle_normal(mesh, t));
        for (int k = 0; k < 3; ++k) {
            put_point(mesh.V.row(mesh.F(t, k)));
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

/// Letters, digits, - and _ of the file's stem, which every reader of ASCII STL takes as one word.
std::string solid_name(const std::filesystem::path& path)
{
    std::string name = path.stem().string();
    std::ranges::replace_if(
        name, [](unsigned char c) { return c > 127 || (!std::isalnum(c) && c != '-' && c != '_'); }, '_');
    return name.empty() ? "tapeline" : name;
}

/// The first reason not to write this mesh; empty when there is none.
std::string unfit(const Mesh& mesh, bool single_precision)
{
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const double largest = mesh.V.row(v).cwiseAbs().maxCoeff();
        if (!mesh.V.row(v).allFinite()) {
            return fmt::format("vertex {} is not a finite point", v);
        }
        if (single_precision && largest > static_cast<double>(std::numeric_limits<float>::max())) {
            return fmt::format("vertex {} lies too far out for binary STL's float32, write another format", v);
        }
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        if (mesh.F.row(t).minCoeff() < 0 || mesh.F.row(t).maxCoeff() >= mesh.V.rows()) {
            return fmt::format("triangle {} names a vertex that is not there", t);
        }
    }
    return {};
}

} // namespace

Result<void> write_mesh(const std::filesystem::path& path, const Mesh& mesh, const ExportOptions& options)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending != ".stl" && ending != ".obj" && ending != ".ply" && ending != ".off") {
        return fail(ErrorKind::usage,
                    fmt::format("cannot write {}: the name must end in .stl, .obj, .ply or .off", path.string()));
    }
    if (!(options.units_mm > 0) || !std::isfinite(options.units_mm)) {
        return fail(ErrorKind::usage,
                    fmt::format("the length of a file unit is {} mm, it must be above 0", options.units_mm));
    }
    try {
        if (options.units_mm != 1) {
            return write_mesh(path, {mesh.V / options.units_mm, mesh.F}, {options.ascii, 1});
        }
        if (const std::string reason = unfit(mesh, ending == ".stl" && !options.ascii); !reason.empty()) {
            return fail(ErrorKind::rejected, fmt::format("cannot write {}: {}", path.string(), reason));
        }
        if (ending == ".stl") {
            return write_file_atomically(path, options.ascii ? stl_text(mesh, solid_name(path)) : stl_bytes(mesh));
        }
        if (ending == ".ply") {
            return write_file_atomically(path, ply_bytes(mesh, options.ascii));
        }
        return write_file_atomically(path, ending == ".obj" ? obj_text(mesh) : off_text(mesh));
    } catch (const std::exception& error) {
        return fail(ErrorKind::unreadable, fmt::format("cannot write {}: {}", path.string(), error.what()));
    }
}

} // namespace tapeline
