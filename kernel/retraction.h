// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/orthotropic.h"
#include "kernel/split.h"
#include "kernel/strip_transport.h"

#include <vector>

namespace tapeline {

enum class RetractionMode {
    harmonic,  ///< orthotropic harmonic displacement, slid along the surface (method.md A2; default)
    planes,    ///< linear fall-off along plane sections between L0 and the rim (the paper's Section 4.3)
    sequential ///< one line vertex after the other drags its surroundings along (Pinskiy 2010; the paper's Section 4.1)
};

struct RetractionOptions {
    RetractionMode mode = RetractionMode::harmonic;
    Material material; ///< the same material as the solver's, for `harmonic`
    /// `sequential`: radius R of the area that a sliding vertex drags along [mm]; 0 = up to the nearest fixed vertex
    double active_radius_mm = 0;
    double share = 1;                    ///< of the slide that is made, in [0, 1]
    const CarriedStrip* strip = nullptr; ///< `harmonic`: moves with the line as a piece; its outer edge makes the room
};

struct RetractionResult {
    Positions V;                  ///< slid positions of all local vertices, each on the side's original surface
    double min_area_ratio = 1;    ///< smallest triangle area after / before
    int flipped = 0;              ///< triangles whose normal turned by more than 90°
    int crossings = 0;            ///< `planes`: pairs of neighbouring section curves C_P that cross (hypothesis (H))
    Vec3 worst_at = Vec3::Zero(); ///< a rest place of a flipped triangle, or of the one with the smallest ratio [mm]
};

/// What the retractions of a move did together.
struct RetractionReport {
    bool applied = false;
    RetractionMode mode = RetractionMode::harmonic;
    double min_area_ratio = 1;
    int flipped = 0;
    int crossings = 0;
};

/// Slides the compressed side's vertices along its own surface so that its material makes room for the line
/// (Sections 4.2, 4.3). `displacements` has one entry per entry of side.line: where that vertex should go, relative to
/// its rest position [mm].
///
/// All modes. Fixed vertices do not move, nor does any vertex whose displacement comes out as zero, to the bit. Line
/// vertices end on the side's surface point closest to rest + displacement (method.md A3), so L'0 = Lt where Lt lies
/// on the surface. Entries that point out of the side slide nothing (method.md A5): where u·m < 0, m the mean unit
/// conormal into the side, only u's part across m is kept, faded to zero over a tenth of the largest |u|. Guided
/// vertices go to their own targets, in the proportion in which the nearer end of the line follows its displacement.
/// Free borders keep their shape; from where the line ends on one, its vertices slide along it in proportion to arc
/// length.
///
/// Other feature lines (side.features), `harmonic` only: they stay, and so do free borders that the line does not reach,
/// as those of a hole. Their vertices slide along them in the same harmonic solve, corners and junctions stay, and all
/// other vertices stay in their own smooth part of the side. A feature line that leaves L0 in the displacement's
/// direction takes the vertex they share along. Where the target crosses another line, lines under 30° are dragged along
/// like plain surface; crossing a sharper one, or one of side.kept, is rejected.
///
/// A carried strip, `harmonic` only, goes where it is carried, less what still lifts its outer edge off the ground, and so
/// do the line's vertices; the side beyond is slid from its outer edge on.
///
/// `harmonic`: the displacement is the orthotropic harmonic extension of those values (zero on the rim), in components
/// of frames that are carried over the side in parallel, so that it follows a side that bends round (on a flat side:
/// the plain components). Each vertex goes to the surface point closest to P + u, or along the straightest path where
/// the surface turns away from P + u.
/// Beyond method.md A2, up to three further rounds divide each triangle's stiffness by what compression left of it, so
/// that compression is shared more evenly (crease panel, 100 mm: smallest altitude on the line 0.66 instead of 0.60).
/// If triangles flip, all is tried again in fixed components, with the square root of the stiffness ratio and isotropic, and at last the
/// displacement is averaged around the folds; the attempt with fewest flips, then least compression, is returned.
/// `flipped` > 0 then means: the slide is too long for the side's width.
///
/// `planes`: C_P is the section of the side with the plane through P spanned by the area-weighted vertex normal and
/// the mean displacement. It ends on two borders, at distances along the curve; u_P is linear between the borders'
/// displacements, which is the paper's lambda u_0 when they are L0 and the rim, zero between rim and rim, and defined
/// between L0 and L0. Where C_P closes or does not exist, edge-graph distances to the line and to the rim stand in.
/// Vertices then `slide`. No repair of flips: as published.
///
/// `sequential`: line vertices slide one after the other in the line's order, each to its final place, where it then
/// stays. Vertices within the active radius R of it (in space, on the already slid mesh), line vertices that have not
/// had their turn included, go with it by the damping (1 - (r/R)²)² times its way, along the straightest path in the
/// direction re-projected on their own tangent plane. The published damping and unfolding are not public; these are
/// method.md F's. Places depend on the order, so a symmetric side comes out skew. No repair of flips: as published.
///
/// Usage error: counts differ. Rejected: displacements that are not finite, triangles without area (place named).
Result<RetractionResult> retract(const SideMesh& side, const std::vector<Vec3>& displacements,
                                 const RetractionOptions& options = {});

} // namespace tapeline
