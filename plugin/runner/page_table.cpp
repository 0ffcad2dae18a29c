// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/html.h"
#include "plugin/runner/numbers.h"
#include "plugin/runner/page_parts.h"
#include "plugin/runner/stats.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace tapeline::page {

namespace {

enum class Better { less, more, near_zero, neither };

using Value = std::optional<double>;

/// One column: what it shows of an entry and of the state before.
struct Column {
    std::string group, label, unit;
    Better better = Better::less;
    int decimals = -1; ///< -1: as `number` writes it
    std::function<Value(const PageEntry&)> value;
    std::function<Value(const QualityReport&)> before = nullptr;
};

template <class Get>
auto quality(Get get)
{
    return [get](const PageEntry& e) -> Value { return static_cast<double>(get(e.measures->quality)); };
}

template <class Get>
auto compressed(Get get)
{
    return [get](const PageEntry& e) -> Value {
        return e.measures->has_compressed ? Value(static_cast<double>(get(e.measures->quality))) : std::nullopt;
    };
}

double of_slide(const QualityReport& q, double mm) { return q.slide_max_mm > 0 ? 100 * mm / q.slide_max_mm : 0; }

void add_shape_columns(std::vector<Column>& columns)
{
    using Q = QualityReport;
    columns.insert(
        columns.end(),
        {
            {"Bulge, max", "", "mm", Better::less, -1, compressed([](const Q& q) { return std::abs(q.bulge_max_mm); })},
            {"Bulge, max", "", "% slide", Better::less, -1,
             compressed([](const Q& q) { return 100 * q.bulge_fraction; })},
            {"Bulge, RMS", "", "mm", Better::less, -1, compressed([](const Q& q) { return q.bulge_rms_mm; })},
            {"Bulge, RMS", "", "% slide", Better::less, -1,
             compressed([](const Q& q) { return of_slide(q, q.bulge_rms_mm); })},
            {"Inflections", "compr.", "", Better::less, 0,
             compressed([](const Q& q) { return q.compressed_sections.inflections_after; }),
             [](const Q& q) { return q.compressed_sections.inflections_before; }},
            {"Inflections", "tension", "", Better::less, 0,
             quality([](const Q& q) { return q.tension_sections.inflections_after; }),
             [](const Q& q) { return q.tension_sections.inflections_before; }},
            {"Turning", "compr.", "deg", Better::neither, 1,
             compressed([](const Q& q) { return q.compressed_sections.turning_after; }),
             [](const Q& q) { return q.compressed_sections.turning_before; }},
            {"Turning", "tension", "deg", Better::neither, 1,
             quality([](const Q& q) { return q.tension_sections.turning_after; }),
             [](const Q& q) { return q.tension_sections.turning_before; }},
            {"Turning", "rise", "deg", Better::less, 2, quality([](const Q& q) {
                 return std::max({0.0, q.compressed_sections.turning_increase, q.tension_sections.turning_increase});
             })},
            {"Gauss sign", "compr.", "%", Better::less, 2,
             compressed([](const Q& q) { return 100 * q.gauss_sign_change_compressed; })},
            {"Gauss sign", "all", "%", Better::less, 2, quality([](const Q& q) { return 100 * q.gauss_sign_change; })},
            {"Crown", "tension", "change", Better::near_zero, 2,
             [](const PageEntry& e) -> Value {
                 const auto& crown = e.measures->quality.crown;
                 return crown ? Value(crown->change) : std::nullopt;
             }},
            {"Crease", "diff. RMS", "deg", Better::less, 2,
             quality([](const Q& q) { return q.crease_rms_difference; })},
        });
}

void add_triangle_columns(std::vector<Column>& columns)
{
    using Q = QualityReport;
    columns.insert(
        columns.end(),
        {
            {"Rim crease", "mean", "deg", Better::less, 2,
             quality([](const Q& q) { return q.rim_crease_mean_change; })},
            {"Rim crease", "max", "deg", Better::less, 2, quality([](const Q& q) { return q.rim_crease_max_change; })},
            {"End kink", "mean", "deg", Better::less, 2,
             [](const PageEntry& e) -> Value { return e.measures->quality.extension_crease_mean_change; }},
            {"End kink", "max", "deg", Better::less, 2,
             [](const PageEntry& e) -> Value { return e.measures->quality.extension_crease_max_change; }},
            {"Triangles", "min angle", "deg", Better::more, 1, quality([](const Q& q) { return q.min_angle_after; }),
             [](const Q& q) { return q.min_angle_before; }},
            {"Triangles", "squash", "", Better::more, 3, quality([](const Q& q) { return q.squash; })},
            {"Triangles", "flips", "", Better::less, 0, quality([](const Q& q) { return q.flipped; })},
            {"Solver", "iterations", "", Better::neither, 0,
             [](const PageEntry& e) -> Value { return e.move->iterations(); }},
            {"Solver", "error", "mm", Better::neither, -1,
             [](const PageEntry& e) -> Value { return e.move->error_estimate_mm(); }},
            {"Solver", "time", "s", Better::less, 2, [](const PageEntry& e) -> Value { return e.seconds; }},
        });
}

/// What became of the other feature lines: the one whose crease changed most, and the one that left its place farthest
/// of those that are meant to keep it.
void add_line_columns(std::vector<Column>& columns)
{
    columns.push_back({"Other lines", "crease", "deg", Better::less, 2, [](const PageEntry& e) {
                           Value most;
                           for (const InnerLine& line : e.inner_lines) {
                               most = std::max(most.value_or(0), std::abs(line.crease_after - line.crease_before));
                           }
                           return most;
                       }});
    columns.push_back({"Other lines", "off by", "mm", Better::neither, -1, [](const PageEntry& e) {
                           Value most;
                           for (const InnerLine& line : e.inner_lines) {
                               if (line.role != InnerLineRole::follows) {
                                   most = std::max(most.value_or(0), line.off_line_mm);
                               }
                           }
                           return most;
                       }});
}

std::vector<Column> all_columns(const Page& page)
{
    std::vector<Column> columns;
    add_shape_columns(columns);
    if (std::ranges::any_of(page.entries, [](const PageEntry& e) { return !e.inner_lines.empty(); })) {
        add_line_columns(columns);
    }
    add_triangle_columns(columns);
    if (std::ranges::any_of(page.entries, [](const PageEntry& e) { return e.move && e.move->uniqueness.checked; })) {
        columns.push_back({"Unique", "to", "mm", Better::less, -1, [](const PageEntry& e) {
                               const UniquenessReport& u = e.move->uniqueness;
                               return u.checked ? Value(u.distance_mm) : std::nullopt;
                           }});
    }
    return columns;
}

std::string cell_text(const Column& column, const Value& value)
{
    if (!value || !std::isfinite(*value)) {
        return "–";
    }
    return column.decimals < 0 ? short_number(*value) : fmt::format("{:.{}f}", *value, column.decimals);
}

bool better(Better wanted, double value, double than)
{
    switch (wanted) {
    case Better::less:
        return value < than;
    case Better::more:
        return value > than;
    case Better::near_zero:
        return std::abs(value) < std::abs(than);
    case Better::neither:
        break;
    }
    return false;
}

/// The text of the best cells of a column; nothing where all are alike.
std::string best_text(const Column& column, const Page& page)
{
    std::optional<double> best;
    std::vector<std::string> texts;
    for (const PageEntry& entry : page.entries) {
        const Value value = entry.move != nullptr && entry.sound ? column.value(entry) : std::nullopt;
        if (value && std::isfinite(*value)) {
            best = !best || better(column.better, *value, *best) ? value : best;
            texts.push_back(cell_text(column, value));
        }
    }
    const bool alike = std::ranges::all_of(texts, [&](const std::string& text) { return text == texts.front(); });
    return column.better == Better::neither || alike ? std::string() : cell_text(column, best);
}

std::string table_head(const std::vector<Column>& columns)
{
    std::string groups =
        "<tr><th class=\"name\" rowspan=\"2\">Method</th><th class=\"verdict\" rowspan=\"2\">Verdict</th>";
    std::string labels = "<tr>";
    for (std::size_t k = 0; k < columns.size();) {
        std::size_t end = k;
        while (end < columns.size() && columns[end].group == columns[k].group) {
            const std::string unit =
                columns[end].unit.empty() ? "" : fmt::format("<small>{}</small>", columns[end].unit);
            labels +=
                fmt::format("<th{}>{}{}</th>", end == k ? " class=\"first\"" : "", html_text(columns[end].label), unit);
            ++end;
        }
        groups += fmt::format("<th class=\"group first\" colspan=\"{}\">{}</th>", end - k, html_text(columns[k].group));
        k = end;
    }
    return "<thead>" + groups + "</tr>\n" + labels + "</tr></thead>\n";
}

bool starts_group(const std::vector<Column>& columns, std::size_t k)
{
    return k == 0 || columns[k].group != columns[k - 1].group;
}

std::string before_row(const std::vector<Column>& columns, const PageEntry& leader)
{
    std::string row = "<tr class=\"before\"><th class=\"name\">before</th><td class=\"verdict\"></td>";
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Value value = columns[k].before ? columns[k].before(leader.measures->quality) : std::nullopt;
        row += fmt::format("<td{}>{}</td>", starts_group(columns, k) ? " class=\"first\"" : "",
                           value ? cell_text(columns[k], value) : "");
    }
    return row + "</tr>\n";
}

std::string entry_row(const std::vector<Column>& columns, const PageEntry& entry, const std::vector<std::string>& best)
{
    std::string row =
        fmt::format("<tr{}><th class=\"name\" title=\"{}\">{}</th>", entry.sound ? "" : " class=\"unsound\"",
                    html_text(entry.title), html_text(entry.name));
    if (entry.move == nullptr) {
        return row + fmt::format("<td class=\"verdict\">{}</td><td class=\"reason\" colspan=\"{}\">{}</td></tr>\n",
                                 html_text(entry.verdict), columns.size(), html_text(entry.reason));
    }
    row += fmt::format("<td class=\"verdict\" title=\"{}\">{}</td>", html_text(entry.missed), html_text(entry.verdict));
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const std::string text = cell_text(columns[k], columns[k].value(entry));
        const bool marked = entry.sound && !best[k].empty() && text == best[k];
        const std::string style = std::string(starts_group(columns, k) ? "first " : "") + (marked ? "best" : "");
        row += fmt::format("<td{}>{}</td>", style.empty() ? "" : fmt::format(" class=\"{}\"", style), text);
    }
    row += "</tr>\n";
    if (!entry.reason.empty()) {
        row += fmt::format(
            "<tr class=\"unsound\"><th class=\"name\"></th><td class=\"reason\" colspan=\"{}\">{}</td></tr>\n",
            columns.size() + 1, html_text(entry.reason));
    }
    return row;
}

} // namespace

const PageEntry* leading(const Page& page)
{
    const auto found = std::ranges::find_if(page.entries, [](const PageEntry& e) { return e.move != nullptr; });
    return found == page.entries.end() ? nullptr : &*found;
}

std::string measures_table(const Page& page)
{
    const PageEntry* leader = leading(page);
    std::vector<Column> columns = all_columns(page);
    std::vector<std::string> best;
    for (const Column& column : columns) {
        best.push_back(best_text(column, page));
    }
    std::string table = "<div class=\"scroll\"><table class=\"measures\">\n" + table_head(columns) + "<tbody>\n";
    if (leader != nullptr) {
        table += before_row(columns, *leader);
    }
    for (const PageEntry& entry : page.entries) {
        table += entry_row(columns, entry, best);
    }
    return table + "</tbody></table></div>\n";
}

std::string measures_list(const Measures& measures)
{
    std::string table = "<table class=\"list\"><tbody>\n";
    bool head = true;
    for (const auto& row : measure_rows(measures)) {
        const char* tag = head ? "th" : "td";
        table += fmt::format("<tr><th class=\"name\">{0}</th><{3}>{1}</{3}><{3}>{2}</{3}></tr>\n", html_text(row.at(0)),
                             html_text(row.size() > 1 ? row[1] : ""), html_text(row.size() > 2 ? row[2] : ""), tag);
        head = false;
    }
    return table + "</tbody></table>\n";
}

std::string inner_lines_list(const std::vector<InnerLine>& lines)
{
    if (lines.empty()) {
        return {};
    }
    std::string table = "<table class=\"list\"><tbody>\n<tr><th class=\"name\">Other feature lines</th><th>length</th>"
                        "<th>crease before</th><th>after</th><th>off its place</th></tr>\n";
    for (const InnerLine& line : lines) {
        table += fmt::format("<tr><th class=\"name\">{}, {}</th><td>{} mm</td><td>{:.2f}°</td><td>{:.2f}°</td>"
                             "<td>{} mm</td></tr>\n",
                             line.id < 0 ? "no number" : fmt::format("line {}", line.id), role_word(line.role),
                             short_number(line.length_mm), line.crease_before, line.crease_after,
                             short_number(line.off_line_mm));
    }
    return table + "</tbody></table>\n";
}

} // namespace tapeline::page
