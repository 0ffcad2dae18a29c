// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/move.h"

#include <vector>

namespace tapeline {

/// A feature line of the model before remeshing, by its number and as a polyline.
struct NamedLine {
    int id = -1;
    std::vector<Vec3> points;
};

/// What a move does with another feature line in its region.
enum class InnerLineRole {
    held,   ///< its vertices are fixed
    slides, ///< on the side that makes room: it stays, its vertices slide along it
    follows ///< it deforms with the surface
};

/// The part of one other feature line that lies in the region and has one role.
struct InnerLine {
    int id = -1; ///< of the named line nearest to it; -1 = none is near
    InnerLineRole role = InnerLineRole::follows;
    double length_mm = 0;
    double crease_before = 0;     ///< length-weighted mean crease angle [deg]
    double crease_after = 0;      ///< [deg]
    double crease_change_max = 0; ///< largest change of an edge's crease angle [deg]
    double off_line_mm = 0;       ///< largest distance of a moved vertex from the line before the move
};

/// Measures the other feature lines and the lines to be kept inside the region of a finished move, edges between two
/// region triangles only; ascending by id, then by role. Lines are told apart by the nearest of `names`, as remeshing
/// numbers them anew.
std::vector<InnerLine> measure_inner_lines(const MoveResult& move, const std::vector<NamedLine>& names);

} // namespace tapeline
