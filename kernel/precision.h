// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

namespace tapeline {

/// Size of the rounding that the coordinates have been through [mm], read off the coordinates themselves: 2^-24 of the
/// largest when all are float32 values (binary STL, also by way of text), half a unit of the last digit when all are decimal numbers of at most
/// nine significant digits (text files), otherwise a double's rounding, 2^-53 of the largest. Meshes on so coarse a
/// grid that it cannot be rounding (a cube of whole numbers) count as exact. method.md G3.
double coordinate_precision(const Positions& V);

} // namespace tapeline
