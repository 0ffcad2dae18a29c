// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/canvas.h"

#include "io/model_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tapeline::picture {

namespace {

/// Text as Cairo takes it: bytes that are not UTF-8 (file names may hold any) become question marks.
std::string valid_utf8(const std::string& text)
{
    std::string result;
    for (size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const size_t length =
            lead < 0x80 ? 1 : (lead >= 0xC2 && lead < 0xE0 ? 2 : (lead >= 0xE0 && lead < 0xF0 ? 3 : 0));
        bool good = length > 0 && i + length <= text.size() && lead >= 0x20 && lead != 0x7F;
        for (size_t k = 1; good && k < length; ++k) {
            good = (static_cast<unsigned char>(text[i + k]) & 0xC0U) == 0x80;
        }
        // Three-byte forms of short characters and of surrogates are no characters.
        if (good && length == 3) {
            const auto next = static_cast<unsigned char>(text[i + 1]);
            good = !(lead == 0xE0 && next < 0xA0) && !(lead == 0xED && next >= 0xA0);
        }
        result += good ? text.substr(i, length) : "?";
        i += good ? length : 1;
    }
    return result;
}

} // namespace

Canvas::Canvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)), context_(cairo_create(surface_.get()))
{
    cairo_pattern_t* background = cairo_pattern_create_linear(0, 0, 0, height);
    cairo_pattern_add_color_stop_rgb(background, 0, 0.985, 0.988, 0.992);
    cairo_pattern_add_color_stop_rgb(background, 1, 0.895, 0.910, 0.928);
    cairo_set_source(cr(), background);
    cairo_paint(cr());
    cairo_pattern_destroy(background);
    // Unhinted, so that text is the same at every place and on every machine with the same font.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(cr(), options);
    cairo_font_options_destroy(options);
    cairo_set_line_cap(cr(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cr(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::lay(const Raster& raster)
{
    cairo_surface_flush(surface_.get());
    unsigned char* const data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < raster.height; ++y) {
        auto* const row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
        for (int x = 0; x < raster.width; ++x) {
            const size_t pixel = static_cast<size_t>(y) * raster.width + x;
            const float cover = raster.coverage[pixel];
            if (cover <= 0) {
                continue;
            }
            std::uint32_t packed = 0;
            for (int i = 0; i < 3; ++i) {
                const float below = decode(static_cast<float>((row[x] >> (16 - 8 * i)) & 255U) / 255.0F);
                const float mixed = cover * std::min(raster.colour[pixel][i], 1.0F) + (1 - cover) * below;
                packed = packed << 8 | static_cast<std::uint32_t>(std::lround(255.0F * encode(mixed)));
            }
            row[x] = packed;
        }
    }
    cairo_surface_mark_dirty(surface_.get());
}

void Canvas::ink(const Ink& colour) const { cairo_set_source_rgba(cr(), colour[0], colour[1], colour[2], colour[3]); }

double Canvas::text_width(const std::string& text, double size, bool bold) const
{
    cairo_select_font_face(cr(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(cr(), valid_utf8(text).c_str(), &extents);
    return extents.x_advance;
}

double Canvas::text(double x, double y, const std::string& text, double size, Align align, bool bold) const
{
    const double width = text_width(text, size, bold);
    const double shift = align == Align::left ? 0 : (align == Align::centre ? 0.5 * width : width);
    cairo_move_to(cr(), x - shift, y);
    cairo_show_text(cr(), valid_utf8(text).c_str());
    cairo_new_path(cr());
    return width;
}

void Canvas::rounded(double x, double y, double width, double height, double radius) const
{
    const double r = std::min({radius, 0.5 * width, 0.5 * height}), quarter = std::numbers::pi / 2;
    cairo_new_sub_path(cr());
    cairo_arc(cr(), x + width - r, y + r, r, -quarter, 0);
    cairo_arc(cr(), x + width - r, y + height - r, r, 0, quarter);
    cairo_arc(cr(), x + r, y + height - r, r, quarter, 2 * quarter);
    cairo_arc(cr(), x + r, y + r, r, 2 * quarter, 3 * quarter);
    cairo_close_path(cr());
}

Result<void> Canvas::write(const std::filesystem::path& png) const
{
    std::string bytes;
    const auto append = [](void* to, const unsigned char* data, unsigned int length) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    };
    cairo_surface_flush(surface_.get());
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
    if (status != CAIRO_STATUS_SUCCESS || cairo_status(cr()) != CAIRO_STATUS_SUCCESS) {
        const char* const why = cairo_status_to_string(status != CAIRO_STATUS_SUCCESS ? status : cairo_status(cr()));
        return fail(ErrorKind::unreadable, fmt::format("{}: cannot make the picture ({}).", png.string(), why));
    }
    return write_file_atomically(png, bytes);
}

} // namespace tapeline::picture
