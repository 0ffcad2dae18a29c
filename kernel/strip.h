// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <utility>
#include <vector>

namespace tapeline {

/// A narrow bend along one side of a line, as a fillet makes it: the surface first turns through it and only then goes
/// on as the wide, smooth side.
struct Strip {
    double width_mm = 0;   ///< of the bend, along the surface, its median along the line; 0 = there is none
    double carried_mm = 0; ///< what is carried along with the line: the bend and a quarter of its width beyond it
    double turning = 0;    ///< angle that the section turns through in the bend [deg]
    double radius_mm = 0;  ///< mean radius of the bend; 0 where it does not turn
    std::vector<double> widths = {}; ///< of the bend per entry of the line [mm]; empty where it is as wide all along

    /// What is carried per entry of a line [mm], times `share`: as much wider than the bend there as `carried_mm` is.
    std::vector<double> carried(size_t entries, double share = 1) const;
    bool found() const { return carried_mm > 0; }
};

/// A bend beside the line that was carried along.
struct StripReport {
    Strip bend;                ///< carried_mm = 0: none
    double pivot_max = 0;      ///< where it rests on the old surface: largest turn of the section about the line [deg]
    double lift_max_mm = 0;    ///< and how far its outer edge then still lies off it
    std::vector<int> vertices; ///< of the strip without the line, on rest's vertices
};

struct StripOptions {
    double least_turning = 6; ///< a bend turns through at least this [deg]
    double contrast = 4;      ///< and is this many times as curved as the side beyond it
    double narrowness = 4;    ///< and the side is this many times as wide
};

/// Looks for a bend beside a line. `side` is the surface on one side of the line, with the line (vertex chain in either
/// direction) on its border. Straight paths lead from the line's edges across the side; along each the angle of the
/// surface's normal about the line, τ(d), is read off at the same distances d. Of the paths' median profile,
///
///     τ(d) = τ0 + κ d + (κ' - κ) max(0, d - w)     for d ≤ narrowness · w
///
/// is fitted for every w; the w is taken that explains most of what a straight fit leaves. It is a bend when κ w and
/// κ / κ' reach the options' values, when the section turns right from the line on (a tenth of the angle within 0.3 of the
/// way to nine tenths; a tight place farther away is no strip *beside* the line), and when most paths turn through at least half of it.
/// The width along the line is that of the same fit to the paths of each place (kernel/strip_fit).
/// None is found where the mesh has fewer than about two triangles across the bend.
Strip find_strip(const Mesh& side, const std::vector<int>& line, bool closed, const StripOptions& options = {});

/// The surface's parts left and right of a line, as `find_strip` takes them: triangles on the model's vertices.
std::pair<Mesh, Mesh> meshes_beside(const Mesh& mesh, const std::vector<int>& line, bool closed);

/// The side's vertices within a width of the line along the surface, ascending, without the line's own; `widths_mm` holds
/// one per entry of the line and goes straight in between.
std::vector<int> strip_vertices(const Mesh& side, const std::vector<int>& line, bool closed,
                                const std::vector<double>& widths_mm);

/// Of a moved line, the vertices of the bends beside it that went along: found on both shapes with about the same width
/// and angle (within a tenth), as is told where no record of the move says so.
std::vector<int> kept_strips(const Mesh& rest, const Positions& moved, const std::vector<int>& line, bool closed);

/// Per vertex of the line the point of the side at its distance straight across from it (nearer where the side ends).
std::vector<Vec3> points_across(const Mesh& side, const std::vector<int>& line, bool closed,
                                const std::vector<double>& distances_mm);

} // namespace tapeline
