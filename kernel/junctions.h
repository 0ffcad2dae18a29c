// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/correspondence.h"
#include "kernel/error.h"
#include "kernel/extension.h"
#include "kernel/face_patch.h"

#include <vector>

namespace tapeline {

/// Where the moving line meets other feature lines (`features`, edges, ascending), it takes the junction along: the
/// vertex they share slides along that one of them that runs the way of the displacement. Its target becomes the point of
/// that line nearest to Lt prolonged beyond its end, as far as that lies within half a displacement of the old target;
/// otherwise the target stays as it is (the displacement then leads off all lines there).
/// The correction fades out along the used line over ten times its size, or up to half-way to the next junction; vertices
/// in between are laid back on Lt where it reaches. So the line still lies on Lt, but for what has to be added where Lt
/// ends before the junction's line.
/// Rejected when the way along the other line is longer than 85 % of the piece up to that line's end or next corner.
Result<void> carry_junctions(const Mesh& mesh, const std::vector<VertexPair>& features, const TargetCurve& target,
                             Correspondence& correspondence);

/// The same for the vertices of the extension, which have no curve: targets within half a displacement of a line that
/// leaves there are laid on it.
Result<void> carry_extension(ExtendedLine& extended);

} // namespace tapeline
