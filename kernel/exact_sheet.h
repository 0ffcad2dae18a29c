// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/curve.h"
#include "kernel/mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

namespace tapeline {

/// Closest points of a part of a model: of its triangles, and of the exact faces that these stand for.
struct SheetFoot {
    MeshFoot triangle;                ///< face = -1: there are no triangles
    std::optional<SurfaceFoot> exact; ///< its normal is the sum of the normals (not unit) where several CAD faces meet;
                                      ///< empty where the closest triangle has no CAD face or the search is in doubt
};

/// A part of a model as a sheet of exact CAD faces, and how far any point is from it: from nearby, where the faces and
/// their triangles differ, and from afar, where a face has several places that are closest to what is around them. Each
/// CAD face within reach is searched from its own closest triangle. A place counts when it is behind the part's
/// triangles of that face (within a quarter of an edge), not where the face goes on beyond the part; and the closest one
/// stands when it is no farther than the exact place behind the closest triangle, since a search that ended in another
/// valley is. Safe from several threads.
class ExactSheet {
public:
    /// The part of the model made of `faces`, which has CAD faces. The model must outlive the sheet.
    ExactSheet(const Model& model, std::span<const int> faces);

    SheetFoot foot(const Vec3& p) const;

private:
    /// The part's triangles of one CAD face.
    struct Piece {
        int cad_face; ///< -1: of none
        ClosestPoint triangles;
        Eigen::AlignedBox3d box;
        double depth; ///< the exact face stays this close to the triangles [mm]
    };
    /// A place on a piece's exact face.
    struct Place {
        SurfaceFoot foot;
        double distance; ///< to the point asked for [mm]
    };
    size_t nearest_piece(const Vec3& p, MeshFoot& near) const;
    std::optional<Place> place_on(const Piece& piece, const Vec3& p) const;
    double depth_at(int face) const;

    const Model& model_;
    std::vector<Piece> pieces_; ///< by number of the CAD face
};

} // namespace tapeline
