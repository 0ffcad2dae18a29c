// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/plate.h"
#include "tests/support/shapes.h"

#include <functional>

namespace tapeline::testing {

/// Constrains every vertex for which `held` is true to where `where` puts it.
PlateSupport holding(const Mesh& mesh, const std::function<bool(const Vec3&)>& held,
                     const std::function<Vec3(const Vec3&)>& where);

/// A flat strip, 150 mm wide and 300 mm long in y from its clamped end at y = 0 (a row of cells beyond it is held) to its
/// other end, where all vertices are pulled by `u`; there it is clamped too (a row beyond it is pulled as well), or free
/// to tilt. n cells over the length.
struct PlateStrip {
    Mesh mesh;
    PlateSupport support;
    PlateStrip(int n, bool clamped, const Vec3& u, Diagonals diagonals);
    /// Largest distance of the bent strip to rest + share(y / 300) u [mm].
    double error(const Positions& V, const std::function<double(double)>& share, const Vec3& u) const;
};

} // namespace tapeline::testing
