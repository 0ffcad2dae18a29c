// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/shapes.h"

#include <functional>
#include <vector>

namespace tapeline::testing {

/// A mesh whose border is fixed and whose line is displaced: what a deformation solver is given.
struct Pull {
    Mesh mesh;
    std::vector<int> constrained;
    Positions targets; ///< one row per entry of `constrained`

    /// `line` runs from border to border; its inner vertices go where `place` says.
    Pull(Mesh panel, const std::vector<int>& line, const std::function<Vec3(const Vec3&)>& place);

    /// The same constrained vertices sent to the rows of `V`.
    Positions sent_to(const Positions& V) const;
};

/// The crease panel with its crease lifted by up to 60 mm, a tension problem with one minimum.
Pull off_surface_pull(int nx, int ny, Diagonals diagonals = Diagonals::alternating);

/// The crease panel with its crease slid along the surface by up to `slide`.
Pull crease_slide_pull(int nx, int ny, double slide, Diagonals diagonals = Diagonals::alternating);

double largest_difference(const Positions& A, const Positions& B);

} // namespace tapeline::testing
