// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/elimination.h"
#include "kernel/extension.h"
#include "kernel/feature_rails.h"
#include "kernel/placement.h"
#include "kernel/plate_system.h"
#include "kernel/split.h"
#include "kernel/topology.h"

#include <memory>
#include <vector>

namespace tapeline {

/// What a drag starts from.
struct DragStart {
    ExtendedLine
        extended;       ///< the model with the prolongation cut in; its targets are not used. The side that makes room
                        ///< leaves its `features` where they are
    Positions V;        ///< positions that fit it: at rest, or of a finished move
    bool splits = true; ///< cut along the line, as methods that retract do; else the region stays in one piece
    int clamp_rings = 1;
    Material slide;           ///< of the retraction
    Material plate;           ///< of the parts that bend
    std::vector<int> tilting; ///< rim vertices that hold their place only (kernel/rim.h)
};

/// What a preview knows beside the positions.
struct DragStep {
    Positions V;                   ///< of the extended model's vertices; the start's outside the region, bit for bit
    PlacementResult placement;     ///< of the whole move from rest, as measured
    Correspondence correspondence; ///< on the extended model
    bool leaves_region = false;    ///< the target ends on or beyond the rim: only a new region can show it rightly
};

/// A quick look at where a move would go while its target is dragged about: everything that does not depend on the
/// target is made and factorised once, each step is a back-solve per side. The answer is the start plus the *linear*
/// response to the line's further displacement:
/// - a side that bends: of a thin plate over the rest shape (method.md A9), fixed at the rim;
/// - a side that the line runs into: the orthotropic harmonic extension, laid on the side's old surface (method.md A2,
///   without its rounds and repairs), since that is where every method that retracts leaves it; vertices of other
///   feature lines go along them as far as that extension takes them (FeatureRails), and it is solved again with these
///   given;
/// - beyond the line's ends: the end displacement fades out to the rim along the prolongation that is there.
/// So it is exact in the limit of small steps from the start and keeps the line on its target to the bit, but large
/// steps bend too little, and creases are not restored. Region and prolongation stay those of the start.
class Drag {
public:
    /// Rejected or not converged as `split_along` and `PlateSystem::create` are.
    static Result<Drag> create(DragStart start);

    /// Moves the line (on the start's model, uncut) to the target. Fails as `correspond` does.
    Result<DragStep> step(const FeatureLine& line, const TargetCurve& target, const CorrespondenceOptions& options,
                          std::optional<Placement> verdict, std::optional<LineSide> compressed) const;

    const ExtendedLine& extended() const { return start_.extended; }
    const Topology& topology() const { return topology_; } ///< of the extended model
    bool splits() const { return start_.splits; }
    /// Region triangles left and right of the prolonged line; all in the first list where the region is not split.
    const std::array<std::vector<int>, 2>& side_faces() const { return faces_; }

private:
    /// Other feature lines in a side.
    struct Rails {
        Mesh inner; ///< the side at rest, without its clamp rings
        FeatureRails lines;
        std::vector<int> vertices; ///< local: those that slide or stay
        Elimination slide;         ///< given: what the part holds, then these
    };
    struct Part {
        SideMesh side;
        std::vector<int> held; ///< local: fixed vertices, then the line
        PlateSystem plate;
        Elimination slide;
        ClosestPoint ground;                ///< the side's rest surface
        std::shared_ptr<const Rails> rails; ///< none where there is no other line
    };

    Drag(DragStart start, Topology topology, ClosestPoint surface);
    Result<void> add_part(SideMesh side);
    Result<std::shared_ptr<const Rails>> rails_of(const SideMesh& side, const std::vector<int>& held) const;
    std::vector<Vec3> line_goals(const Correspondence& correspondence, bool on_surface) const;
    bool at_rim(const Correspondence& correspondence) const;
    void slide_part(const Part& part, const Eigen::MatrixXd& change, Positions& V) const;
    void move_part(const Part& part, const std::vector<Vec3>& goals, bool slides, Positions& V) const;

    DragStart start_;
    Topology topology_;
    ClosestPoint surface_; ///< of the whole region at rest
    std::vector<Part> parts_;
    std::array<std::vector<int>, 2> faces_;
};

} // namespace tapeline
