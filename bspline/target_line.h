// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/error.h"

#include <memory>
#include <vector>

namespace tapeline {

/// Plain data of a B-spline curve; what the JSON target file holds. Knots are given with repetition
/// (control_points + degree + 1 of them; a closed curve is written clamped, first point = last point).
struct BSplineData {
    static constexpr int max_degree = 25; ///< OpenCASCADE's limit

    int degree = 3;
    std::vector<double> knots;
    std::vector<double> weights;      ///< empty = all 1
    std::vector<Vec3> control_points; ///< [mm]
    bool closed = false;
};

/// An exact B-spline target line Lt, the same curve as OpenCASCADE's Geom_BSplineCurve of these data (io/ converts).
/// Value type, immutable. Evaluated by de Casteljau's scheme on Bézier pieces: OpenCASCADE 7.6 goes through Taylor
/// coefficients, which loses half of the digits at degree 25 and would put vertices off the line.
class TargetLine final : public TargetCurve {
public:
    /// Rejected when the knots, degree, weights and points do not make a curve, or a value is not finite. Knots that
    /// do not repeat at the ends (unclamped, periodic) are clamped without changing the curve.
    static Result<TargetLine> from_data(const BSplineData& data);
    BSplineData data() const;

    double first_parameter() const override;
    double last_parameter() const override;
    bool closed() const override;
    Vec3 point(double parameter) const override;
    Vec3 tangent(double parameter) const override;
    double arc_length(double parameter) const override;
    double parameter_at(double arc_length) const override;
    CurveFoot foot(const Vec3& p) const override;
    std::vector<CurveFoot> all_feet(const Vec3& p) const override;

    struct Impl;
    explicit TargetLine(std::shared_ptr<const Impl> impl);
    const Impl& impl() const { return *impl_; }

private:
    std::shared_ptr<const Impl> impl_;
};

} // namespace tapeline
