// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/feature_rails.h"
#include "kernel/retraction.h"
#include "kernel/retraction_ground.h"
#include "kernel/topology.h"

#include <optional>
#include <utility>
#include <vector>

namespace tapeline {

/// The parts that all ways of retracting share; not for use outside retraction*.cpp.
class RetractionTask {
public:
    /// `displacements` has one entry per entry of side.line. `on_rails`: the other feature lines in the side (`features`,
    /// ascending) and its free borders stay where they are, their vertices slide along them; otherwise the side counts
    /// as smooth all over, and the vertices of free borders that the line does not reach stay. `share` of each
    /// displacement is slid. `strip`, where there is one, is carried along.
    RetractionTask(const SideMesh& side, const std::vector<Vec3>& displacements,
                   const std::vector<VertexPair>& features, bool on_rails, double share = 1,
                   const CarriedStrip* strip = nullptr);
    RetractionTask(const RetractionTask&) = delete;
    RetractionTask& operator=(const RetractionTask&) = delete;

    const Mesh& inner() const { return inner_; }
    const Topology& topology() const { return topology_; }
    Vec3 position(int v) const { return inner_.V.row(v); }
    const Positions& normals() const { return normals_; }
    const std::vector<int>& line() const { return side_.line; }
    bool closed() const { return closed_; }

    /// Entry of vertex v in the line, -1 off the line.
    int line_entry(int v) const { return entry_[v]; }
    /// True where the retraction decides: not on the line nor in a carried strip, nor fixed, nor a corner of rails, nor on
    /// a border that slides with the line's end.
    bool free(int v) const { return free_[v]; }

    /// Per line entry the part of its displacement that goes into the side [mm]: with m the mean unit conormal into the
    /// side, u itself where u·m ≥ 0; elsewhere u without its conormal part, faded out smoothly over three tenths
    /// of the largest displacement (method.md A5). The corner at 0 is rounded, once continuously differentiable in u, within a share of the
    /// largest displacement: the least of 0.06, of how fast u·m changes along the line, and of how far out of the side the
    /// line goes where it does so most.
    const std::vector<Vec3>& moves() const { return moves_; }

    /// Positions with line, guided vertices and free borders at their final places and all else at rest: line vertices
    /// on the surface point closest to rest + move, or on the other feature line that leaves there in the move's
    /// direction (within a half of it); guided ones on their targets; the vertices of a free border on which the line ends
    /// slide along it in proportion to arc length from the line's end.
    const Positions& start() const { return start_; }

    /// Per line entry the tangent vector at its vertex along which the straightest path ends at the vertex's final place
    /// (by shooting; the move itself where no such path is found) [mm].
    const std::vector<Vec3>& arcs() const { return arcs_; }

    /// The other feature lines and free borders in the side, along which their vertices slide.
    const FeatureRails& rails() const { return rails_; }

    /// The entry whose way leads farthest over another feature line, into a part of the side that the line does not
    /// bound; -1 = none does.
    int crossed() const { return crossed_; }

    /// The place for vertex v that moves by `u` in space, or by the tangent vector `arc` along the surface: along its
    /// rail, where it is on one, else on the ground.
    Vec3 place(int v, const Vec3& u, const Vec3& arc) const
    {
        return rails_.slides(v) ? rails_.along(v, u.dot(rails_.tangent(v))) : ground_.place(v, u, arc);
    }

private:
    void find_moves(const std::vector<Vec3>& displacements, double share);
    void place_line();
    void place_strip(const CarriedStrip& strip, const std::vector<Vec3>& displacements);
    void place_guided(const std::vector<Vec3>& displacements);
    void slide_borders(bool others_slide);
    void find_arcs();
    Vec3 on_surface(size_t entry);
    void lay_rails(bool along_borders);
    std::vector<int> border_chain(int from, int next, std::vector<char>& seen) const;
    void slide_chain(const std::vector<int>& chain);

    const SideMesh& side_;
    Mesh inner_;
    Topology topology_;
    std::vector<VertexPair> walls_; ///< edges of other feature lines inside the side, ascending
    RetractionGround ground_;
    FeatureRails rails_;
    bool closed_ = false;
    int crossed_ = -1;
    double crossed_by_ = 0;
    std::vector<int> entry_;
    std::vector<char> free_;
    std::vector<Vec3> moves_, arcs_;
    std::vector<double> shares_; ///< per line entry the share of its displacement that is slid
    Positions normals_, start_;
};

/// What became of the side's triangles.
struct FoldReport {
    double min_area_ratio = 1;
    int smallest = -1;        ///< the triangle with that ratio
    std::vector<int> flipped; ///< triangles whose normal turned by more than 90°
};

FoldReport find_folds(const Mesh& inner, const Positions& V);

/// Per vertex a frame (columns: tangent, tangent, normal) that is carried over the surface from the line as parallel as
/// the surface allows: components in these frames can be interpolated where the side turns, as if it were unrolled. The
/// first axis minimises the Dirichlet energy of a tangent field under the connection of the triangles (corner tangent
/// planes turned into the triangle's by the smallest rotation; as in the vector heat method, Sharp et al. 2019), given
/// as the mean move's tangential part at the line. All frames are equal on a flat side.
std::vector<Eigen::Matrix3d> parallel_frames(const RetractionTask& task);

/// Slid positions by the orthotropic harmonic extension, repaired where triangles flip.
Positions retract_harmonic(const RetractionTask& task, const Material& material);

/// Slid positions by plane sections; `crossings` counts neighbouring section curves that cross.
Positions retract_planes(const RetractionTask& task, int& crossings);

/// Slid positions by one vertex of the line after the other; `radius` 0 reaches up to the nearest fixed vertex.
Positions retract_sequentially(const RetractionTask& task, double radius);

} // namespace tapeline
