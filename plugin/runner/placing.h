// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/placement.h"
#include "kernel/quality.h"
#include "plugin/runner/preparation.h"

namespace tapeline {

/// What a job would move, before anything is solved.
struct Placing {
    Preparation preparation;
    Correspondence correspondence; ///< on preparation.model
    PlacementResult placement;     ///< with what the job overrules
    StrainedParts parts;           ///< region triangles under compression (none off the surface) and under tension
};

/// Prepares the job and decides on or off surface and the compressed side, as a move does first.
Result<Placing> place_job(const Job& job, const JobInputs& inputs, const Progress& progress = {});

/// The same on a preparation that is there.
Result<Placing> place_prepared(const Job& job, Preparation preparation);

} // namespace tapeline
