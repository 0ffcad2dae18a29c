// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/split.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace tapeline {

/// The closest point of the surface that a strip's outer edge is to lie on. Safe from several threads.
using StripGround = std::function<Vec3(const Vec3&)>;

struct StripTransport {
    std::vector<double> widths_mm; ///< of what is carried, along the surface from the line, per entry of side.line
    bool closed = false;           ///< the line is a loop
    bool rests = false;            ///< the outer edge is to lie on the ground where the line moves into the side
};

/// A strip of a side, carried along with its line.
struct CarriedStrip {
    std::vector<int> vertices; ///< local, ascending; neither on the line nor fixed, on a border or another feature line
    Positions places;          ///< one row each [mm]
    std::vector<int> segment;  ///< per vertex its station: between this entry of side.line and the next
    std::vector<double> share; ///< the way from the one to the other, in [0, 1]
    std::vector<double> pivots; ///< per line entry the turn about the moved line that lets the outer edge rest [deg]
    std::vector<Vec3> lifts;    ///< per line entry what then still keeps the outer edge off the ground [mm]
    bool settled = false;       ///< the places are those of the result, to be held

    bool has(int vertex) const { return std::ranges::binary_search(vertices, vertex); }
};

/// Carries the strip beside a line from L0 to Lt (`targets`, one finite point per entry of side.line): with p_i → p'_i
/// the line's entries, T_i and T'_i the tangents of the two polylines there,
///
///     x' = p' + R (x - p),    R_i = rotation(T'_i, α_i) · (smallest rotation T_i → T'_i),
///
/// at the station p of x: the place of the line where x - p is normal to the tangent. p, p' and R between entries are
/// interpolated, so a section normal to the line moves as a rigid piece. α_i turns the section about the moved line until
/// its outer point, the side's point at the strip's width, lies on the ground (30° at most), where the strip rests there;
/// what the pivot cannot reach is in `lifts`. Where an entry and its neighbours stay, the strip stays to the bit.
CarriedStrip carry_strip(const SideMesh& side, const StripTransport& transport, const std::vector<Vec3>& targets,
                         const StripGround& ground);

/// The value at vertex k of the strip of something known per line entry.
template <class T>
T at_station(const CarriedStrip& strip, size_t k, const std::vector<T>& per_entry)
{
    const T& a = per_entry[strip.segment[k]];
    const T& b = per_entry[(strip.segment[k] + 1) % per_entry.size()];
    return a + strip.share[k] * (b - a);
}

} // namespace tapeline
