// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/job_file.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/option_value.h"

#include <cmath>

namespace tapeline {

namespace {

using nlohmann::ordered_json;

struct TypeWriter {
    const Option& option;

    ordered_json number(const char* type) const
    {
        ordered_json schema = {{"type", type}};
        const auto put = [&](const char* key, double value) {
            if (std::isfinite(value)) {
                schema[key] =
                    value == std::floor(value) ? ordered_json(static_cast<long long>(value)) : ordered_json(value);
            }
        };
        put("minimum", option.min);
        put("maximum", option.max);
        return schema;
    }
    ordered_json list(ordered_json items) const
    {
        ordered_json schema = {{"type", "array"}, {"items", std::move(items)}};
        if (option.count > 0) {
            schema["minItems"] = schema["maxItems"] = option.count;
            return schema;
        }
        // A list of one may be written without brackets.
        return {{"anyOf", ordered_json::array({schema, schema["items"]})}};
    }
    static ordered_json text() { return {{"type", "string"}}; }
    static ordered_json selector()
    {
        return {{"anyOf", ordered_json::array({text(), {{"type", "integer"}, {"minimum", 0}}})}};
    }

    ordered_json operator()(const bool*) const { return {{"type", "boolean"}}; }
    ordered_json operator()(const int*) const { return number("integer"); }
    ordered_json operator()(const double*) const { return number("number"); }
    ordered_json operator()(const std::optional<double>*) const { return number("number"); }
    ordered_json choice() const
    {
        ordered_json schema = text();
        if (!option.choices.empty()) {
            schema["enum"] = option.choices;
        }
        return schema;
    }

    ordered_json operator()(const std::string*) const { return choice(); }
    ordered_json operator()(const std::vector<std::string>*) const { return list(choice()); }
    ordered_json operator()(const std::filesystem::path*) const { return text(); }
    ordered_json operator()(const LineSelector*) const { return selector(); }
    ordered_json operator()(const std::vector<int>*) const { return list(number("integer")); }
    ordered_json operator()(const std::vector<double>*) const { return list(number("number")); }
    ordered_json operator()(const std::vector<std::filesystem::path>*) const { return list(text()); }
    ordered_json operator()(const std::vector<LineSelector>*) const { return list(selector()); }
};

ordered_json option_schema(const Option& option)
{
    Job job;
    ordered_json schema = std::visit(TypeWriter{option}, option.slot(job));
    schema["description"] = help_text(option);
    const nlohmann::json value = option_default(option);
    const bool empty = value.is_null() || (value.is_string() && value.get<std::string>().empty());
    if (!empty) {
        schema["default"] = value;
    }
    return schema;
}

ordered_json object_schema(std::string_view section)
{
    ordered_json properties = ordered_json::object();
    for (const Option& option : option_table()) {
        if (option.section == section) {
            properties[std::string(option.name)] = option_schema(option);
        }
    }
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", properties}};
}

} // namespace

std::string job_schema()
{
    ordered_json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                           {"title", "Tapeline job"},
                           {"description", "One move of a feature line, from model file to result."}};
    schema.update(object_schema(""));
    ordered_json& properties = schema["properties"];
    properties["$schema"] = TypeWriter::text();
    for (const OptionSection& section : option_sections()) {
        ordered_json part = object_schema(section.name);
        part["description"] = section.help;
        properties[std::string(section.name)] = part;
    }
    schema["required"] = {"input", "lines", "outputs"};
    return json_text(schema);
}

} // namespace tapeline
