// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/feature_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tapeline {

namespace {

/// One end of a range: a length, in mm or as a share of the whole.
struct Station {
    double value = 0;
    bool percent = false;
};

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') {
        text.remove_prefix(1);
    }
    while (!text.empty() && text.back() == ' ') {
        text.remove_suffix(1);
    }
    return text;
}

std::optional<Station> parse_station(std::string_view text)
{
    text = trimmed(text);
    Station station;
    if (text.ends_with('%')) {
        station.percent = true;
        text = trimmed(text.substr(0, text.size() - 1));
    } else if (text.ends_with("mm")) {
        text = trimmed(text.substr(0, text.size() - 2));
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), station.value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(station.value)) {
        return {};
    }
    return station;
}

struct Selector {
    int id = 0;
    std::optional<std::pair<Station, Station>> range;
};

std::optional<Selector> parse_selector(std::string_view text)
{
    Selector selector;
    const size_t at = text.find('@');
    const std::string_view id = trimmed(text.substr(0, at));
    const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), selector.id);
    if (error != std::errc() || end != id.data() + id.size()) {
        return {};
    }
    if (at != std::string_view::npos) {
        const std::string_view range = text.substr(at + 1);
        const size_t dots = range.find("..");
        if (dots == std::string_view::npos) {
            return {};
        }
        const auto from = parse_station(range.substr(0, dots)), to = parse_station(range.substr(dots + 2));
        if (!from || !to) {
            return {};
        }
        selector.range = {*from, *to};
    }
    return selector;
}

/// Position in `lengths` nearest to `wanted`.
int nearest_station(const std::vector<double>& lengths, double wanted)
{
    int best = 0;
    for (int k = 1; k < static_cast<int>(lengths.size()); ++k) {
        if (std::abs(lengths[k] - wanted) < std::abs(lengths[best] - wanted)) {
            best = k;
        }
    }
    return best;
}

} // namespace

Result<FeatureLine> select_line(const Model& model, const std::vector<FeatureLine>& lines, std::string_view selector)
{
    const auto parsed = parse_selector(selector);
    if (!parsed) {
        return fail(ErrorKind::usage,
                    fmt::format("cannot read the line \"{}\"; write a number such as 3, or a part of a line such as "
                                "3@10%..90% or 3@120..480 (mm)",
                                selector));
    }
    const int count = static_cast<int>(lines.size());
    if (parsed->id < 0 || parsed->id >= count) {
        const std::string known = count == 0   ? "no lines at this crease angle; lower it"
                                  : count == 1 ? "only line 0"
                                               : fmt::format("lines 0 to {}", count - 1);
        return fail(ErrorKind::rejected, fmt::format("no line {}: the model has {}", parsed->id, known));
    }
    const FeatureLine& line = lines[parsed->id];
    if (!parsed->range) {
        return line;
    }
    const auto [from, to] = *parsed->range;
    const double from_mm = from.percent ? from.value / 100 * line.length_mm : from.value;
    const double to_mm = to.percent ? to.value / 100 * line.length_mm : to.value;
    const double slack = 1e-9 * line.length_mm;
    if (std::min(from_mm, to_mm) < -slack || std::max(from_mm, to_mm) > line.length_mm + slack) {
        return fail(ErrorKind::rejected, fmt::format("\"{}\" leaves line {}, which is {:.6g} mm long", selector,
                                                     parsed->id, line.length_mm));
    }
    if (from_mm > to_mm && !line.closed) {
        return fail(ErrorKind::rejected,
                    fmt::format("\"{}\" runs backwards; on an open line give the smaller end first", selector));
    }
    const auto lengths = arc_lengths(model.mesh, line);
    int first = nearest_station(lengths, from_mm), last = nearest_station(lengths, to_mm);
    const int n = static_cast<int>(line.vertices.size());
    if (line.closed && first == 0 && last == n) {
        return line;
    }
    if (!line.closed && first == 0 && last == n - 1) {
        return line;
    }
    if (line.closed) {
        first %= n;
        last %= n;
    }
    if (first == last) {
        return fail(ErrorKind::rejected,
                    fmt::format("\"{}\" holds no whole edge of line {} ({} edges on {:.6g} mm); widen the range",
                                selector, parsed->id, lengths.size() - 1, line.length_mm));
    }
    const Topology topology(model.mesh.F, static_cast<int>(model.mesh.V.rows()));
    return part_of_line(model, topology, line, first, last);
}

} // namespace tapeline
