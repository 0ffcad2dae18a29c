// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/crease_ring.h"
#include "kernel/exact_side.h"
#include "kernel/move.h"
#include "kernel/plate.h"
#include "kernel/split.h"
#include "kernel/strip_transport.h"

#include <array>
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace tapeline {

/// A move under way: what the steps of `move_feature_line` hand on to each other. Each step calls one module.
class MoveState {
public:
    MoveState(const Model& model, const Region& region, const MoveOptions& options);

    Result<void> correspond_to(const FeatureLine& line, const TargetCurve& target); ///< Section 3.3
    Result<void> place();                                                           ///< step 1, Section 3.4
    Result<void> carry_line(const TargetCurve& target);           ///< takes junctions with other lines along
    Result<void> extend();                                        ///< step 2, Section 5.1
    Result<void> split();                                         ///< Section 5.2
    Result<void> deform_side(int side, const Progress& progress); ///< steps 3 and 5, Sections 5.3, 5.4
    Result<void> retract_side(int side);                          ///< step 4, Section 4
    Result<void> retract_tension();                               ///< the same where a zigzag compresses the other side
    Result<void> sew_sides();                                     ///< step 6, Section 5.5
    Result<void> restore_lost_crease(const Progress& progress);   ///< step 7, Section 5.6

    void keep_whole(); ///< in place of extend and split
    Result<void> solve_whole(const Progress& progress);
    void sew_all();                                    ///< the moved positions of the whole model
    Result<void> smooth_rim(const Progress& progress); ///< tangent plane at the rim, where asked for and not yet there
    void blend_whole();                                ///< brings in the share of the region's deformation in one piece

    /// Whether the method and the target ask for the cut.
    bool splits() const;
    /// Whether they ask for the region's deformation in one piece; both, where the target rises steeply.
    bool deforms_whole() const;
    /// Whether the tension side must end in the old crease, so that the compressed side comes first.
    bool keeps_crease() const;
    /// Whether the tension side's deformation says where the prolongation ends up, before anything can be retracted to it.
    bool tension_decides_ends() const { return result_.extension_target == ExtensionTarget::free; }
    int compression() const { return static_cast<int>(result_.placement.compressed); }
    int tension() const { return 1 - compression(); }
    MoveResult finish();

private:
    struct SideState {
        SideMesh side;
        Positions rest; ///< the rest shape of the next solve: original, or slid after the retraction
        Positions V;    ///< current positions
        std::optional<CarriedStrip> strip;
        std::optional<ExactSide> exact; ///< made when first asked for
    };

    struct Constraints {
        std::vector<int> vertices; ///< local
        Positions targets;
    };

    Material material_for(const std::vector<Vec3>& displacements) const;
    double region_size() const;
    DeformationOptions solver_options(const Material& material) const;
    Constraints constraints(const SideState& side, const std::vector<Vec3>& line_targets) const;
    std::vector<Eigen::Matrix3d> frame_turns(const Mesh& rest, const SideState& side,
                                             const std::vector<Vec3>& line_targets) const;
    Result<DeformationResult> deform_by(Deformer deformer, const SideState& side, const std::vector<Vec3>& line_targets,
                                        const DeformationOptions& options, const std::optional<Positions>& start,
                                        const Progress& progress) const;
    Result<Positions> solve_by(Deformer deformer, const SideState& side, const std::vector<Vec3>& targets,
                               const DeformationOptions& options, const std::string& name, const Progress& progress);
    Result<void> solve(SideState& side, const std::vector<Vec3>& targets, const Material& material,
                       const std::string& name, const Progress& progress);
    Result<DeformationResult> bend_part(const SideState& side, const Constraints& constraints,
                                        const DeformationOptions& options, const std::optional<Positions>& start,
                                        const Progress& progress) const;
    /// `held`: of the side whose ring of triangles beside the line keeps the crease's angle.
    PlateOptions plate_options(const DeformationOptions& options, bool held = false) const;
    /// Whether both sides meet along the prolongation as the surface did there at rest.
    bool guides_ends() const;
    CreaseRing ring(int side, const Positions& carried, const std::vector<Vec3>& normals) const;
    /// Puts the plate's first ring of vertices where its triangles have the normals that they are to have.
    Result<void> hold_ring(int side, PlateSupport& support, const PlateOptions& options) const;
    /// What the method's own solve is to do at the rim.
    RimControl own_rim_control() const;
    bool makes_transition() const;
    /// How much of the transition a side takes: none where it lies on the old surface already.
    double transition_share(int side) const;
    void take_band(const SideMesh& part, const std::vector<int>& band, const Positions& V);
    Result<void> check_plate_options() const;
    std::vector<int> tilting_vertices(const SideMesh& side) const;
    void take_free_extension(const SideState& side);
    bool retracts_on_rails() const { return result_.retraction.mode == RetractionMode::harmonic; }
    bool keeps_to_cad() const;
    const ExactSide& exact_side(SideState& state) const;
    void lay_slid_on_cad(SideState& state, Positions& slid);
    void lay_solved_on_cad(SideState& state);
    void find_strips();
    void lay_strip(int side, bool rests);
    Result<void> settle_strip(SideState& side, const std::vector<Vec3>& targets, const DeformationOptions& options);
    void warn_of_lines();
    void warn_of_carried_junctions(const TargetCurve& target);
    /// How far the line moves into that side where it does so most, as a share of its largest displacement anywhere.
    double runs_into(int side) const;
    /// Share of the thin plate in the deformation: for asan-fl it grows to 1 on a target that swings to both sides.
    double plate_share() const;
    Result<void> guide_borders();
    void report_crease();
    /// How much of the lost crease angle is to be given back, by the share of the angle that is left.
    double restored_share(double kept) const;
    Result<void> bend_side(int side, const std::vector<double>& wanted);
    void warn(std::string_view text);
    void warn_of_folds(const RetractionResult& retraction);
    template <class Step>
    Result<void> timed(const std::string& stage, const Step& step);

    const Model& model_;
    const MoveOptions& options_;
    const MethodInfo& method_;
    const TargetCurve* target_ = nullptr;
    double plate_share_ = 0; ///< decided by `place`
    ExtendedLine extended_;
    std::array<SideState, 2> sides_;
    SideState whole_;
    bool cut_ = false;                     ///< whether the region is cut at this stage
    Vec3 stiff_direction_ = Vec3::UnitX(); ///< d_o of the first solve
    double stiffness_ratio_ = 1;
    MoveResult result_;
};

/// Stiff direction d_o from the line's displacements (Section 5.3): their mean; where they cancel, their principal
/// axis. `ratio` falls to 1 (isotropic) towards where neither exists, as on a loop that shrinks evenly.
Vec3 stiff_direction(const std::vector<Vec3>& displacements, double& ratio);

template <class Step>
Result<void> MoveState::timed(const std::string& stage, const Step& step)
{
    const auto begin = std::chrono::steady_clock::now();
    Result<void> done = step();
    result_.seconds.emplace_back(stage,
                                 std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return done;
}

} // namespace tapeline
