// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <filesystem>
#include <vector>

namespace tapeline::testing {

/// A cube of side 2 around the origin, n × n cells on every face: 12 right-angled edges of n mesh edges each.
Mesh cube(int n);

/// A closed cylinder (radius, height along z, from z = 0): the wall has `segments` flat strips of `rings` cells each, so
/// it bends by 360 / segments degrees along every vertical mesh edge; the caps are fans around their centres.
/// Vertex (ring j, segment i) has index j * segments + i; the cap centres come last.
Mesh cylinder(int segments, int rings, double radius, double height);

/// A sphere of radius 1 with `slices` meridians and slices / 2 - 1 circles between the poles.
Mesh ball(int slices);

/// A cone without base around -z, apex angle 2 * half_angle [rad], from slant height 0.1 to 2.1; vertex (ring j,
/// segment i) has index j * segments + i.
Mesh cone(int segments, int rings, double half_angle);

/// The same surface with vertices, triangles and the triangles' first corners in another order. `new_index` receives the
/// new index per old vertex.
Mesh renumbered(const Mesh& mesh, unsigned seed, std::vector<int>* new_index = nullptr);

/// Reads a plain OFF file of triangles; an empty mesh when it cannot.
Mesh plain_off(const std::filesystem::path& path);
/// Reads a binary or ASCII STL and joins bit-equal corners; an empty mesh when it cannot.
Mesh plain_stl(const std::filesystem::path& path);

} // namespace tapeline::testing
