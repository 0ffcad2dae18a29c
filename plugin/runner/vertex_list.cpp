// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/vertex_list.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace tapeline {

namespace {

using nlohmann::json;

Result<std::vector<int>> from_json(const std::string& text, const std::string& name)
{
    const json document = json::parse(text, nullptr, false);
    const json* list = &document;
    if (document.is_object() && document.contains("line") && document["line"].is_object()) {
        list = &document["line"];
    }
    if (list->is_object() && list->contains("vertices")) {
        list = &(*list)["vertices"];
    }
    std::vector<int> vertices;
    if (list->is_array()) {
        for (const json& entry : *list) {
            if (!entry.is_number_integer() || entry < 0 || entry > std::numeric_limits<int>::max()) {
                break;
            }
            vertices.push_back(entry.get<int>());
        }
    }
    if (!list->is_array() || vertices.empty() || vertices.size() != list->size()) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{}: no list of vertex indices found; give a JSON array of whole numbers", name));
    }
    return vertices;
}

Result<std::vector<int>> from_text(const std::string& text, const std::string& name)
{
    std::vector<int> vertices;
    const char* at = text.data();
    const char* end = at + text.size();
    int line = 1;
    while (at != end) {
        if (std::isspace(static_cast<unsigned char>(*at)) || *at == ',' || *at == ';') {
            line += *at == '\n' ? 1 : 0;
            ++at;
            continue;
        }
        int value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || value < 0) {
            return fail(ErrorKind::unreadable,
                        fmt::format("{}, line {}: expected a vertex index, a whole number from 0", name, line));
        }
        vertices.push_back(value);
        at = next;
    }
    if (vertices.empty()) {
        return fail(ErrorKind::unreadable, fmt::format("{}: holds no vertex index", name));
    }
    return vertices;
}

} // namespace

Result<std::vector<int>> read_vertex_list(const std::filesystem::path& path)
{
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    if (!file || !std::filesystem::is_regular_file(path, error)) {
        return fail(ErrorKind::unreadable,
                    fmt::format("cannot read the vertex list {}: there is no such file", path.string()));
    }
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto first = std::ranges::find_if(text, [](unsigned char c) { return !std::isspace(c); });
    const bool is_json = first != text.end() && (*first == '[' || *first == '{');
    return is_json ? from_json(text, path.string()) : from_text(text, path.string());
}

std::string vertex_list_text(const FeatureLine& line)
{
    std::string text;
    for (const int v : line.vertices) {
        text += fmt::format("{}\n", v);
    }
    return line.closed && !line.vertices.empty() ? text + fmt::format("{}\n", line.vertices.front()) : text;
}

Result<void> check_line_chosen(const LineSelector& selector)
{
    if (selector.empty()) {
        return fail(ErrorKind::usage, "no feature line is chosen: give --line ID (the job key lines.line); tapeline "
                                      "lines shows the model's lines");
    }
    return {};
}

Result<FeatureLine> choose_line(const Model& model, const std::vector<FeatureLine>& lines, const LineSelector& selector)
{
    if (const auto chosen = check_line_chosen(selector); !chosen) {
        return tl::unexpected(chosen.error());
    }
    if (selector.names_line()) {
        return select_line(model, lines, selector.text);
    }
    return read_vertex_list(selector.text).and_then([&](std::vector<int> vertices) -> Result<FeatureLine> {
        const auto count = model.mesh.V.rows();
        for (const int v : vertices) {
            if (v >= count) {
                return fail(ErrorKind::rejected, fmt::format("{}: vertex {} does not exist; the model has {} vertices",
                                                             selector.text, v, count));
            }
        }
        return line_through(model, std::move(vertices));
    });
}

FeatureLineOptions line_options(const LineSettings& settings)
{
    FeatureLineOptions options;
    options.crease_angle = settings.crease_angle;
    options.crease_angle_low = std::min(settings.crease_angle_low, settings.crease_angle);
    options.max_turn = settings.max_turn;
    options.min_length_mm = settings.min_length;
    return options;
}

} // namespace tapeline
