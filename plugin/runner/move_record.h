// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/extension.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tapeline {

/// What a check takes from a move's statistics file.
struct MoveRecord {
    std::vector<int> line; ///< vertices of the moved line in the result
    bool closed = false;
    std::string compressed_side;    ///< "left", "right", "none", or empty without statistics
    std::vector<int> extended_line; ///< the line with its prolongation to the rim
    std::vector<AppendedVertex> appended;
    std::vector<int> carried; ///< vertices of strips that went along with the line
};

/// Reads the statistics that `tapeline move --stats` wrote. Fails (unreadable) when the file is not one.
Result<MoveRecord> read_move_record(const std::filesystem::path& path);
/// The same from statistics in memory; `source` is what messages call them.
Result<MoveRecord> move_record_of(const nlohmann::json& stats, const std::string& source);

} // namespace tapeline
