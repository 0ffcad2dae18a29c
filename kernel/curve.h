// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <optional>
#include <vector>

namespace tapeline {

/// The point of a curve nearest to a query point.
struct CurveFoot {
    double parameter = 0; ///< curve parameter, in the curve's own range
    Vec3 point = Vec3::Zero();
    Vec3 tangent = Vec3::Zero(); ///< unit, in the sense of growing parameter
    double distance = 0;         ///< to the query point [mm]
    bool at_end = false;         ///< the foot is an end of an open curve and the query point lies beyond it
};

/// What the kernel needs of an exact target line Lt. Implemented by bspline/ on an OpenCASCADE B-spline, and by
/// tests in closed form. All members are safe to call from several threads.
class TargetCurve {
public:
    virtual ~TargetCurve() = default;

    virtual double first_parameter() const = 0;
    virtual double last_parameter() const = 0;
    virtual bool closed() const = 0;
    virtual Vec3 point(double parameter) const = 0;
    /// Unit tangent.
    virtual Vec3 tangent(double parameter) const = 0;
    /// Length from the first parameter to `parameter` [mm].
    virtual double arc_length(double parameter) const = 0;
    /// Inverse of `arc_length`; clamped to the range of an open curve.
    virtual double parameter_at(double arc_length) const = 0;
    double length() const { return arc_length(last_parameter()); }

    /// The globally nearest point to p.
    virtual CurveFoot foot(const Vec3& p) const = 0;
    /// All points C(t) with (p - C(t)) · C'(t) = 0, nearest first; more than one within reach means that the
    /// orthogonal projection is not unique there.
    virtual std::vector<CurveFoot> all_feet(const Vec3& p) const = 0;
};

/// A point on an exact CAD face.
struct SurfaceFoot {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero(); ///< unit, outward (the side from which the triangles are counter-clockwise)
};

/// Closest points on exact CAD faces. Implemented by io/ on OpenCASCADE surfaces. Thread-safe.
class SurfaceProjector {
public:
    virtual ~SurfaceProjector() = default;
    virtual int face_count() const = 0;
    /// Point of CAD face `cad_face` closest to p (the trimmed face, borders included); empty when none was found.
    virtual std::optional<SurfaceFoot> closest(int cad_face, const Vec3& p) const = 0;
    /// Point of CAD edge `cad_edge` closest to p; empty when none was found.
    virtual std::optional<Vec3> closest_on_edge(int cad_edge, const Vec3& p) const = 0;
};

} // namespace tapeline
