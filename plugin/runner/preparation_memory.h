// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/runner/remeshing.h"

#include <memory>
#include <mutex>
#include <vector>

namespace tapeline {

/// Results that preparations of one model, line and options share while only the target changes: the feature lines, and
/// the remeshed model where the same triangles are to be remeshed again. What is remembered is what would be computed,
/// to the bit. Safe from several threads.
class PreparationMemory {
public:
    std::shared_ptr<const std::vector<FeatureLine>> lines() const;
    void keep_lines(std::vector<FeatureLine> lines);

    /// The model that remeshing these triangles to that edge length gave; null when it was another one.
    std::shared_ptr<const Remeshed> remeshed(const std::vector<int>& faces, double max_edge) const;
    void keep_remeshed(std::vector<int> faces, double max_edge, Remeshed remeshed);

private:
    mutable std::mutex mutex_;
    std::shared_ptr<const std::vector<FeatureLine>> lines_;
    std::vector<int> faces_;
    double max_edge_ = 0;
    std::shared_ptr<const Remeshed> remeshed_;
};

} // namespace tapeline
