// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/quality.h"
#include "plugin/runner/runner.h"

#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>

namespace tapeline {

/// What a preview shows.
struct EditorPreview {
    std::shared_ptr<const Mesh> rest; ///< the mesh that is shown, unmoved
    int mesh_number = 0;              ///< grows when `rest` becomes another mesh
    Positions V;                      ///< moved positions of its vertices
    std::vector<int> line;            ///< vertices of the moved line
    PlacementResult placement;
    StrainedParts parts;                ///< triangles of `rest`
    std::optional<QualityReport> strip; ///< `measure_strip`, or all numbers where `exact`; none where time was short
    int flipped = 0;                    ///< region triangles turned by more than 90 deg against rest
    bool exact = false;                 ///< this is the solved answer itself
    bool leaves_region = false;         ///< the target ends on or beyond the rim: solve, which chooses a new region
    double seconds = 0;
};

/// The measures that a preview has, under the keys of `measures_json`; null where there was no time.
nlohmann::ordered_json strip_json(const EditorPreview& preview);

/// Follows a target that is dragged about. Keeps what does not depend on the target: the model and its lines, the
/// remeshed surroundings as long as the same triangles are concerned, the region with the line's prolongation and a
/// factorised linear response per side (kernel/drag.h).
///
/// `solve` is `solve_job` on the same job and gives the same bytes; from then on previews start at its result. All members
/// may be called from several threads at once; a preview does not wait for a solve under way.
class Editor {
public:
    /// `inputs` holds model and line; its target is not used.
    Editor(Job job, JobInputs inputs);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    /// Prepares previews at rest with the region for this target, as the first preview would.
    Result<void> start(const TargetLine& target, const Progress& progress = {});

    /// An approximate result within about `budget_ms`: positions always, the measures as far as the time is enough for
    /// them by the last one's. The first preview prepares and takes longer. Fails as a move does.
    Result<EditorPreview> preview(const TargetLine& target, double budget_ms = 100, const Progress& progress = {});

    /// The exact result.
    Result<std::shared_ptr<const JobOutcome>> solve(const TargetLine& target, const Progress& progress = {});

    /// See job_saving.h.
    Result<void> save(const TargetLine& target, const std::filesystem::path& path,
                      const std::filesystem::path& target_path = {}) const;

    const Job& job() const { return job_; }
    JobInputs inputs_with(const TargetLine& target) const;

private:
    struct Base;
    struct Solved;
    struct State {
        std::shared_ptr<const Base> base;
        std::shared_ptr<const Solved> solved;
        double strip_seconds = 0; ///< what a strip takes, by the last one
    };

    State state() const;
    Result<std::shared_ptr<const Base>> started(const TargetLine& target, const Progress& progress);

    Job job_;
    JobInputs inputs_;
    mutable std::mutex mutex_; ///< of what follows
    State state_;
    int meshes_ = 0;
};

} // namespace tapeline
