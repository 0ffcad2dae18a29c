// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tapeline::picture {

namespace {

struct Box {
    double x, y, width, height;

    bool meets(const Box& o) const
    {
        return x < o.x + o.width && o.x < x + width && y < o.y + o.height && o.y < y + height;
    }
};

void path_of(const Canvas& canvas, const std::vector<Vec3>& part)
{
    cairo_move_to(canvas.cr(), part.front().x(), part.front().y());
    for (size_t i = 1; i < part.size(); ++i) {
        cairo_line_to(canvas.cr(), part[i].x(), part[i].y());
    }
}

/// The visible point nearest to the line's middle; parts are pieces of about one pixel.
const Vec3* middle_of(const std::vector<std::vector<Vec3>>& parts)
{
    const auto longest =
        std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    return longest == parts.end() ? nullptr : &(*longest)[longest->size() / 2];
}

/// Finds room for a label near a point: above it, then around it ever farther out.
Box place_label(const Vec3& at, double width, double height, const View& view, const std::vector<Box>& taken)
{
    static constexpr std::array<std::array<double, 2>, 8> around{
        {{0.5, -1}, {-0.5, -1}, {0.7, 1}, {-0.7, 1}, {1.2, 0}, {-1.2, 0}, {0, -1.2}, {0, 1.2}}};
    Box first{};
    for (int ring = 0; ring < 6; ++ring) {
        for (size_t k = 0; k < around.size(); ++k) {
            const double reach = 26 + 24 * ring;
            Box box{at.x() + reach * around[k][0] - 0.5 * width, at.y() + reach * around[k][1] - 0.5 * height, width,
                    height};
            box.x = std::clamp(box.x, 6.0, std::max(6.0, view.width - width - 6));
            box.y = std::clamp(box.y, 6.0, std::max(6.0, view.height - height - 6));
            first = ring == 0 && k == 0 ? box : first;
            const Box roomy{box.x - 3, box.y - 3, box.width + 6, box.height + 6};
            const Box dot{at.x() - 5, at.y() - 5, 10, 10};
            if (!box.meets(dot) &&
                std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return roomy.meets(other); })) {
                return box;
            }
        }
    }
    return first;
}

void draw_label(const Canvas& canvas, const View& view, const PictureLine& line, const Vec3& at,
                std::vector<Box>& taken)
{
    const double size = std::clamp(view.height / 55.0, 9.0, 22.0);
    const double width = canvas.text_width(line.label, size, true) + size, height = 1.6 * size;
    const Box box = place_label(at, width, height, view, taken);
    taken.push_back(box);
    const Ink colour{line.colour[0], line.colour[1], line.colour[2], 1};
    cairo_set_line_width(canvas.cr(), 1.2);
    canvas.ink(colour);
    cairo_move_to(canvas.cr(), at.x(), at.y());
    cairo_line_to(canvas.cr(), box.x + 0.5 * width, box.y + 0.5 * height);
    cairo_stroke(canvas.cr());
    cairo_arc(canvas.cr(), at.x(), at.y(), 2.6, 0, 6.2832);
    cairo_fill(canvas.cr());
    canvas.rounded(box.x, box.y, width, height, 0.5 * height);
    canvas.ink({1, 1, 1, 0.94});
    cairo_fill_preserve(canvas.cr());
    canvas.ink(colour);
    cairo_stroke(canvas.cr());
    canvas.ink({0.75 * line.colour[0], 0.75 * line.colour[1], 0.75 * line.colour[2], 1});
    canvas.text(box.x + 0.5 * width, box.y + 0.5 * height + 0.36 * size, line.label, size, Align::centre, true);
}

} // namespace

Visibility::Visibility(const Raster& raster, const View& view, double size_mm)
    : raster_(raster), view_(view), bias_mm_(1e-3 * size_mm + 1 / view.pixels_per_mm)
{
}

bool Visibility::sees(const Vec3& projected) const
{
    const int x = static_cast<int>(std::floor(projected.x())), y = static_cast<int>(std::floor(projected.y()));
    float farthest = std::numeric_limits<float>::infinity();
    bool inside = false;
    for (int j = std::max(0, y - 1); j <= std::min(raster_.height - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(raster_.width - 1, x + 1); ++i) {
            inside = true;
            farthest = std::min(farthest, raster_.depth[static_cast<size_t>(j) * raster_.width + i]);
        }
    }
    return inside && projected.z() + bias_mm_ >= farthest;
}

std::vector<std::vector<Vec3>> Visibility::visible_parts(const std::vector<Vec3>& line) const
{
    std::vector<std::vector<Vec3>> parts;
    bool open = false;
    const auto visit = [&](const Vec3& p) {
        const bool seen = sees(p);
        if (seen && !open) {
            parts.emplace_back();
        }
        open = seen;
        if (seen) {
            parts.back().push_back(p);
        }
    };
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec3 to = view_.project(line[i]);
        if (i > 0) {
            const Vec3 from = view_.project(line[i - 1]);
            // Far outside the picture nothing is seen; the limit keeps wild coordinates cheap.
            const double pixels = std::min(1e5, (to - from).head<2>().norm());
            const int steps = static_cast<int>(std::ceil(pixels));
            for (int k = 1; k < steps; ++k) {
                visit(from + (to - from) * (static_cast<double>(k) / steps));
            }
        }
        visit(to);
    }
    std::erase_if(parts, [](const auto& part) { return part.size() < 2; });
    return parts;
}

void draw_lines(const Canvas& canvas, const Visibility& visibility, const View& view,
                const std::vector<PictureLine>& lines)
{
    const double usual = std::clamp(view.height / 300.0, 1.4, 6.0);
    std::vector<std::vector<std::vector<Vec3>>> parts;
    for (const PictureLine& line : lines) {
        parts.push_back(visibility.visible_parts(line.points));
    }
    for (const bool halo : {true, false}) {
        for (size_t i = 0; i < lines.size(); ++i) {
            const auto& colour = lines[i].colour;
            const double width = usual * lines[i].width;
            const std::array<double, 2> dots{0.1, 2.4 * width};
            cairo_set_dash(canvas.cr(), dots.data(), lines[i].dotted ? 2 : 0, 0);
            cairo_set_line_width(canvas.cr(), halo ? 2.2 * width : width);
            canvas.ink(halo ? Ink{1, 1, 1, 0.55} : Ink{colour[0], colour[1], colour[2], 1});
            for (const auto& part : parts[i]) {
                path_of(canvas, part);
            }
            cairo_stroke(canvas.cr());
        }
    }
    cairo_set_dash(canvas.cr(), nullptr, 0, 0);
    std::vector<Box> taken;
    for (size_t i = 0; i < lines.size(); ++i) {
        const Vec3* const at = middle_of(parts[i]);
        if (at != nullptr && !lines[i].label.empty()) {
            draw_label(canvas, view, lines[i], *at, taken);
        }
    }
}

void draw_edges(const Canvas& canvas, const Visibility& visibility, const std::vector<std::pair<Vec3, Vec3>>& edges,
                const Ink& colour, double width)
{
    cairo_set_line_width(canvas.cr(), width);
    canvas.ink(colour);
    for (const auto& [a, b] : edges) {
        for (const auto& part : visibility.visible_parts({a, b})) {
            cairo_move_to(canvas.cr(), part.front().x(), part.front().y());
            cairo_line_to(canvas.cr(), part.back().x(), part.back().y());
        }
    }
    cairo_stroke(canvas.cr()); // one stroke: overlaps do not darken
}

} // namespace tapeline::picture
