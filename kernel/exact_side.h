// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/exact_ground.h"
#include "kernel/split.h"

#include <optional>
#include <utility>
#include <vector>

namespace tapeline {

/// What laying a side on its exact CAD surface did.
struct ExactPlacement {
    int placed = 0;       ///< vertices that lie on the exact surface now
    int left = 0;         ///< vertices that stayed where they were: no place was found, or triangles would fold
    double before_mm = 0; ///< largest distance from their places before
};

/// One side of a cut region and the exact CAD faces and edges that it is made of, on which a retraction that slides
/// over triangles leaves its vertices only to within the tessellation. Vertices of other feature lines and of open
/// borders belong to the CAD edges there (where they lie on one), all others to the faces.
class ExactSide {
public:
    /// `model`: the extended model that the side was cut from; both must outlive this. `on_rails`: vertices of feature
    /// lines slide along them; otherwise they count as lying on faces.
    ExactSide(const Model& model, const SideMesh& side, bool on_rails);

    /// The faces alone.
    const ExactGround& ground() const { return ground_; }

    /// The place on the exact surface for vertex v of the side (local) that lies at p.
    std::optional<Vec3> place(int v, const Vec3& p) const;

    /// Moves the listed vertices (local) of the side to their exact places, by `share` of the way (1 = onto it). Where
    /// that folds triangles, as kernel/remesh_surface.h says, their vertices stay.
    ExactPlacement lay(const std::vector<int>& vertices, double share, Positions& V) const;

    /// Largest distance of the listed vertices at V from their exact places [mm].
    double distance(const std::vector<int>& vertices, const Positions& V) const;

    /// The side's vertices that may be laid on the surface: neither fixed nor on the line, and not at rest in V.
    std::vector<int> moved_vertices(const Positions& V) const;

private:
    std::vector<std::optional<Vec3>> places(const std::vector<int>& vertices, const Positions& V) const;

    const Model& model_;
    const SideMesh& side_;
    ExactGround ground_;
    std::vector<std::pair<VertexPair, int>> edges_; ///< local feature and border edges with their CAD edges
    std::vector<char> on_edge_, still_;             ///< per local vertex
};

} // namespace tapeline
