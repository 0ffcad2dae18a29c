// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/baselines/rings.h"
#include "kernel/correspondence.h"
#include "kernel/crease.h"
#include "kernel/curve.h"
#include "kernel/end_slide.h"
#include "kernel/extension.h"
#include "kernel/method.h"
#include "kernel/placement.h"
#include "kernel/progress.h"
#include "kernel/region.h"
#include "kernel/retraction.h"
#include "kernel/rim.h"
#include "kernel/strip.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapeline {

enum class CreaseRestoration { automatic, off, on };

/// What a plate does at the line (method.md A9).
enum class LineCrease {
    free, ///< each side ends there like a cantilever: curvature of one sign in a section, the crease angle is a result
    keep  ///< the crease angle stays as it was; sections get an inflection where it takes one
};

struct MoveOptions {
    Method method = Method::plate_fl;
    CorrespondenceOptions correspondence;
    std::optional<RetractionMode> retraction; ///< default by method
    double active_radius_mm = 0;              ///< of the `sequential` retraction; 0 = up to the nearest fixed vertex
    ExtensionPath extension_path = ExtensionPath::geodesic;
    std::optional<ExtensionTarget> extension_target; ///< default by method
    double end_slide_mm = 0; ///< how far the line's ends may slide along Lt where that is smoother (kernel/end_slide.h)
    double stiffness_ratio = 100;            ///< μ
    std::optional<Stiff> stiff;              ///< default by method
    std::optional<Placement> placement;      ///< overrules the verdict
    std::optional<LineSide> compressed_side; ///< overrules the signed rule
    CreaseRestoration crease = CreaseRestoration::automatic;
    double crease_loss = 0.5; ///< `automatic` restores where the mean crease angle fell below this share of L0's
    double tolerance_mm = 0;  ///< solver's wanted error; 0 = 1e-5 of the region's size
    int max_iterations = 2000;
    int clamp_rings = 1;
    int rings = 20;                               ///< `arap-n`: n, 0 = one cell for the whole region
    RingWeights ring_weights = RingWeights::even; ///< `arap-n`
    double smoothness = 0.02;                     ///< `sr-arap`: α
    bool check_unique = false; ///< solve from a second start too and report how far apart the answers are
    /// Other methods than plate-fl bend a band along the rim once more, as a plate, for the tangent plane; `automatic`
    /// leaves the methods that do not cut the region, and the one as published, as they are.
    RimControl rim = RimControl::automatic;
    double rim_width_mm = 0;          ///< of that band; 0 = a third of the way to the line (plate-fl: its whole side)
    double rim_crease_angle = 5;      ///< a rim edge this sharp is a crease already [deg]
    double plate_stiffness_ratio = 0; ///< μ of plate-fl's plates, not of its retraction; see `plate_stiffness`
    LineCrease line_crease = LineCrease::free; ///< plate-fl only
    /// Width of the strips that asan-fl and plate-fl carry along: none = of the bends found, 0 = no strips [mm].
    std::optional<double> strip_width_mm;
    bool exact_surface = true; ///< CAD input: a retracted side ends on the exact faces, not on their triangles
};

double plate_stiffness(const MoveOptions& options); ///< μ of the plates; by default 3, with line_crease `keep` 1

/// What one solver run did.
struct SolveReport {
    std::string side; ///< "tension", "compression", "region" or "crease"
    int iterations = 0;
    double error_estimate_mm = 0;
    double tolerance_mm = 0;
    bool converged = true;
    double energy = 0;
    double seconds = 0;
};

/// Whether two starts of the solver, the rest shape with only the line moved and the harmonic displacement, end in the
/// same place. A side that is cut free is judged for itself, after the retraction; the worst side counts. Methods that
/// solve one linear system have one answer.
struct UniquenessReport {
    bool checked = false;
    double distance_mm = 0; ///< largest distance of a vertex between the two answers
    double limit_mm = 0.1;  ///< more than this is ambiguous
    bool converged = true;  ///< whether the second runs reached the tolerance too
    struct Energies {
        std::string side;
        double harmonic = 0; ///< from the harmonic start, the one that is used [mm²]
        double rest = 0;     ///< from the rest shape
    };
    std::vector<Energies> energies; ///< one per solver run
    int iterations = 0;             ///< of the second runs
    double seconds = 0;             ///< of the second runs
};

/// How far the free vertices of the compressed side lie from the exact CAD surface. Only for moves on the surface of
/// models that have one, and only as far as the target lies on it: vertices of the line stay on the target.
struct ExactSurfaceReport {
    bool applied = false;          ///< the vertices were laid on the surface all the way
    int vertices = 0;              ///< laid on the exact surface
    int left = 0;                  ///< could not be laid on it
    double distance_before_mm = 0; ///< after the slide over triangles
    double distance_after_mm = 0;  ///< in the result
    double line_distance_mm = 0;   ///< of the moved line's vertices, whose places the target decides
    double line_gap_mm = 0;        ///< largest distance of the line's targets, prolongation included, from L'0
};

struct MoveResult {
    Method method = Method::plate_fl;
    Model rest;    ///< the input model with the extension's cut: appended vertices last
    Positions V;   ///< moved positions of rest's vertices; equal to rest's outside the region, bit for bit
    Region region; ///< on rest's triangles
    Correspondence correspondence;  ///< the used line, on rest's vertices
    std::vector<int> extended_line; ///< L̂0 on rest's vertices
    ExtensionPath extension_path = ExtensionPath::geodesic;
    ExtensionTarget extension_target = ExtensionTarget::tapered;
    EndSlide end_slide{0, 0}; ///< how far the line's ends slid along Lt
    std::vector<AppendedVertex> appended;
    PlacementResult placement;
    std::vector<int> left_faces; ///< region triangles left of L̂0 (all of them stay in one list when not split)
    std::vector<int> right_faces;
    RetractionReport retraction;
    std::array<StripReport, 2> strips; ///< left and right of the line
    ExactSurfaceReport exact_surface;
    std::vector<SolveReport> solves;
    UniquenessReport uniqueness;
    CreaseReport crease;
    std::vector<std::pair<std::string, double>> seconds; ///< per stage, in order
    std::vector<std::string> warnings;

    bool converged() const;           ///< every solver run reached its tolerance
    bool ambiguous() const;           ///< uniqueness was asked for and is not there
    int iterations() const;           ///< of all solver runs
    double error_estimate_mm() const; ///< largest of all solver runs
};

/// Moves a feature line to its target and lets the region follow: ASAN-FL, the paper's seven steps (Section 3.5), or
/// one of the other methods (method.h). The input is not changed. A run that does not converge is returned with
/// `converged() == false`; whether that is an error is the caller's decision.
Result<MoveResult> move_feature_line(const Model& model, const FeatureLine& line, const TargetCurve& target,
                                     const Region& region, const MoveOptions& options = {},
                                     const Progress& progress = {});

} // namespace tapeline
