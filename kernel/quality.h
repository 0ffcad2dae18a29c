// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/split.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tapeline {

class Topology;

/// What is measured: a deformed mesh against its rest shape (same triangles), the line on it, and its two sides.
struct QualityInput {
    const Mesh& rest;
    const Positions& moved;
    std::vector<int> line; ///< the moved line's vertices in order
    bool closed = false;
    std::vector<int> compressed_faces;   ///< region triangles of the compressed side; empty when there is none
    std::vector<int> tension_faces;      ///< region triangles of the other side
    const TargetCurve* target = nullptr; ///< null: no line error
    int stations = 9;                    ///< number of sections across the line
    std::vector<int> extended_line = {}; ///< the line with its prolongation to the rim; empty when there is none
    std::vector<int> carried = {}; ///< vertices of strips that went along with the line as pieces: they may leave the
                                   ///< old surface, as the line may, and count in no bulge
    const Model* cad =
        nullptr; ///< rest's triangles with the CAD faces that they stand for, from which the bulge is then
                 ///< measured; null or without exact faces: from the triangles
};

/// What a bulge is measured from: the exact CAD faces before the move, or the triangles before it.
enum class BulgeReference { triangles, exact };

/// One section across Lt: four polylines in one plane, each from the line outwards to the region's rim. A list of
/// triangles that holds both sides of the line (an uncut region) is taken apart at the line, its right part counting
/// to the other side.
struct Section {
    Vec3 origin = Vec3::Zero();      ///< point of the moved line
    Vec3 normal = Vec3::Zero();      ///< of the section plane (the moved line's tangent)
    Vec3 outward = Vec3::Zero();     ///< unit, in the plane, away from the part at the moved line
    Vec3 rest_normal = Vec3::Zero(); ///< of the plane of the `before` polylines: the same, unless that plane misses L0;
                                     ///< then L0's tangent at the same place of the line
    std::vector<Vec3> compressed_before, compressed_after; ///< from the line outwards
    std::vector<Vec3> tension_before, tension_after;
    /// Per point of the four polylines, in the order above: how far the surface that the mesh stands for may lie from the
    /// edge cut there [mm], the sagitta of the edge after the normals at its ends; 0 on creases.
    std::array<std::vector<double>, 4> sagitta;
};

struct SectionMeasure {
    int inflections_before = 0, inflections_after = 0; ///< sign changes of curvature above the dead band of
                                                       ///< kernel/sections.h, worst station
    double turning_before = 0, turning_after = 0;      ///< total absolute turning [deg], worst station
    double turning_increase = 0;                       ///< largest after − before at one station [deg]
};

/// Measures 1–7 of the quality page. Lengths mm, angles deg, ratios without unit.
struct QualityReport {
    double line_error_max_mm = 0;  ///< line vertices to Lt
    double chord_error_max_mm = 0; ///< the moved polyline's mid-edges to Lt
    double slide_max_mm = 0;       ///< largest displacement of a line vertex
    double bulge_max_mm = 0;       ///< signed distance of the compressed side to the rest surface, of largest size
    double bulge_rms_mm = 0;       ///< over the compressed side, weighted by area
    double bulge_fraction = 0;     ///< |bulge_max| / slide_max
    Vec3 bulge_at = Vec3::Zero();
    BulgeReference bulge_reference = BulgeReference::triangles;
    int bulge_fallbacks = 0; ///< with `exact`: vertices measured from the triangles, their closest place on the CAD
                             ///< faces being in doubt (kernel/exact_sheet.h)
    SectionMeasure compressed_sections, tension_sections;
    double gauss_sign_change = 0; ///< share of area in [0, 1] whose sign went from + to - or back, both beyond the
                                  ///< dead band (kernel/quality_curvature.cpp; method.md G3); without the line
    double mean_sign_change = 0;
    double gauss_sign_change_compressed = 0; ///< the same share within the compressed side alone
    /// What became of the tension side's crown, away from line and rim, where that side is curved (relative to Σ A |H|
    /// at rest, H the mean curvature and A the vertex's area): `change` = (H̄' - H̄) / |H|‾ of the area-weighted means,
    /// -1 = pulled straight, 0 = kept, 1 = twice as round; `local` = Σ A |H' - H| / Σ A |H|.
    struct Crown {
        double change = 0, local = 0;
    };
    std::optional<Crown> crown;
    double crease_before = 0, crease_after = 0; ///< length-weighted mean along the line [deg]
    double crease_rms_difference = 0, crease_max_difference = 0;
    double min_angle_before = 0, min_angle_after = 0;
    double squash = 1;          ///< min of (altitude on the line's direction after / before), worst side
    double min_area_ratio = 1;  ///< triangle area after / before
    int flipped = 0;            ///< triangles turned over against their rest normal (compressed side) or against
                                ///< most of their neighbours (both sides)
    int self_intersections = 0; ///< pairs of region triangles that meet after the move and did not before
    Vec3 self_intersection_at = Vec3::Zero(); ///< the middle of one of them after the move [mm]
    std::optional<double>
        symmetry_residual_mm;          ///< where the rest shape, L0 and Lt share a mirror plane: largest distance
                                       ///< of a moved vertex's image to the moved mirrored vertex
    double rim_crease_mean_change = 0; ///< change of the dihedral angle across the region's rim, length-weighted [deg]
    double rim_crease_max_change = 0;
    /// The same across the line's prolongation, a kink beyond its ends; none where the line was not prolonged.
    std::optional<double> extension_crease_mean_change, extension_crease_max_change;
};

/// Per-vertex maps for pictures, one value per vertex of the mesh (NaN outside the region). Curvatures are NaN on the
/// line and on open borders too, and 0 within the dead band.
struct QualityMaps {
    std::vector<double> bulge_mm;                  ///< signed distance to the rest surface, both sides
    std::vector<double> gauss_before, gauss_after; ///< angle defect / area [1/mm²]
    std::vector<double> mean_before, mean_after;   ///< [1/mm], positive = convex seen from outside
};

/// All numbers. Rejected when the moved mesh does not belong to the rest mesh, an index does not exist or a
/// coordinate is not finite. The line's vertices should be joined by mesh edges; edges that are not are left out.
Result<QualityReport> measure_quality(const QualityInput& input);
/// The numbers that can be had while a target is dragged: line, bulge, sections and creases along the line; the others
/// keep their defaults. Rejected as `measure_quality` does.
Result<QualityReport> measure_strip(const QualityInput& input);
/// The maps; empty lists where `measure_quality` would reject the input.
QualityMaps quality_maps(const QualityInput& input);
/// The sections at the fractions (k + 1/2) / stations of the moved line's length, normal to it; none where
/// `measure_quality` would reject the input.
std::vector<Section> cross_sections(const QualityInput& input);

/// Parts of `faces` to the left and right of the line, for results whose cut is not known (grown from the line's
/// triangles, each triangle going to the side that reaches it first).
std::pair<std::vector<int>, std::vector<int>> sides_of_line(const Mesh& mesh, const std::vector<int>& faces,
                                                            const std::vector<int>& line, bool closed);

/// The triangles that had to make room, and those that were stretched: `sides` (left, right of the line) taken apart
/// where the line's displacement changes sides, as with a zigzag target (method.md A5). Each triangle follows the line
/// vertex nearest to its centre: there the side that the displacement runs into counts as compressed, by its conormal;
/// where it runs into neither by more than a fiftieth of the largest displacement, `compressed` does. Displacements: one
/// per entry of `line` [mm]. A target to one side alone gives the two sides unchanged.
struct StrainedParts {
    std::vector<int> compressed, tension; ///< triangles, ascending
};
StrainedParts strained_parts(const Mesh& rest, const std::pair<std::vector<int>, std::vector<int>>& sides,
                             const std::vector<int>& line, bool closed, const std::vector<Vec3>& displacements,
                             LineSide compressed);
/// The same with the rest mesh's connectivity at hand.
StrainedParts strained_parts(const Mesh& rest, const Topology& topology,
                             const std::pair<std::vector<int>, std::vector<int>>& sides, const std::vector<int>& line,
                             bool closed, const std::vector<Vec3>& displacements, LineSide compressed);

} // namespace tapeline
