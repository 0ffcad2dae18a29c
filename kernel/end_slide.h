// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/extension_target.h"

#include <array>

namespace tapeline {

/// How far each end of the line slid along Lt [mm], first and last: positive towards the line's middle, giving up the last
/// piece of Lt to a longer prolongation; negative outwards.
using EndSlide = std::array<double, 2>;

/// Lets the ends of the moved line slide along Lt by at most `length_mm` (Section 7 of the paper), each to where line and
/// prolongation together turn least evenly out of their course: to the least
///
///     Σ_k |e_k - e_{k-1}|² / h,    e = unit direction of a chord after the move - the same at rest,
///
/// the sum over even chords, h long at rest (three of the line's edges), of the prolongation and of the part of the line
/// that the slide may shift. A constant slide of a curved line counts as even. The shift of the line's vertices along Lt fades out over six
/// times its size, so that edges keep two thirds of their length; an end slides by a sixth of Lt's used length at most,
/// outwards up to the end of Lt. An end without a prolongation, at a junction with another feature line, or whose sum does
/// not fall by a tenth, stays to the bit.
///
/// Changes `correspondence` (parameters, targets, displacements, tangents) and `extended.targets`. Arguments as for
/// `set_targets`, with which it fails; not for loops and free prolongations, which it leaves as they are.
Result<EndSlide> slide_ends(ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                            const TargetCurve& target, const ExtensionOptions& options, double length_mm,
                            Correspondence& correspondence);

} // namespace tapeline
