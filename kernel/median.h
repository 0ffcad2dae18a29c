// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tapeline {

/// The middle one of the values, of which there is at least one (the upper of two).
double median(std::vector<double> values);

} // namespace tapeline
