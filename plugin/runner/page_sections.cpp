// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/html.h"
#include "plugin/runner/page_parts.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tapeline::page {

namespace {

constexpr double width = 640, height = 250, margin = 18;
constexpr int places = 3;

using Curve = std::vector<Eigen::Vector2d>;

/// Right and up of one panel in space.
struct Axes {
    Vec3 origin, along, up;
    Curve flat(const std::vector<Vec3>& points) const
    {
        Curve curve;
        for (const Vec3& p : points) {
            curve.emplace_back((p - origin).dot(along), (p - origin).dot(up));
        }
        return curve;
    }
};

/// One place of the line: the curves of the state before and of every entry.
struct Panel {
    std::vector<Curve> before;
    std::vector<std::pair<std::size_t, Curve>> after; ///< entry, curve
};

std::vector<Section> sections_of(const PageEntry& entry, const TargetCurve& target)
{
    QualityInput input = quality_input(*entry.move, target);
    input.stations = places;
    return cross_sections(input);
}

/// Level is from rim to rim, the compressed side to the left.
Axes axes_of(const Section& s)
{
    const Vec3 left = s.compressed_after.empty() ? s.origin : s.compressed_after.back();
    const Vec3 right = s.tension_after.empty() ? s.origin : s.tension_after.back();
    Vec3 level = right - left;
    level -= level.dot(s.normal) * s.normal;
    if (level.norm() <= 0) {
        level = s.outward.cross(s.normal);
    }
    level.normalize();
    const Vec3 up = s.normal.cross(level);
    return {s.origin, level, up.dot(s.outward) < 0 ? Vec3(-up) : up};
}

std::vector<Panel> panels_of(const Page& page, const PageEntry& leader)
{
    std::vector<Axes> axes;
    std::vector<Panel> panels;
    for (const Section& s : sections_of(leader, *page.target)) {
        axes.push_back(axes_of(s));
        panels.emplace_back();
        for (const auto* half : {&s.compressed_before, &s.tension_before}) {
            panels.back().before.push_back(axes.back().flat(*half));
        }
    }
    for (std::size_t e = 0; e < page.entries.size(); ++e) {
        if (page.entries[e].move == nullptr) {
            continue;
        }
        const std::vector<Section> sections = sections_of(page.entries[e], *page.target);
        for (std::size_t k = 0; k < std::min(panels.size(), sections.size()); ++k) {
            for (const auto* half : {&sections[k].compressed_after, &sections[k].tension_after}) {
                panels[k].after.emplace_back(e, axes[k].flat(*half));
            }
        }
    }
    return panels;
}

/// 1, 2 or 5 times a power of ten, at most x.
double round_below(double x)
{
    const double power = std::pow(10, std::floor(std::log10(x)));
    return power * (x >= 5 * power ? 5 : (x >= 2 * power ? 2 : 1));
}

/// How the panels, which share one scale, show millimetres.
struct Scale {
    Eigen::AlignedBox2d box;
    double across = 1, enlarged = 1;

    explicit Scale(const std::vector<Panel>& panels)
    {
        for (const Panel& panel : panels) {
            for (const Curve& curve : panel.before) {
                extend(curve);
            }
            for (const auto& [entry, curve] : panel.after) {
                extend(curve);
            }
        }
        if (box.isEmpty()) {
            return;
        }
        const double wide = std::max(box.sizes().x(), 1e-9), high = std::max(box.sizes().y(), 1e-9 * wide);
        across = (width - 2 * margin) / wide;
        const double room = height - 64;
        enlarged = std::clamp(round_below(std::max(1.0, room / (across * high))), 1.0, 20.0);
        across = std::min(across, room / (high * enlarged));
    }
    void extend(const Curve& curve)
    {
        for (const Eigen::Vector2d& p : curve) {
            box.extend(p);
        }
    }
    std::string path(const Curve& curve) const
    {
        std::string d;
        for (const Eigen::Vector2d& p : curve) {
            const Eigen::Vector2d q = p - box.center();
            d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", 0.5 * width + across * q.x(),
                             0.5 * height + 8 - across * enlarged * q.y());
        }
        return d;
    }
};

std::string panel_svg(const Panel& panel, const Scale& scale, std::size_t place, std::size_t count)
{
    std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Section {} of {}\">\n", width,
                                  height, place + 1, count);
    svg += fmt::format("<text x=\"{}\" y=\"22\" class=\"label\">Section at {:.0f} % of the line</text>", margin,
                       100 * (static_cast<double>(place) + 0.5) / static_cast<double>(count));
    const double bar = round_below(120 / scale.across);
    svg += fmt::format(
        "<path d=\"M{:.1f} {:.1f}h{:.1f}\" class=\"bar\"/><text x=\"{:.1f}\" y=\"{:.1f}\" class=\"unit\">{:g} "
        "mm{}</text>\n",
        margin, height - 14, bar * scale.across, margin + bar * scale.across + 8, height - 10, bar,
        scale.enlarged > 1 ? fmt::format(", height × {:g}", scale.enlarged) : "");
    // The best lies on top.
    for (auto at = panel.after.rbegin(); at != panel.after.rend(); ++at) {
        svg += fmt::format("<path d=\"{}\" stroke=\"{}\" class=\"after{}\"/>\n", scale.path(at->second),
                           entry_colour(at->first), at->first == 0 ? " best" : "");
    }
    for (const Curve& curve : panel.before) {
        svg += fmt::format("<path d=\"{}\" class=\"original\"/>\n", scale.path(curve));
    }
    return svg + "</svg>\n";
}

} // namespace

std::string entry_colour(std::size_t entry)
{
    static constexpr std::array<const char*, 10> colours = {"#b3261e", "#1f6fb2", "#2e8b57", "#c77d0a", "#7a4fa3",
                                                            "#0f8b8d", "#8c564b", "#d1498b", "#7f8c1f", "#5b6b7a"};
    return colours[entry % colours.size()];
}

std::string sections_svg(const Page& page)
{
    const PageEntry* leader = leading(page);
    if (leader == nullptr || page.target == nullptr) {
        return {};
    }
    const std::vector<Panel> panels = panels_of(page, *leader);
    const Scale scale(panels);
    if (scale.box.isEmpty()) {
        return {};
    }
    std::string html = "<p class=\"key\">";
    for (std::size_t e = 0; e < page.entries.size(); ++e) {
        if (page.entries[e].move != nullptr) {
            html += fmt::format("<span><i style=\"background:{}\"></i>{}</span>", entry_colour(e),
                                html_text(page.entries[e].name));
        }
    }
    html += "<span><i class=\"dots\"></i>before</span></p>\n<div class=\"sections\">\n";
    for (std::size_t k = 0; k < panels.size(); ++k) {
        html += panel_svg(panels[k], scale, k, panels.size());
    }
    return html + "</div>\n";
}

} // namespace tapeline::page
