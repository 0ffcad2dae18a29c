// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/move_record.h"

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace tapeline {

Result<MoveRecord> move_record_of(const nlohmann::json& stats, const std::string& source)
{
    try {
        MoveRecord record;
        record.line = stats.at("line").at("vertices").get<std::vector<int>>();
        record.closed = stats.at("line").at("closed").get<bool>();
        const auto& side = stats.at("placement").at("compressed_side");
        record.compressed_side = side.is_null() ? "none" : side.get<std::string>();
        record.extended_line = stats.at("extension").at("line").get<std::vector<int>>();
        for (const auto& entry : stats.at("extension").at("appended")) {
            record.appended.push_back({entry.at(0).get<int>(), entry.at(1).get<int>(), entry.at(2).get<double>()});
        }
        for (const char* which : {"left", "right"}) {
            if (stats.contains("strip") && !stats.at("strip").at(which).is_null()) {
                const auto vertices = stats.at("strip").at(which).at("vertices").get<std::vector<int>>();
                record.carried.insert(record.carried.end(), vertices.begin(), vertices.end());
            }
        }
        if (std::ranges::any_of(record.line, [](int v) { return v < 0; }) || record.line.empty()) {
            return fail(ErrorKind::unreadable, fmt::format("{}: line.vertices is not a list of indices", source));
        }
        return record;
    } catch (const nlohmann::json::exception&) {
        return fail(ErrorKind::unreadable,
                    fmt::format("{}: not a statistics file; give what tapeline move --stats wrote", source));
    }
}

Result<MoveRecord> read_move_record(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return fail(ErrorKind::unreadable,
                    fmt::format("cannot read the statistics {}: there is no such file", path.string()));
    }
    return move_record_of(nlohmann::json::parse(file, nullptr, false), path.string());
}

} // namespace tapeline
