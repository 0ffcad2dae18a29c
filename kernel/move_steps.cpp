// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/move_steps.h"

#include "kernel/border_slide.h"
#include "kernel/junctions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

bool is_free(const Vec3& target) { return !target.allFinite(); }

double mean_size(const std::vector<Vec3>& vectors)
{
    double sum = 0;
    for (const Vec3& v : vectors) {
        sum += v.norm();
    }
    return vectors.empty() ? 0 : sum / static_cast<double>(vectors.size());
}

} // namespace

Vec3 stiff_direction(const std::vector<Vec3>& displacements, double& ratio)
{
    Vec3 sum = Vec3::Zero();
    double length = 0;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& u : displacements) {
        sum += u;
        length += u.norm();
        spread += u * u.transpose();
    }
    if (length == 0) {
        ratio = 1;
        return Vec3::UnitX();
    }
    // From one rule to the next gradually, so that no displacement makes the material change at once.
    constexpr double no_mean = 0.2, clear_mean = 0.95, no_axis = 0.2, clear_axis = 1.0 / 3;
    const double coherence = smooth_step(sum.norm() / length, no_mean, clear_mean);
    if (coherence == 1) {
        return sum.normalized();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    const double first = axes.eigenvalues()[2], second = axes.eigenvalues()[1];
    const double axial = smooth_step((first - second) / (first + second), no_axis, clear_axis);
    const Vec3 mean = sum.stableNormalized(), axis = axes.eigenvectors().col(2);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> both(coherence * mean * mean.transpose() +
                                                              (1 - coherence) * axial * axis * axis.transpose());
    ratio = 1 + (ratio - 1) * std::clamp(both.eigenvalues()[2] - both.eigenvalues()[1], 0.0, 1.0);
    return ratio > 1 ? Vec3(both.eigenvectors().col(2)) : Vec3::UnitX();
}

MoveState::MoveState(const Model& model, const Region& region, const MoveOptions& options)
    : model_(model), options_(options), method_(method_info(options.method))
{
    result_.region = region;
    result_.warnings = region.warnings;
    result_.extension_path = options.extension_path;
    result_.method = options.method;
    result_.extension_target = options.extension_target.value_or(method_.extension_target);
    result_.retraction.mode = options.retraction.value_or(method_.retraction);
}

Result<void> MoveState::correspond_to(const FeatureLine& line, const TargetCurve& target)
{
    return timed("correspondence", [&]() -> Result<void> {
        target_ = &target;
        auto found = correspond(model_, line, target, options_.correspondence);
        if (!found) {
            return tl::unexpected(found.error());
        }
        result_.correspondence = std::move(*found);
        std::ranges::copy(result_.correspondence.warnings, std::back_inserter(result_.warnings));
        for (const int v : result_.correspondence.line.vertices) {
            if (std::ranges::binary_search(result_.region.inner_fixed, v)) {
                return fail(
                    ErrorKind::rejected,
                    fmt::format("vertex {} is both on the line and among the fixed vertices: take it out of one", v));
            }
        }
        return {};
    });
}

void MoveState::warn(std::string_view text) { result_.warnings.emplace_back(text); }

Result<void> MoveState::place()
{
    return timed("placement", [&]() -> Result<void> {
        if (auto fine = check_plate_options(); !fine) {
            return fine;
        }
        PlacementResult& placement = result_.placement;
        placement = decide_placement(model_.mesh, result_.region, result_.correspondence);
        if (options_.placement) {
            placement.verdict = *options_.placement;
        }
        if (options_.placement || method_.as_published) {
            placement.whole_share = placement.verdict == Placement::off_surface ? 1 : 0;
        }
        placement.compressed = options_.compressed_side.value_or(placement.compressed);
        plate_share_ = plate_share();
        if (plate_share_ > 0 && method_.deformer != Deformer::plate) {
            result_.warnings.push_back(
                fmt::format("the target runs into both sides of the line: they bend as thin plates{}",
                            plate_share_ < 1 ? fmt::format(" by {:.0f} %", 100 * plate_share_) : ""));
        }
        const bool orthotropic = method_.deformer != Deformer::spokes_and_rims;
        stiffness_ratio_ = orthotropic ? options_.stiffness_ratio : 1;
        stiff_direction_ = stiff_direction(result_.correspondence.displacements, stiffness_ratio_);
        if (stiffness_ratio_ == 1 && orthotropic && options_.stiffness_ratio != 1 && placement.u_max_mm > 0) {
            warn("the line's displacements have no common direction: an isotropic material is used");
        }
        return {};
    });
}

bool MoveState::splits() const { return method_.splits && result_.placement.whole_share < 1; }

bool MoveState::deforms_whole() const { return !method_.splits || result_.placement.whole_share > 0; }

Result<void> MoveState::extend()
{
    return timed("extension", [&]() -> Result<void> {
        ExtensionOptions options;
        options.path = options_.extension_path;
        options.target = result_.extension_target;
        options.exact_surface = options_.exact_surface && !method_.as_published;
        auto extended = extend_line(model_, result_.region, result_.correspondence, options);
        if (!extended) {
            return tl::unexpected(extended.error());
        }
        extended_ = std::move(*extended);
        if (options_.end_slide_mm > 0) {
            auto slid = slide_ends(extended_, model_, result_.region.faces, *target_, options, options_.end_slide_mm,
                                   result_.correspondence);
            if (!slid) {
                return tl::unexpected(slid.error());
            }
            result_.end_slide = *slid;
        }
        std::ranges::copy(extended_.warnings, std::back_inserter(result_.warnings));
        // Where the line ends on the rim or runs over what is held, it stays there to the bit.
        for (size_t i = 0; i < extended_.vertices.size(); ++i) {
            const bool used = static_cast<int>(i) >= extended_.first && static_cast<int>(i) <= extended_.last;
            const int v = extended_.vertices[i];
            if (!used && (std::ranges::binary_search(extended_.region.fixed_rim, v) ||
                          std::ranges::binary_search(extended_.region.inner_fixed, v))) {
                extended_.targets[i] = extended_.model.mesh.V.row(v);
            }
        }
        return retracts_on_rails() ? carry_extension(extended_) : Result<void>();
    });
}

void MoveState::keep_whole()
{
    extended_ = unextended(model_, result_.region, result_.correspondence);
    whole_.side = whole_region(extended_, options_.clamp_rings);
    whole_.rest = whole_.V = whole_.side.mesh.V;
}

Result<void> MoveState::split()
{
    return timed("split", [&]() -> Result<void> {
        auto parts = split_along(extended_, options_.clamp_rings);
        if (!parts) {
            return tl::unexpected(parts.error());
        }
        for (int s = 0; s < 2; ++s) {
            sides_[s].side = std::move((*parts)[s]);
            sides_[s].rest = sides_[s].V = sides_[s].side.mesh.V;
        }
        cut_ = true;
        find_strips();
        warn_of_lines();
        return guide_borders();
    });
}

Result<void> MoveState::guide_borders()
{
    if (extended_.closed) {
        return {};
    }
    const Mesh& mesh = extended_.model.mesh;
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    for (const int entry : {0, static_cast<int>(extended_.vertices.size()) - 1}) {
        const int end = extended_.vertices[entry];
        const bool used_end = entry == extended_.first || entry == extended_.last;
        const bool held = std::ranges::binary_search(extended_.region.fixed_rim, end);
        if (!used_end || !held || is_free(extended_.targets[entry])) {
            continue;
        }
        auto slide = slide_border(mesh, topology, extended_.region, end, extended_.targets[entry]);
        if (!slide) {
            return tl::unexpected(slide.error());
        }
        for (SideState& state : sides_) {
            SideMesh& side = state.side;
            for (size_t i = 0; i < slide->vertices.size(); ++i) {
                const auto at = std::ranges::lower_bound(side.to_global, slide->vertices[i]);
                const int v = static_cast<int>(at - side.to_global.begin());
                // Only the side's own fixed vertices: those of the other side are not its business.
                if (at == side.to_global.end() || *at != slide->vertices[i] || std::erase(side.fixed, v) == 0) {
                    continue;
                }
                side.guided.push_back(v);
                side.guided_targets.push_back(slide->targets[i]);
            }
        }
    }
    return {};
}

Material MoveState::material_for(const std::vector<Vec3>& displacements) const
{
    Material material;
    material.stiffness_ratio = stiffness_ratio_;
    material.stiff_direction = stiff_direction_;
    material.stiff = options_.stiff.value_or(cut_ ? Stiff::along : Stiff::across);
    // Once the slide has brought the line to its target there is no direction left to take (method.md A6).
    if (mean_size(displacements) > 1e-3 * mean_size(result_.correspondence.displacements)) {
        double ratio = stiffness_ratio_;
        material.stiff_direction = stiff_direction(displacements, ratio);
        material.stiffness_ratio = ratio;
    }
    return material;
}

Result<void> MoveState::solve_whole(const Progress& progress)
{
    return timed("solve", [&] {
        return solve(whole_, extended_.targets, material_for(result_.correspondence.displacements), "region", progress);
    });
}

Result<void> MoveState::deform_side(int side, const Progress& progress)
{
    const bool tense = side == tension();
    return timed(tense ? "deform tension side" : "deform compression side", [&]() -> Result<void> {
        SideState& state = sides_[side];
        std::vector<Vec3> displacements;
        for (int i = extended_.first; i <= extended_.last; ++i) {
            displacements.push_back(extended_.targets[i] - Vec3(state.rest.row(state.side.line[i])));
        }
        auto done =
            solve(state, extended_.targets, material_for(displacements), tense ? "tension" : "compression", progress);
        if (done && tense) {
            take_free_extension(state);
        } else if (done) {
            lay_solved_on_cad(state);
        }
        return done;
    });
}

void MoveState::take_free_extension(const SideState& side)
{
    for (size_t i = 0; i < extended_.targets.size(); ++i) {
        if (is_free(extended_.targets[i])) {
            extended_.targets[i] = side.V.row(side.side.line[i]);
        }
    }
}

Result<void> MoveState::sew_sides()
{
    result_.V = extended_.model.mesh.V;
    for (const SideState& state : sides_) {
        sew(state.side, state.V, result_.V);
    }
    return {};
}

void MoveState::blend_whole()
{
    const double share = result_.placement.whole_share;
    Positions whole = extended_.model.mesh.V;
    sew(whole_.side, whole_.V, whole);
    const Eigen::Index before = model_.mesh.V.rows();
    for (size_t i = 0; i < extended_.appended.size(); ++i) {
        const AppendedVertex& added = extended_.appended[i];
        whole.row(before + static_cast<Eigen::Index>(i)) =
            (1 - added.t) * whole.row(added.a) + added.t * whole.row(added.b);
    }
    // Vertices outside the region and on the line are the same in both, to the bit.
    result_.V += share * (whole - result_.V);
}

void MoveState::sew_all()
{
    if (!splits()) {
        result_.V = extended_.model.mesh.V;
        sew(whole_.side, whole_.V, result_.V);
    } else if (deforms_whole()) {
        blend_whole();
    }
}

MoveResult MoveState::finish()
{
    if (!splits()) {
        result_.left_faces = extended_.region.faces;
    } else {
        const auto inner = [](const SideMesh& side) {
            return std::vector<int>(side.own_faces().begin(), side.own_faces().end());
        };
        result_.left_faces = inner(sides_[0].side);
        result_.right_faces = inner(sides_[1].side);
    }
    report_crease();
    result_.extended_line = extended_.vertices;
    result_.appended = extended_.appended;
    result_.region = std::move(extended_.region);
    result_.rest = std::move(extended_.model);
    return std::move(result_);
}

} // namespace tapeline
