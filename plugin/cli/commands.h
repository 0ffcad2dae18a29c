// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/cli/command_line.h"
#include "plugin/cli/console.h"

namespace tapeline {

/// Carries out one invocation: results to `console`. A missed quality gate comes back as the failure it is, after the
/// results were printed.
Result<void> run_invocation(const Invocation& invocation, Console& console);

} // namespace tapeline
