// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json_fields.h"
#include "io/target_formats.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapeline {

namespace {

/// Copies a value into `target`, or keeps the first error met.
template <class T>
void take(const Result<T>& value, T& target, Result<void>& status)
{
    if (value) {
        target = *value;
    } else if (status) {
        status = tl::unexpected(value.error());
    }
}

std::string list(const std::vector<double>& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

Result<ControlPointEdit> read_edit(const JsonField& field)
{
    if (const auto checked = check_object(field, {"index", "to", "by"}); !checked) {
        return tl::unexpected(checked.error());
    }
    const JsonField to = field.member("to"), by = field.member("by");
    if (to.missing() == by.missing()) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{}: \"{}\" needs either \"to\" or \"by\", one of them", field.file, field.key));
    }
    ControlPointEdit edit;
    Result<void> status;
    take(read_integer(field.member("index")), edit.index, status);
    take(read_point(to.missing() ? by : to), edit.value, status);
    edit.relative = to.missing();
    if (!status) {
        return tl::unexpected(status.error());
    }
    return edit;
}

} // namespace

Result<TargetLine> target_from_json(const std::string& file, std::string_view content)
{
    const auto parsed = parse_json(file, content);
    if (!parsed) {
        return tl::unexpected(parsed.error());
    }
    const JsonField root{&*parsed, file, ""};
    if (const auto checked = check_object(root, {"degree", "knots", "weights", "control_points", "closed"}); !checked) {
        return tl::unexpected(checked.error());
    }
    BSplineData data;
    Result<void> status;
    take(read_integer(root.member("degree")), data.degree, status);
    take(read_numbers(root.member("knots")), data.knots, status);
    take(read_points(root.member("control_points")), data.control_points, status);
    if (!root.member("weights").missing()) {
        take(read_numbers(root.member("weights")), data.weights, status);
    }
    if (!root.member("closed").missing()) {
        take(read_flag(root.member("closed")), data.closed, status);
    }
    if (!status) {
        return tl::unexpected(status.error());
    }
    auto line = TargetLine::from_data(data);
    if (line && root.member("closed").missing()) {
        // Without the mark, a line whose ends meet is closed.
        const Vec3 gap = line->point(line->first_parameter()) - line->point(line->last_parameter());
        if (gap.norm() <= 1e-10 * line->length()) {
            data.closed = true;
            line = TargetLine::from_data(data);
        }
    }
    return line.map_error([&](Error error) {
        error.message = fmt::format("{}: {}", file, error.message);
        return error;
    });
}

std::string target_to_json(const TargetLine& line)
{
    const BSplineData data = line.data();
    std::string text = fmt::format("{{\n  \"degree\": {},\n  \"closed\": {},\n  \"knots\": {},\n", data.degree,
                                   data.closed, list(data.knots));
    if (!data.weights.empty()) {
        text += fmt::format("  \"weights\": {},\n", list(data.weights));
    }
    text += "  \"control_points\": [";
    for (size_t i = 0; i < data.control_points.size(); ++i) {
        const Vec3& p = data.control_points[i];
        text += fmt::format("{}\n    [{}, {}, {}]", i == 0 ? "" : ",", p.x(), p.y(), p.z());
    }
    return text + "\n  ]\n}\n";
}

Result<std::vector<ControlPointEdit>> edits_from_json(const std::string& file, std::string_view content)
{
    const auto parsed = parse_json(file, content);
    if (!parsed) {
        return tl::unexpected(parsed.error());
    }
    const JsonField root{&*parsed, file, ""};
    if (const auto checked = check_object(root, {"edits"}); !checked) {
        return tl::unexpected(checked.error());
    }
    const JsonField all = root.member("edits");
    if (all.missing() || !all.value->is_array()) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{}: \"edits\" must be a list of {{\"index\", \"to\" or \"by\"}} objects", file));
    }
    std::vector<ControlPointEdit> edits;
    for (size_t i = 0; i < all.value->size(); ++i) {
        const auto edit = read_edit(all.element(i));
        if (!edit) {
            return tl::unexpected(edit.error());
        }
        edits.push_back(*edit);
    }
    return edits;
}

} // namespace tapeline
