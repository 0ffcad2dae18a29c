// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/move_steps.h"

#include <cmath>

namespace tapeline {

namespace {

/// Length-weighted mean over the line's edges, lengths taken on the rest model.
double mean_along(const Mesh& rest, const FeatureLine& line, const std::vector<double>& values)
{
    double sum = 0, length = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        const int a = line.vertices[i], b = line.vertices[(i + 1) % line.vertices.size()];
        const double edge = (rest.V.row(b) - rest.V.row(a)).norm();
        sum += edge * values[i];
        length += edge;
    }
    return length > 0 ? sum / length : 0;
}

std::vector<double> sizes(std::vector<double> values)
{
    for (double& value : values) {
        value = std::abs(value);
    }
    return values;
}

} // namespace

Result<void> MoveState::restore_lost_crease(const Progress& progress)
{
    return timed("crease", [&]() -> Result<void> {
        const FeatureLine& line = result_.correspondence.line;
        const Mesh& rest = extended_.model.mesh;
        std::vector<double> wanted = signed_crease_angles(rest, rest.V, line);
        const std::vector<double> found = signed_crease_angles(rest, result_.V, line);
        // What is left of the crease counts in its old sense: a crease that turned inside out is lost too.
        std::vector<double> kept, changed;
        for (size_t i = 0; i < wanted.size(); ++i) {
            kept.push_back(wanted[i] < 0 ? -found[i] : found[i]);
            changed.push_back(std::abs(wanted[i] - found[i]));
        }
        result_.crease.lost_before_restoration = mean_along(rest, line, changed);
        const double angle = mean_along(rest, line, sizes(wanted));
        // A carried strip keeps its shape; turning its first triangles would bend it.
        if (sides_[method_.as_published ? compression() : tension()].strip) {
            return {};
        }
        const double share = restored_share(angle > 0 ? mean_along(rest, line, kept) / angle : 1);
        if (share == 0) {
            return {};
        }
        for (size_t i = 0; i < wanted.size(); ++i) {
            wanted[i] = found[i] + share * (wanted[i] - found[i]);
        }
        // The published method turns the compressed side; the tension side leaves the former on the old surface.
        const int bent = method_.as_published ? compression() : tension();
        auto done = bend_side(bent, wanted);
        if (done && !progress.report(1, "crease")) {
            return fail(ErrorKind::cancelled, "the crease restoration was cancelled");
        }
        return done.and_then([&] { return sew_sides(); });
    });
}

double MoveState::restored_share(double kept) const
{
    if (options_.crease == CreaseRestoration::off) {
        return 0;
    }
    constexpr double fully = 0.8; // of the share below which an angle counts as lost
    const bool always = options_.crease == CreaseRestoration::on;
    const double lost = always ? 1 : 1 - smooth_step(kept, fully * options_.crease_loss, options_.crease_loss);
    // A plate was asked beforehand what becomes of the crease.
    return (1 - plate_share_) * lost;
}

Result<void> MoveState::bend_side(int side, const std::vector<double>& wanted)
{
    const FeatureLine& line = result_.correspondence.line;
    SideState& state = sides_[side];
    const Topology topology(extended_.model.mesh.F, static_cast<int>(extended_.model.mesh.V.rows()));
    const Mesh moved{result_.V, extended_.model.mesh.F};
    std::vector<Vec3> other_normals;
    std::vector<double> angles;
    for (size_t i = 0; i < wanted.size(); ++i) {
        const int a = line.vertices[i], b = line.vertices[(i + 1) % line.vertices.size()];
        other_normals.push_back(
            triangle_normal(moved, side == 0 ? topology.face_left_of(b, a) : topology.face_left_of(a, b)));
        angles.push_back(side == 0 ? wanted[i] : -wanted[i]);
    }
    const DeformationOptions options = solver_options(material_for(result_.correspondence.displacements));
    auto restored =
        restore_crease(state.side, state.V, extended_.first, extended_.last, other_normals, angles, options);
    if (!restored) {
        return tl::unexpected(restored.error());
    }
    result_.crease.applied = true;
    state.V = std::move(restored->V);
    result_.solves.push_back({"crease", restored->iterations, restored->error_estimate_mm, options.tolerance_mm,
                              restored->converged, restored->energy, restored->seconds});
    return {};
}

void MoveState::report_crease()
{
    const FeatureLine& line = result_.correspondence.line;
    const Mesh& rest = extended_.model.mesh;
    result_.crease.before = mean_along(rest, line, sizes(signed_crease_angles(rest, rest.V, line)));
    result_.crease.after = mean_along(rest, line, sizes(signed_crease_angles(rest, result_.V, line)));
}

} // namespace tapeline
