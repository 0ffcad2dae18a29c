// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/placing.h"

#include "plugin/runner/guard.h"
#include "plugin/runner/runner.h"

namespace tapeline {

Result<Placing> place_prepared(const Job& job, Preparation preparation)
{
    const MoveOptions options = move_options(job);
    return correspond(preparation.model, preparation.line, preparation.target->line, options.correspondence)
        .map([&](Correspondence correspondence) {
            Placing placing;
            placing.correspondence = std::move(correspondence);
            const Correspondence& c = placing.correspondence;
            const Mesh& mesh = preparation.model.mesh;
            PlacementResult& placement = placing.placement;
            placement = decide_placement(mesh, preparation.region, c);
            placement.verdict = options.placement.value_or(placement.verdict);
            placement.compressed = options.compressed_side.value_or(placement.compressed);
            if (placement.verdict == Placement::on_surface) {
                const auto sides = sides_of_line(mesh, preparation.region.faces, c.line.vertices, c.line.closed);
                placing.parts =
                    strained_parts(mesh, sides, c.line.vertices, c.line.closed, c.displacements, placement.compressed);
            } else {
                placing.parts.tension = preparation.region.faces;
            }
            placing.preparation = std::move(preparation);
            return placing;
        });
}

Result<Placing> place_job(const Job& job, const JobInputs& inputs, const Progress& progress)
{
    Stopwatch watch;
    return guarded([&] {
        return prepare(job, watch, progress, inputs).and_then([&](Preparation preparation) {
            return place_prepared(job, std::move(preparation));
        });
    });
}

} // namespace tapeline
