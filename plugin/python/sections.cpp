// SPDX-License-Identifier: GPL-3.0-or-later
// Sections across a moved line, as numbers to draw.
#include "kernel/sections.h"

#include "plugin/python/call.h"
#include "plugin/python/objects.h"
#include "plugin/runner/stats.h"

#include <fmt/format.h>

namespace tapeline::python {

namespace {

py::dict comb(const SectionShape& shape)
{
    py::dict dict;
    dict["points"] = copied(shape.points);
    dict["curvature"] = copied(shape.curvature);
    dict["inflections"] = copied(shape.inflection_points);
    return dict;
}

} // namespace

py::list sections_of(const ResultObject& result, int stations)
{
    constexpr int most = 1000;
    if (stations < 1 || stations > most) {
        raise({ErrorKind::usage, fmt::format("stations must be 1 to {}, not {}", most, stations)});
    }
    const std::vector<SectionShapes> shapes = without_gil([&]() -> Result<std::vector<SectionShapes>> {
        QualityInput input = quality_input(result.outcome->move, result.outcome->preparation.target->line);
        input.stations = stations;
        std::vector<SectionShapes> list;
        for (const Section& section : cross_sections(input)) {
            list.push_back(section_shapes(section));
        }
        return list;
    });
    py::list list;
    for (const SectionShapes& shape : shapes) {
        py::dict dict;
        dict["compressed_before"] = comb(shape.compressed_before);
        dict["compressed_after"] = comb(shape.compressed_after);
        dict["tension_before"] = comb(shape.tension_before);
        dict["tension_after"] = comb(shape.tension_after);
        list.append(std::move(dict));
    }
    return list;
}

} // namespace tapeline::python
