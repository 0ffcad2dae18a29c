// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/page.h"

#include "embedded.h"
#include "plugin/runner/html.h"
#include "plugin/runner/numbers.h"
#include "plugin/runner/page_parts.h"

#include <algorithm>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// A picture whose name ends like this, or null.
const Picture* find_picture(const std::vector<Picture>& pictures, std::string_view kind)
{
    const std::string ending = fmt::format("_{}.png", kind);
    const auto found = std::ranges::find_if(pictures, [&](const Picture& p) { return p.name.ends_with(ending); });
    return found == pictures.end() ? nullptr : &*found;
}

std::string image(const Picture& picture, const std::string& alt)
{
    return fmt::format("<img alt=\"{}\" loading=\"lazy\" src=\"data:image/png;base64,{}\">", html_text(alt),
                       base64(picture.png));
}

struct Kind {
    const char* name;
    const char* title;
};
constexpr std::array<Kind, 4> kinds = {{{"shaded", "Shaded"},
                                        {"zebra", "Zebra stripes"},
                                        {"curvature", "Sign of the Gaussian curvature"},
                                        {"closeup", "Cut across the line, seen along it"}}};

std::string picture_row(const std::string& name, const std::string& words, const std::vector<Picture>& pictures)
{
    std::string html = fmt::format("<h3>{}{}</h3>\n<div class=\"row\">\n", html_text(name),
                                   words.empty() ? "" : fmt::format(" <span>{}</span>", html_text(words)));
    for (const Kind& kind : kinds) {
        if (const Picture* picture = find_picture(pictures, kind.name)) {
            html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                                image(*picture, fmt::format("{}, {}", name, kind.title)), kind.title);
        }
    }
    return html + "</div>\n";
}

std::string words_for(const PageEntry& entry)
{
    const Measures& m = *entry.measures;
    const QualityReport& q = m.quality;
    return fmt::format("{}{}inflections {} and {}", entry.title.empty() ? "" : entry.title + "; ",
                       m.has_compressed ? fmt::format("bulge {} mm, ", short_number(std::abs(q.bulge_max_mm))) : "",
                       q.compressed_sections.inflections_after, q.tension_sections.inflections_after);
}

std::string pictures_html(const Page& page)
{
    std::string html = picture_row("Before", "", page.before);
    for (const PageEntry& entry : page.entries) {
        if (!entry.pictures.empty()) {
            html += picture_row(page.entries.size() == 1 ? "After" : entry.name,
                                words_for(entry) + (entry.reason.empty() ? "" : "; " + entry.verdict), entry.pictures);
        }
    }
    return html;
}

std::string combs_html(const Page& page)
{
    std::string html;
    for (const PageEntry& entry : page.entries) {
        if (entry.sections) {
            html += fmt::format("<details{}><summary>{}: sections with curvature combs</summary>{}</details>\n",
                                html.empty() ? " open" : "", html_text(entry.name),
                                image(*entry.sections, entry.name + ", sections with curvature combs"));
        }
    }
    return html;
}

std::string list_html(const std::vector<std::string>& lines)
{
    std::string html;
    for (const std::string& line : lines) {
        html += fmt::format("<li>{}</li>\n", html_text(line));
    }
    return html.empty() ? html : "<ul>\n" + html + "</ul>\n";
}

std::string facts_html(const Page& page)
{
    std::string html;
    for (const auto& [name, value] : page.facts) {
        html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(name), html_text(value));
    }
    return html;
}

/// The view to turn with everything that it needs.
std::string viewer_html(const Page& page)
{
    if (page::leading(page) == nullptr || page.stage == nullptr || page.target == nullptr) {
        return {};
    }
    return fill_template(embedded::viewer_html(), {{"three", std::string(embedded::three())},
                                                   {"orbit", std::string(embedded::orbit_controls())},
                                                   {"script", std::string(embedded::viewer_js())},
                                                   {"scene", page::scene_json(page)}});
}

} // namespace

std::string page_html(const Page& page)
{
    const PageEntry* leader = page::leading(page);
    const bool single = page.entries.size() == 1;
    const std::string table = single && leader != nullptr
                                  ? page::measures_list(*leader->measures) + page::inner_lines_list(leader->inner_lines)
                                  : page::measures_table(page);
    const std::string description =
        page.description.empty() ? "" : fmt::format("<p class=\"description\">{}</p>", html_text(page.description));
    const std::string warnings = page.warnings.empty() ? "" : "<h2>Warnings</h2>\n" + list_html(page.warnings);
    return fill_template(embedded::page_html(), {{"title", html_text(page.title)},
                                                 {"style", std::string(embedded::page_css())},
                                                 {"headline", html_text(page.headline)},
                                                 {"description", description},
                                                 {"facts", facts_html(page)},
                                                 {"table", table},
                                                 {"notes", list_html(page.notes)},
                                                 {"viewer", viewer_html(page)},
                                                 {"pictures", pictures_html(page)},
                                                 {"sections", page::sections_svg(page)},
                                                 {"combs", combs_html(page)},
                                                 {"warnings", warnings},
                                                 {"footer", html_text(page.footer)}});
}

} // namespace tapeline
