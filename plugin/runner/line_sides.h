// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/correspondence.h"
#include "kernel/mesh.h"

#include <utility>
#include <vector>

namespace tapeline {

/// The listed triangles left and right of a line (ascending), parted as a move parts them: by the line prolonged to the
/// rim of those triangles (kernel/extension.h). A triangle that the prolongation crosses counts where more of it lies.
/// Where the line cannot be prolonged, both sides grow from the line alone and meet half-way.
std::pair<std::vector<int>, std::vector<int>> sides_by_extension(const Model& model, const std::vector<int>& faces,
                                                                 const Correspondence& line);

} // namespace tapeline
