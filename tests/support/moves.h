// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension.h"
#include "kernel/feature_lines.h"
#include "kernel/move.h"
#include "kernel/quality.h"
#include "kernel/region.h"
#include "tests/support/shapes.h"

#include <vector>

namespace tapeline::testing {

/// A line through the listed vertices; fails the test when they are no chain.
FeatureLine line_of(const Model& model, const std::vector<int>& vertices);

/// All triangles of the model, its open border fixed.
Region whole_model(const Model& model);

/// A correspondence that sends each listed vertex to its place plus a displacement.
Correspondence sends(const Model& model, const FeatureLine& line, const std::vector<Vec3>& displacements);

/// An extended line that needs no extension: the listed vertices already run from rim to rim.
ExtendedLine already_extended(const Model& model, const Correspondence& correspondence);

/// The move of `line` in `region`. Throws with the error's sentence when it fails.
MoveResult move_or_throw(const Model& model, const std::vector<int>& line, const Region& region,
                         const TargetCurve& target, const MoveOptions& options);

/// The same for a panel that has these three.
template <class Panel>
MoveResult move_line(const Panel& panel, const TargetCurve& target, const MoveOptions& options)
{
    return move_or_throw(panel.model, panel.line, panel.region, target, options);
}

/// A move of the whole model's line, and its measures.
struct MeasuredMove {
    MoveResult move;
    QualityReport quality;
};
/// Moves `line` with everything inside the model's open border as region, and measures the result. Throws with the
/// error's sentence when the move fails.
MeasuredMove move_and_measure(const Model& model, const std::vector<int>& line, const TargetCurve& target,
                              const MoveOptions& options = {});

/// A rigid motion: rotation about a skew axis and a shift, in that order.
struct RigidMotion {
    Eigen::Matrix3d R;
    Vec3 shift;
    Vec3 operator()(const Vec3& p) const { return R * p + shift; }
};
RigidMotion some_rigid_motion();

/// The curve mapped by p -> scale R p + shift.
ParametricCurve mapped(const ParametricCurve& curve, const RigidMotion& motion, double scale = 1);

} // namespace tapeline::testing
