// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/preparation_memory.h"

namespace tapeline {

std::shared_ptr<const std::vector<FeatureLine>> PreparationMemory::lines() const
{
    const std::lock_guard lock(mutex_);
    return lines_;
}

void PreparationMemory::keep_lines(std::vector<FeatureLine> lines)
{
    const std::lock_guard lock(mutex_);
    lines_ = std::make_shared<std::vector<FeatureLine>>(std::move(lines));
}

std::shared_ptr<const Remeshed> PreparationMemory::remeshed(const std::vector<int>& faces, double max_edge) const
{
    const std::lock_guard lock(mutex_);
    return remeshed_ && max_edge == max_edge_ && faces == faces_ ? remeshed_ : nullptr;
}

void PreparationMemory::keep_remeshed(std::vector<int> faces, double max_edge, Remeshed remeshed)
{
    const std::lock_guard lock(mutex_);
    faces_ = std::move(faces);
    max_edge_ = max_edge;
    remeshed_ = std::make_shared<Remeshed>(std::move(remeshed));
}

} // namespace tapeline
