// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tapeline {

/// A number for people: three digits, or two behind zeros ("69.2", "0.78", "0.0037"); very small and large ones with an
/// exponent ("3.7e-4").
std::string short_number(double x);

} // namespace tapeline
