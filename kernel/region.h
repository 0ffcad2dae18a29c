// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/face_patch.h"
#include "kernel/feature_lines.h"
#include "kernel/mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace tapeline {

/// The region of interest S (the paper's Section 3.1): a set of triangles, and which of its vertices do not move.
struct Region {
    std::vector<int> faces;             ///< triangle indices, ascending
    std::vector<int> vertices;          ///< all vertices of those triangles, ascending
    std::vector<int> fixed_rim;         ///< the immobile border F, ascending
    std::vector<int> inner_fixed;       ///< further fixed vertices inside (inner constraints), ascending
    std::vector<VertexPair> kept_edges; ///< edges inside that must stay lines, however blunt, ascending
    double distance_mm = 0;             ///< half-width of the distance band, 0 when the region was not made by distance
    std::vector<std::string> warnings;
};

struct RegionOptions {
    double distance_mm = 0;                       ///< geodesic half-width of the band around L0 and Lt; 0 = automatic
    std::vector<int> cad_faces;                   ///< instead of a band: these CAD faces
    std::vector<std::vector<int>> bounding_lines; ///< instead of a band: what these vertex chains and borders enclose
    std::optional<Eigen::AlignedBox3d> box; ///< instead of a band: triangles whose corners all lie in this box [mm]
    bool free_borders = false;              ///< open borders of the model inside the region may move
    std::vector<int> fixed_vertices;        ///< inner constraints: these vertices stay
    std::vector<int> fixed_cad_faces;       ///< inner constraints: all vertices of these CAD faces stay
    /// Vertex chains whose vertices inside the region stay, but for those that the moving line shares; their edges are kept,
    /// too.
    std::vector<std::vector<int>> held_lines;
    std::vector<std::vector<int>> kept_lines; ///< vertex chains that stay lines: `Region::kept_edges`
};

/// Chooses the region around `line` for moving it to the points `targets` (one per line vertex, or empty). At most
/// one of distance_mm, cad_faces, bounding_lines, box may be given. Keeps only the edge-connected part that holds the
/// line. A band holds the triangles whose three corners are within its width (kernel/geodesic_distance.h); bands and
/// boxes are then tidied (kernel/region_shape.h). A band of automatic width ends at other feature lines that leave twice
/// the largest displacement before them; those become its rim. A line may end on the rim or on an open border, but not touch either
/// in between. A region that is not a disk around the line (or a ring around a closed one) is only warned about.
/// Rejected when the region does not hold the line's edges, the line runs on the rim or a border, the targets start
/// farther away than the width or cross the rim, or when a non-manifold edge or zero-area triangle is inside (the place is named). Usage error when the options contradict each other.
Result<Region> make_region(const Model& model, const FeatureLine& line, const std::vector<Vec3>& targets,
                           const RegionOptions& options = {});

/// Completes a region from its triangles: vertices, rim (vertices on edges shared with outside triangles, and on
/// open borders unless free_borders), inner constraints.
Region region_of_faces(const Model& model, std::vector<int> faces, bool free_borders,
                       const std::vector<int>& fixed_vertices);

} // namespace tapeline
