// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/extension.h"

#include <vector>

namespace tapeline {

/// Share h(s / length) of the end displacement that is left at arc length s beyond the line's end: a cubic Hermite
/// blend from 1 with the given slope dh/ds at 0 to 0 with slope 0 at `length`, the slope limited to [-3 / length, 0] so
/// that the blend falls monotonically and neither over- nor undershoots (Fritsch & Carlson 1980; method.md A4).
double taper(double s, double length, double slope);

/// Gives `extended.targets` (one per vertex of the line): the used part's targets from the correspondence, beyond its
/// ends the tapered displacement or NaN by the options. Fixed rim vertices keep their place exactly. `rest` is the
/// model before the cut, `faces` its region, on which targets are laid. Rejected when the end displacement runs along
/// the extension farther than there is room before the rim.
Result<void> set_targets(ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                         const Correspondence& correspondence, const ExtensionOptions& options);

} // namespace tapeline
