// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture.h"

#include "io/canvas.h"
#include "io/picture_lines.h"
#include "io/shaders.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>

namespace tapeline {

namespace {

using picture::Align;
using picture::Canvas;
using picture::View;

std::string complaint(const Mesh& mesh, const PictureOptions& options)
{
    for (const int size : {options.width, options.height}) {
        if (size < 64 || size > 8192) {
            return fmt::format("a picture's sides must have 64 to 8192 pixels, not {}", size);
        }
    }
    if (mesh.F.rows() == 0) {
        return "the mesh has no triangles to draw";
    }
    if (mesh.F.minCoeff() < 0 || mesh.F.maxCoeff() >= mesh.V.rows()) {
        return "a triangle names a vertex that the mesh does not have";
    }
    if (!mesh.V.allFinite()) {
        return "a vertex has a coordinate that is not a finite number";
    }
    const bool mapped = options.shading == Shading::curvature_sign || options.shading == Shading::signed_map;
    if (mapped && options.values.size() != static_cast<size_t>(mesh.V.rows())) {
        return fmt::format("a map needs one value per vertex, {}, but {} were given", mesh.V.rows(),
                           options.values.size());
    }
    for (const PictureLine& line : options.lines) {
        if (!std::all_of(line.points.begin(), line.points.end(), [](const Vec3& p) { return p.allFinite(); })) {
            return fmt::format("line \"{}\" has a coordinate that is not a finite number", line.label);
        }
    }
    for (const std::vector<int>& line : options.sharp_lines) {
        for (const int v : line) {
            if (v < 0 || v >= mesh.V.rows()) {
                return fmt::format("line vertex {} is not in the mesh of {} vertices", v, mesh.V.rows());
            }
        }
    }
    if (options.camera && !(options.camera->height_mm > 0 && options.camera->direction.norm() > 0)) {
        return "the camera needs a direction and a height above zero";
    }
    return {};
}

/// Fills in what 0 or nothing stands for.
PictureOptions completed(const Mesh& mesh, PictureOptions options)
{
    if (!options.camera) {
        options.camera = fit_camera(mesh, {}, static_cast<double>(options.width) / options.height);
    }
    if (options.zebra_period <= 0 && options.shading == Shading::zebra) {
        options.zebra_period = fit_zebra(mesh, *options.camera);
    }
    if (options.value_range <= 0) {
        for (const double value : options.values) {
            options.value_range = std::max(options.value_range, std::isfinite(value) ? std::abs(value) : 0);
        }
    }
    return options;
}

/// 1, 2 or 5 times a power of ten, at most x.
double round_below(double x)
{
    const double power = std::pow(10, std::floor(std::log10(x)));
    return power * (x >= 5 * power ? 5 : (x >= 2 * power ? 2 : 1));
}

void draw_scale_bar(const Canvas& canvas, const View& view, double size)
{
    const double length = round_below(0.22 * view.width / view.pixels_per_mm);
    const double x = 1.6 * size, y = view.height - 1.6 * size, width = length * view.pixels_per_mm;
    canvas.ink(picture::soft_ink);
    cairo_set_line_width(canvas.cr(), 1.6);
    cairo_move_to(canvas.cr(), x, y - 4);
    cairo_line_to(canvas.cr(), x, y);
    cairo_line_to(canvas.cr(), x + width, y);
    cairo_line_to(canvas.cr(), x + width, y - 4);
    cairo_stroke(canvas.cr());
    canvas.text(x + 0.5 * width, y - 0.5 * size, fmt::format("{:g} mm", length), size, Align::centre);
}

/// Named colour fields in the lower right corner.
void draw_sign_legend(const Canvas& canvas, const View& view, double size)
{
    const std::array<std::pair<double, const char*>, 3> fields{
        {{1, "dome or bowl (K > 0)"}, {0, "single curved or flat"}, {-1, "saddle (K < 0)"}}};
    double x = view.width - 1.6 * size;
    for (const auto& [value, name] : fields) {
        x -= canvas.text_width(name, size);
        canvas.ink(picture::soft_ink);
        canvas.text(x, view.height - 1.6 * size, name, size);
        x -= 1.4 * size;
        const picture::Colour c = picture::sign_colour(value);
        canvas.rounded(x, view.height - 2.5 * size, size, size, 3);
        canvas.ink({c[0], c[1], c[2], 1});
        cairo_fill(canvas.cr());
        x -= 1.4 * size;
    }
}

void draw_map_legend(const Canvas& canvas, const View& view, const PictureOptions& options, double size)
{
    const double width = 0.24 * view.width, x = view.width - 1.6 * size - width, y = view.height - 2.4 * size;
    cairo_pattern_t* colours = cairo_pattern_create_linear(x, 0, x + width, 0);
    for (int i = 0; i <= 20; ++i) {
        const picture::Colour c = picture::map_colour(0.1 * i - 1);
        cairo_pattern_add_color_stop_rgb(colours, 0.05 * i, c[0], c[1], c[2]);
    }
    cairo_set_source(canvas.cr(), colours);
    canvas.rounded(x, y, width, 0.8 * size, 3);
    cairo_fill(canvas.cr());
    cairo_pattern_destroy(colours);
    canvas.ink(picture::soft_ink);
    const double range = options.value_range;
    canvas.text(x, y - 0.5 * size, fmt::format("{:+.3g}", -range), size);
    canvas.text(x + 0.5 * width, y - 0.5 * size, "0", size, Align::centre);
    canvas.text(x + width, y - 0.5 * size, fmt::format("{:+.3g} {}", range, options.value_unit), size, Align::right);
}

Result<void> draw(const std::filesystem::path& png, const Mesh& mesh, const PictureOptions& options)
{
    const View view(*options.camera, options.width, options.height);
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    const std::vector<char> sharp = picture::sharp_edges(mesh, topology, options.crease_angle, options.sharp_lines);
    Eigen::Matrix3d axes;
    axes << view.right, view.up, view.towards;
    const Positions normals = picture::corner_normals(mesh, topology, sharp) * axes;
    const auto sampling =
        options.shading == Shading::zebra ? picture::Sampling::every_quarter : picture::Sampling::every_face;
    const auto raster = picture::rasterise(mesh, view, picture::make_shader(mesh, normals, options), sampling);
    Canvas canvas(options.width, options.height);
    canvas.lay(raster);

    const picture::Visibility visibility(raster, view, bounding_diagonal(mesh.V));
    std::vector<std::pair<Vec3, Vec3>> edges;
    for (int e = 0; e < topology.edge_count(); ++e) {
        if (sharp[e]) {
            edges.emplace_back(mesh.V.row(topology.edge(e).a), mesh.V.row(topology.edge(e).b));
        }
    }
    const double size = std::clamp(options.height / 58.0, 8.0, 24.0);
    picture::draw_edges(canvas, visibility, edges, {0.10, 0.13, 0.18, 0.5}, 0.05 * size);
    picture::draw_lines(canvas, visibility, view, options.lines);
    if (!options.title.empty()) {
        canvas.ink(picture::dark_ink);
        canvas.text(1.6 * size, 2.4 * size, options.title, 1.35 * size, Align::left, true);
    }
    if (options.legend) {
        draw_scale_bar(canvas, view, size);
        if (options.shading == Shading::curvature_sign) {
            draw_sign_legend(canvas, view, size);
        } else if (options.shading == Shading::signed_map) {
            draw_map_legend(canvas, view, options, size);
        }
    }
    return canvas.write(png);
}

} // namespace

Result<void> draw_mesh(const std::filesystem::path& png, const Mesh& mesh, const PictureOptions& options)
{
    const std::string wrong = complaint(mesh, options);
    if (!wrong.empty()) {
        return fail(ErrorKind::rejected, fmt::format("{}: cannot draw the picture: {}.", png.string(), wrong));
    }
    try {
        return draw(png, mesh, completed(mesh, options));
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("{}: cannot draw the picture: {}.", png.string(), e.what()));
    }
}

} // namespace tapeline
