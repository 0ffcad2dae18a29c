// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/moves.h"

#include <Eigen/Geometry>
#include <numeric>
#include <stdexcept>

namespace tapeline::testing {

FeatureLine line_of(const Model& model, const std::vector<int>& vertices)
{
    auto line = line_through(model, vertices);
    if (!line) {
        throw std::runtime_error(line.error().message);
    }
    return *line;
}

Region whole_model(const Model& model)
{
    std::vector<int> all(model.mesh.F.rows());
    std::iota(all.begin(), all.end(), 0);
    return region_of_faces(model, all, false, {});
}

Correspondence sends(const Model& model, const FeatureLine& line, const std::vector<Vec3>& displacements)
{
    Correspondence result;
    result.line = line;
    result.displacements = displacements;
    for (size_t i = 0; i < displacements.size(); ++i) {
        result.targets.push_back(Vec3(model.mesh.V.row(line.vertices[i])) + displacements[i]);
        result.parameters.push_back(static_cast<double>(i));
        result.tangents.push_back(Vec3::UnitX());
    }
    return result;
}

ExtendedLine already_extended(const Model& model, const Correspondence& correspondence)
{
    ExtendedLine extended;
    extended.model = model;
    extended.region = whole_model(model);
    extended.vertices = correspondence.line.vertices;
    extended.closed = correspondence.line.closed;
    extended.last = static_cast<int>(extended.vertices.size()) - 1;
    extended.targets = correspondence.targets;
    return extended;
}

MoveResult move_or_throw(const Model& model, const std::vector<int>& line, const Region& region,
                         const TargetCurve& target, const MoveOptions& options)
{
    auto moved = move_feature_line(model, line_of(model, line), target, region, options);
    if (!moved) {
        throw std::runtime_error(moved.error().message);
    }
    return std::move(*moved);
}

MeasuredMove move_and_measure(const Model& model, const std::vector<int>& line, const TargetCurve& target,
                              const MoveOptions& options)
{
    MoveResult moved = move_or_throw(model, line, whole_model(model), target, options);
    const bool left = moved.placement.compressed == LineSide::left;
    QualityInput input{moved.rest.mesh,
                       moved.V,
                       moved.correspondence.line.vertices,
                       moved.correspondence.line.closed,
                       left ? moved.left_faces : moved.right_faces,
                       left ? moved.right_faces : moved.left_faces,
                       &target,
                       9};
    auto quality = measure_quality(input);
    if (!quality) {
        throw std::runtime_error(quality.error().message);
    }
    return {std::move(moved), *quality};
}

RigidMotion some_rigid_motion()
{
    return {Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(), Vec3(1300, -250, 700)};
}

ParametricCurve mapped(const ParametricCurve& curve, const RigidMotion& motion, double scale)
{
    return {[=](double t) -> Vec3 { return scale * (motion.R * curve.point(t)) + motion.shift; },
            [=](double t) -> Vec3 { return scale * (motion.R * curve.derivative(t)); }, curve.first_parameter(),
            curve.last_parameter(), curve.closed()};
}

} // namespace tapeline::testing
