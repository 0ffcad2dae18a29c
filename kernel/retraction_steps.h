// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/retraction.h"
#include "kernel/topology.h"

#include <optional>
#include <utility>
#include <vector>

namespace tapeline {

/// The parts that both ways of retracting share; not for use outside retraction*.cpp.
class RetractionTask {
public:
    /// `displacements` has one entry per entry of side.line.
    RetractionTask(const SideMesh& side, const std::vector<Vec3>& displacements);

    const Mesh& inner() const { return inner_; }
    const Topology& topology() const { return topology_; }
    Vec3 position(int v) const { return inner_.V.row(v); }
    const std::vector<int>& line() const { return side_.line; }
    bool closed() const { return closed_; }

    /// Entry of vertex v in the line, -1 off the line.
    int line_entry(int v) const { return entry_[v]; }
    /// True where the retraction decides freely: neither on the line, nor fixed, nor on a free border.
    bool free(int v) const { return free_[v]; }

    /// Per line entry the part of its displacement that goes into the side [mm]: with m the mean unit conormal into the
    /// side, u itself where u·m ≥ 0; elsewhere u without its conormal part, faded out smoothly over a tenth of the
    /// largest displacement (method.md A5). Continuous in u.
    const std::vector<Vec3>& moves() const { return moves_; }

    /// Positions with line, guided vertices and free borders at their final places and all else at rest: line vertices
    /// on the surface point closest to rest + move; guided ones on their targets; borders that are neither line nor fixed keep their shape, their vertices
    /// slide along them, in proportion to arc length from the line's end (or not, where the line does not end there).
    const Positions& start() const { return start_; }

    /// The place on the surface for vertex v moved by u: the surface point closest to P + u. On folded sides that point
    /// may lie on another sheet; so it is compared with the end of the straightest path from P along u, and where the
    /// two are apart, the point found by walking downhill from the path's end is taken, unless that one misses P + u
    /// by more than a quarter of |u| beyond the closest point's distance.
    Vec3 place(int v, const Vec3& u) const;

private:
    void find_moves(const std::vector<Vec3>& displacements);
    void place_line();
    void place_guided(const std::vector<Vec3>& displacements);
    void slide_borders();
    std::vector<int> border_chain(int from, int next, std::vector<char>& seen) const;
    void slide_chain(const std::vector<int>& chain);

    const SideMesh& side_;
    Mesh inner_;
    Topology topology_;
    ClosestPoint surface_;
    bool closed_ = false;
    std::vector<int> entry_;
    std::vector<char> free_;
    std::vector<Vec3> moves_;
    Positions start_;
};

/// What became of the side's triangles.
struct FoldReport {
    double min_area_ratio = 1;
    std::vector<int> flipped; ///< triangles whose normal turned by more than 90°
};

FoldReport find_folds(const Mesh& inner, const Positions& V);

/// Slid positions by the orthotropic harmonic extension, repaired where triangles flip.
Positions retract_harmonic(const RetractionTask& task, const Material& material);

/// Slid positions by plane sections; `crossings` counts neighbouring section curves that cross.
Positions retract_planes(const RetractionTask& task, int& crossings);

} // namespace tapeline
