// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/topology.h"

#include <string>
#include <string_view>
#include <vector>

namespace tapeline {

/// A chain of mesh edges along a crease of the model (the paper's L0, Section 3.3).
struct FeatureLine {
    int id = -1;               ///< number among the model's lines, longest first, from 0; -1 = not from the list
    std::vector<int> vertices; ///< in order; a closed line does not repeat its first vertex
    bool closed = false;
    double length_mm = 0;
    double crease_angle_mean = 0; ///< length-weighted [deg], 0 = flat
    double crease_angle_min = 0;  ///< [deg]
    double crease_angle_max = 0;  ///< [deg]
    std::vector<int> cad_edges;   ///< CAD edges along the line, ascending, without repeats; empty for meshes
    std::vector<int> before; ///< where this is a part of a longer line: that line's vertices before it, nearest first
    std::vector<int> after;  ///< the same behind it; both empty for a whole line
};

struct FeatureLineOptions {
    double crease_angle = 10;    ///< an edge at least this sharp starts a line [deg]
    double crease_angle_low = 5; ///< a started line goes on along edges at least this sharp [deg]
    double max_turn = 60;        ///< a line is cut where it turns by more than this between two edges [deg]
    double min_length_mm = 0;    ///< shorter lines are dropped; 0 = only by min_edges
    int min_edges = 3;           ///< lines with fewer edges are dropped, unless they follow a whole CAD edge
};

/// Signed-free crease angle between the two triangles of edge e [deg], 0 = flat; 0 on borders.
double crease_angle(const Mesh& mesh, const Topology& topology, int e);

/// Finds the model's feature lines (two-threshold detection on the crease angle, chaining; method.md H1), longest
/// first; equal lengths are ordered by their smallest vertex. Borders are not feature lines. What counts as a crease
/// beside the bare angle (tessellated curvature does not, smooth CAD edges do not) is told in kernel/crease_edges.h, how
/// edges are chained in kernel/line_chaining.h. An open line starts at its end of smaller vertex index, a closed one at
/// its smallest vertex and goes on to the smaller of that vertex's two neighbours.
std::vector<FeatureLine> find_feature_lines(const Model& model, const FeatureLineOptions& options = {});

/// Measures a chain of vertices as a feature line. Rejected when fewer than two vertices are given, when neighbours
/// in the list are not joined by a mesh edge, or when a vertex repeats. A list whose last vertex repeats the first
/// is closed.
Result<FeatureLine> line_through(const Model& model, std::vector<int> vertices);

/// Picks a line by "ID" or "ID@FROM..TO" (arc length from the line's first vertex in mm, or with % of its length; each
/// end snaps to the nearest vertex). On a closed line FROM may be larger than TO: the part then runs over the start.
/// The part keeps the line's id and remembers the rest of it in `before` and `after`. Usage error when the selector
/// cannot be read; rejected when there is no such line, the range leaves it, or less than one edge remains.
Result<FeatureLine> select_line(const Model& model, const std::vector<FeatureLine>& lines, std::string_view selector);

/// The part of `line` from its vertex number `first` to number `last` (positions in line.vertices, first ≠ last; on a
/// closed line last < first runs over the start), measured anew, with `before` and `after` filled.
FeatureLine part_of_line(const Model& model, const Topology& topology, const FeatureLine& line, int first, int last);

/// Length of the polyline from line.vertices[0] to each of its vertices [mm]; a closed line has one entry more, its
/// whole length.
std::vector<double> arc_lengths(const Mesh& mesh, const FeatureLine& line);

} // namespace tapeline
