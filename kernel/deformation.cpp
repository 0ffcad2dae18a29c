// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/deformation.h"

#include "kernel/asan_system.h"

namespace tapeline {

Result<DeformationResult> deform(const Mesh& rest, const std::vector<int>& constrained, const Positions& targets,
                                 const DeformationOptions& options, const std::optional<Positions>& start,
                                 const Progress& progress)
{
    return make_and_iterate([&] { return AsanSystem::create(rest, constrained, options.material); }, targets, options,
                            start, progress);
}

} // namespace tapeline
