// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/raster.h"
#include "kernel/topology.h"

/// Inside of io/picture: how a surface looks.
namespace tapeline::picture {

/// Normals to shade with: row 3 t + k belongs to corner k of triangle t. A mean over the triangles around the corner that
/// are reached without crossing an edge that is marked sharp, in which needles and caps count little.
Positions corner_normals(const Mesh& mesh, const Topology& topology, const std::vector<char>& sharp);

/// Marks per edge of `topology`: open borders, edges of at least `crease_angle` [deg], edges of the `lines`, and edges
/// that go on from those for as long as they stand out from the surface beside them: a crease that fades away.
std::vector<char> sharp_edges(const Mesh& mesh, const Topology& topology, double crease_angle,
                              const std::vector<std::vector<int>>& lines);

/// Angle of the reflected ray about the light tubes' axis [deg], for a normal in the picture's axes.
double reflection_angle(const Vec3& normal);

/// The shader of `options.shading`. `normals` (of the corners) in the picture's axes. Keeps references to
/// `mesh` and `normals`.
Shader make_shader(const Mesh& mesh, const Positions& normals, const PictureOptions& options);

/// Colour of signed_map at value / range in [-1, 1], in sRGB.
Colour map_colour(double fraction);
/// Colours of curvature_sign, in sRGB.
Colour sign_colour(double value);

} // namespace tapeline::picture
