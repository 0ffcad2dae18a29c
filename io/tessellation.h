// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/cad_shape.h"
#include "io/face_unfold.h"
#include "kernel/error.h"

#include <vector>

namespace tapeline {

/// Triangulates every face in place with OpenCASCADE (Delabella; absolute deflections: chord height in mm, angle in
/// degrees), with one subdivision of each CAD edge for all faces along it. One thread, so that equal input gives equal
/// triangles. Triangles that lie folded over in space are put right (io/face_unfold.h); their number comes back.
Result<Unfolded> triangulate_faces(const CadFaces& faces, double linear_deflection_mm, double angular_deflection);

/// Length of the diagonal of the box around all faces [mm].
double faces_diagonal(const CadFaces& faces);

/// Area of the exact faces, one by one [mm²].
std::vector<double> exact_areas(const CadFaces& faces);

} // namespace tapeline
