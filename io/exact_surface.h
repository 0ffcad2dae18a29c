// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/cad_shape.h"
#include "kernel/curve.h"
#include "kernel/mesh.h"

#include <memory>

namespace tapeline {

/// Closest points on the exact faces and edges of a CAD model, in the numbering of `CadFaces`.
///
/// closest(face, p): the nearest triangle of the face's tessellation gives a first (u, v); Newton steps on
/// |S(u,v) - p|² take it to rounding; where they fail, OpenCASCADE's own projection. A foot outside the trimmed face
/// is replaced by the closest point of the face's border. Everything is built once and only read afterwards, and
/// surfaces are evaluated without OpenCASCADE's caching adaptors, so all members are safe from several threads.
class ExactSurface final : public SurfaceProjector {
public:
    /// `faces` must have been triangulated (io/tessellation.h); `model` is the mesh made of them, whose triangles say
    /// which side of each face is outside.
    ExactSurface(const CadFaces& faces, const Model& model);
    ~ExactSurface() override;

    int face_count() const override;
    std::optional<SurfaceFoot> closest(int cad_face, const Vec3& p) const override;
    std::optional<Vec3> closest_on_edge(int cad_edge, const Vec3& p) const override;

private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

} // namespace tapeline
