// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

std::string short_number(double x)
{
    if (x == 0) {
        return "0";
    }
    const double size = std::abs(x);
    if (size >= 1e-3 && size < 1e6) {
        const int magnitude = static_cast<int>(std::floor(std::log10(size)));
        return fmt::format("{:.{}f}", x, std::max(0, magnitude < 0 ? 1 - magnitude : 2 - magnitude));
    }
    std::string text = fmt::format("{:.1e}", x);
    if (const std::size_t at = text.find("e-0"); at != std::string::npos) {
        text.erase(at + 2, 1);
    }
    return text;
}

} // namespace tapeline
