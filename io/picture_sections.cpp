// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/canvas.h"
#include "io/picture.h"
#include "kernel/sections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

using picture::Align;
using picture::Canvas;
using picture::Ink;

constexpr Ink compressed_ink{0.80, 0.33, 0.10, 1}, tension_ink{0.05, 0.42, 0.52, 1}, before_ink{0.35, 0.37, 0.40, 1};
constexpr Ink frame_ink{0.78, 0.80, 0.83, 1}, mark_ink{0.82, 0.05, 0.15, 1};
constexpr double panel_width = 440, panel_height = 250, gap = 18, head = 74, longest_tooth = 62;

/// A section with the numbers that its panel shows; axes of the panel in space.
struct Panel {
    const Section* section = nullptr;
    SectionShapes shapes;
    Vec3 along = Vec3::UnitX(), up = Vec3::UnitZ(); ///< rightwards (compressed to tension) and upwards (outward)

    /// Place in the section [mm]: rightwards and upwards from the moved line's point.
    Eigen::Vector2d flat(const Vec3& p) const
    {
        return {(p - section->origin).dot(along), (p - section->origin).dot(up)};
    }
};

/// What all panels share: how much of the section they show and how large.
struct Layout {
    Eigen::AlignedBox2d box; ///< [mm]
    double scale = 1;        ///< pixels per mm, rightwards
    double enlarged = 1;     ///< times as many upwards
    double comb = 0;         ///< pixels per curvature [1/mm]
};

const std::vector<Vec3>* polylines(const Section& s, int i)
{
    const std::array<const std::vector<Vec3>*, 4> all{&s.compressed_before, &s.compressed_after, &s.tension_before,
                                                      &s.tension_after};
    return all[i];
}

Panel make_panel(const Section& section)
{
    Panel panel;
    panel.section = &section;
    panel.shapes = section_shapes(section);
    // Level is from rim to rim, the compressed side to the left.
    const Vec3 left = section.compressed_after.empty() ? section.origin : section.compressed_after.back();
    const Vec3 right = section.tension_after.empty() ? section.origin : section.tension_after.back();
    Vec3 level = right - left;
    level -= level.dot(section.normal) * section.normal;
    const double length = level.norm();
    panel.up = section.outward;
    if (length > 0) {
        panel.along = level / length;
        Vec3 up = section.normal.cross(panel.along);
        panel.up = up.dot(section.outward) < 0 ? Vec3(-up) : up;
    } else {
        panel.along = section.outward.cross(section.normal);
    }
    return panel;
}

double round_factor(double x)
{
    for (const double factor : {20.0, 10.0, 5.0, 3.0, 2.0}) {
        if (x >= factor) {
            return factor;
        }
    }
    return 1;
}

Layout make_layout(const std::vector<Panel>& panels)
{
    Layout layout;
    std::vector<double> curvatures;
    for (const Panel& panel : panels) {
        for (int i = 0; i < 4; ++i) {
            for (const Vec3& p : *polylines(*panel.section, i)) {
                layout.box.extend(panel.flat(p));
            }
        }
        for (const SectionShape* shape : {&panel.shapes.compressed_before, &panel.shapes.tension_before,
                                          &panel.shapes.compressed_after, &panel.shapes.tension_after}) {
            for (const Vec3& k : shape->curvature) {
                curvatures.push_back(k.norm());
            }
        }
    }
    const Eigen::Vector2d size = layout.box.sizes().cwiseMax(1e-9 * layout.box.diagonal().norm() + 1e-300);
    layout.scale = (panel_width - 40) / size.x();
    // The curves take the middle half of the height; the combs need the rest.
    const double room = 0.42 * panel_height;
    layout.enlarged = round_factor(room / (layout.scale * size.y()));
    layout.scale = std::min(layout.scale, room / size.y() / layout.enlarged);
    if (!curvatures.empty()) {
        const auto most =
            curvatures.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(curvatures.size() - 1));
        std::nth_element(curvatures.begin(), most, curvatures.end());
        const double typical = *most, largest = *std::max_element(curvatures.begin(), curvatures.end());
        // Room for the longest tooth, but not at the price of seeing the others.
        layout.comb = typical * layout.box.diagonal().norm() > 1e-6
                          ? std::min(34 / typical, std::max(longest_tooth / largest, 12 / typical))
                          : 0;
    }
    return layout;
}

/// Draws within one panel whose upper left corner is (x, y).
class PanelPainter {
public:
    PanelPainter(const Canvas& canvas, const Panel& panel, const Layout& layout, double x, double y)
        : canvas_(canvas), panel_(panel), layout_(layout), x_(x), y_(y)
    {
    }

    void paint(int number, int count) const
    {
        canvas_.rounded(x_, y_, panel_width, panel_height, 8);
        canvas_.ink({1, 1, 1, 0.85});
        cairo_fill_preserve(canvas_.cr());
        cairo_set_line_width(canvas_.cr(), 1);
        canvas_.ink(frame_ink);
        cairo_stroke(canvas_.cr());
        cairo_save(canvas_.cr());
        cairo_rectangle(canvas_.cr(), x_ + 1, y_ + 28, panel_width - 2, panel_height - 64);
        cairo_clip(canvas_.cr());
        const Section& s = *panel_.section;
        comb(panel_.shapes.compressed_after, compressed_ink);
        comb(panel_.shapes.tension_after, tension_ink);
        curve(s.compressed_before, before_ink, true);
        curve(s.tension_before, before_ink, true);
        curve(s.compressed_after, compressed_ink, false);
        curve(s.tension_after, tension_ink, false);
        for (const SectionShape* shape : {&panel_.shapes.compressed_after, &panel_.shapes.tension_after}) {
            for (const Vec3& p : shape->inflection_points) {
                mark(p);
            }
        }
        line_point();
        cairo_restore(canvas_.cr());
        words(number, count);
    }

private:
    Eigen::Vector2d place(const Vec3& p) const
    {
        const Eigen::Vector2d q = panel_.flat(p) - layout_.box.center();
        return {x_ + 0.5 * panel_width + layout_.scale * q.x(),
                y_ + 0.52 * panel_height - layout_.scale * layout_.enlarged * q.y()};
    }

    void curve(const std::vector<Vec3>& points, const Ink& colour, bool dotted) const
    {
        const std::array<double, 2> dots{0.1, 4.5};
        cairo_set_dash(canvas_.cr(), dots.data(), dotted ? 2 : 0, 0);
        cairo_set_line_width(canvas_.cr(), dotted ? 1.9 : 2.2);
        canvas_.ink(colour);
        for (const Vec3& p : points) {
            const Eigen::Vector2d q = place(p);
            cairo_line_to(canvas_.cr(), q.x(), q.y());
        }
        cairo_stroke(canvas_.cr());
        cairo_set_dash(canvas_.cr(), nullptr, 0, 0);
    }

    /// Teeth on the hollow's far side: their length shows how strongly the curve bends, their side which way.
    void comb(const SectionShape& shape, const Ink& colour) const
    {
        const int count = static_cast<int>(shape.points.size());
        std::vector<Eigen::Vector2d> feet(count), tips(count);
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector2d before = place(shape.points[std::max(0, i - 1)]);
            const Eigen::Vector2d after = place(shape.points[std::min(count - 1, i + 1)]);
            Eigen::Vector2d normal(after.y() - before.y(), before.x() - after.x());
            normal = normal.norm() > 0 ? Eigen::Vector2d(normal.normalized()) : Eigen::Vector2d(0, -1);
            // Into the picture's axes: y runs downwards there.
            const Eigen::Vector2d bend(shape.curvature[i].dot(panel_.along), -shape.curvature[i].dot(panel_.up));
            const double tooth = std::min(layout_.comb * shape.curvature[i].norm(), longest_tooth);
            feet[i] = place(shape.points[i]);
            tips[i] = feet[i] + (bend.dot(normal) > 0 ? -tooth : tooth) * normal;
        }
        cairo_set_line_width(canvas_.cr(), 0.7);
        canvas_.ink({colour[0], colour[1], colour[2], 0.35});
        const int stride = std::max(1, count / 60);
        for (int i = 0; i < count; i += stride) {
            cairo_move_to(canvas_.cr(), feet[i].x(), feet[i].y());
            cairo_line_to(canvas_.cr(), tips[i].x(), tips[i].y());
        }
        cairo_stroke(canvas_.cr());
        cairo_set_line_width(canvas_.cr(), 1);
        canvas_.ink({colour[0], colour[1], colour[2], 0.6});
        for (const Eigen::Vector2d& tip : tips) {
            cairo_line_to(canvas_.cr(), tip.x(), tip.y());
        }
        cairo_stroke(canvas_.cr());
    }

    void mark(const Vec3& p) const
    {
        const Eigen::Vector2d q = place(p);
        cairo_arc(canvas_.cr(), q.x(), q.y(), 4.5, 0, 6.2832);
        canvas_.ink({1, 1, 1, 1});
        cairo_fill_preserve(canvas_.cr());
        cairo_set_line_width(canvas_.cr(), 1.8);
        canvas_.ink(mark_ink);
        cairo_stroke(canvas_.cr());
    }

    void line_point() const
    {
        const Eigen::Vector2d q = place(panel_.section->origin);
        cairo_arc(canvas_.cr(), q.x(), q.y(), 3.6, 0, 6.2832);
        canvas_.ink(picture::dark_ink);
        cairo_fill(canvas_.cr());
    }

    void words(int number, int count) const
    {
        canvas_.ink(picture::dark_ink);
        canvas_.text(x_ + 12, y_ + 20, fmt::format("Section {} of {}", number, count), 12.5, Align::left, true);
        canvas_.ink(picture::soft_ink);
        if (layout_.enlarged > 1) {
            canvas_.text(x_ + panel_width - 12, y_ + 20, fmt::format("height \u00d7 {:g}", layout_.enlarged), 11,
                         Align::right);
        }
        const auto numbers = [](const SectionShape& before, const SectionShape& after) {
            return fmt::format("inflections {} \u2192 {}, turning {:.1f}\u00b0 \u2192 {:.1f}\u00b0", before.inflections,
                               after.inflections, before.turning, after.turning);
        };
        canvas_.ink(compressed_ink);
        canvas_.text(x_ + 12, y_ + panel_height - 12,
                     numbers(panel_.shapes.compressed_before, panel_.shapes.compressed_after), 10.5);
        canvas_.ink(tension_ink);
        canvas_.text(x_ + panel_width - 12, y_ + panel_height - 12,
                     numbers(panel_.shapes.tension_before, panel_.shapes.tension_after), 10.5, Align::right);
    }

    const Canvas& canvas_;
    const Panel& panel_;
    const Layout& layout_;
    double x_, y_;
};

/// Title, key to the colours and scale bar above the panels.
void draw_head(const Canvas& canvas, const Layout& layout, double width)
{
    canvas.ink(picture::dark_ink);
    canvas.text(gap, 34, "Sections across the line", 20, Align::left, true);
    double x = gap;
    const auto entry = [&](const Ink& colour, const char* name) {
        canvas.ink(colour);
        cairo_set_line_width(canvas.cr(), 2.2);
        cairo_move_to(canvas.cr(), x, 57);
        cairo_line_to(canvas.cr(), x + 26, 57);
        cairo_stroke(canvas.cr());
        x += 34 + canvas.text(x + 34, 61, name, 12) + 26;
    };
    entry(compressed_ink, "compressed side, after");
    entry(tension_ink, "other side, after");
    const std::array<double, 2> dots{0.1, 4.5};
    cairo_set_dash(canvas.cr(), dots.data(), 2, 0);
    entry(before_ink, "before");
    cairo_set_dash(canvas.cr(), nullptr, 0, 0);
    canvas.ink(picture::soft_ink);
    canvas.text(x, 61, "teeth: curvature    ring: inflection    dot: the line", 12);
    const double target = 110 / layout.scale, power = std::pow(10, std::floor(std::log10(target)));
    const double length = power * (target >= 5 * power ? 5 : (target >= 2 * power ? 2 : 1));
    const double bar = length * layout.scale;
    cairo_set_line_width(canvas.cr(), 1.6);
    cairo_move_to(canvas.cr(), width - gap - bar, 57);
    cairo_line_to(canvas.cr(), width - gap, 57);
    cairo_stroke(canvas.cr());
    canvas.text(width - gap - 0.5 * bar, 50, fmt::format("{:g} mm", length), 12, Align::centre);
}

Result<void> draw_panels(const std::filesystem::path& png, const std::vector<Section>& sections)
{
    std::vector<Panel> panels;
    for (const Section& section : sections) {
        panels.push_back(make_panel(section));
    }
    const Layout layout = make_layout(panels);
    if (layout.box.isEmpty() || !layout.box.sizes().allFinite()) {
        return fail(ErrorKind::rejected,
                    fmt::format("{}: no section meets the surface, so there is nothing to draw.", png.string()));
    }
    const int count = static_cast<int>(panels.size());
    const int columns = std::min(count, 3), rows = (count + columns - 1) / columns;
    const double width = columns * (panel_width + gap) + gap, height = head + rows * (panel_height + gap);
    const Canvas canvas(static_cast<int>(std::max(width, 2 * panel_width)), static_cast<int>(height));
    draw_head(canvas, layout, std::max(width, 2 * panel_width));
    for (int i = 0; i < count; ++i) {
        const int column = i % columns, row = i / columns;
        const double x = gap + column * (panel_width + gap), y = head + row * (panel_height + gap);
        PanelPainter(canvas, panels[i], layout, x, y).paint(i + 1, count);
    }
    return canvas.write(png);
}

} // namespace

Result<void> draw_sections(const std::filesystem::path& png, const std::vector<Section>& sections)
{
    if (sections.empty()) {
        return fail(ErrorKind::rejected, fmt::format("{}: there are no sections to draw.", png.string()));
    }
    try {
        return draw_panels(png, sections);
    } catch (const std::exception& e) {
        return fail(ErrorKind::rejected, fmt::format("{}: cannot draw the sections: {}.", png.string(), e.what()));
    }
}

} // namespace tapeline
