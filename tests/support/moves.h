// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension.h"
#include "kernel/feature_lines.h"
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

} // namespace tapeline::testing
