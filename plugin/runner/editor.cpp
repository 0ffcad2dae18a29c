// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/editor.h"

#include "kernel/drag.h"
#include "kernel/face_patch.h"
#include "kernel/feature_rails.h"
#include "kernel/move_steps.h"
#include "kernel/parallel.h"
#include "kernel/strip_meter.h"
#include "plugin/runner/guard.h"
#include "plugin/runner/job_saving.h"
#include "plugin/runner/placing.h"
#include "plugin/runner/preparation_memory.h"
#include "plugin/runner/threads.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>

namespace tapeline {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool same_curve(const TargetLine& a, const TargetLine& b)
{
    const BSplineData p = a.data(), q = b.data();
    return p.degree == q.degree && p.closed == q.closed && p.knots == q.knots && p.weights == q.weights &&
           p.control_points == q.control_points;
}

/// The stiff directions of the two ways of following, from the move that the start was prepared for.
void set_materials(DragStart& start, const MoveOptions& options, const std::vector<Vec3>& displacements)
{
    double ratio = options.stiffness_ratio;
    start.slide.stiff_direction = stiff_direction(displacements, ratio);
    start.slide.stiffness_ratio = ratio;
    start.plate = start.slide;
    start.plate.stiffness_ratio = std::min(ratio, plate_stiffness(options));
    if (options.retraction.value_or(method_info(options.method).retraction) != RetractionMode::harmonic) {
        start.extended.features.clear();
    }
    start.clamp_rings = options.clamp_rings;
    start.tilting = tilting_rim(start.extended.model, start.extended.region, options.rim, options.rim_crease_angle);
}

DragStart start_at_rest(const Placing& placing, const MoveOptions& options)
{
    const Preparation& p = placing.preparation;
    DragStart start;
    start.splits = method_info(options.method).splits;
    start.extended = unextended(p.model, p.region, placing.correspondence);
    if (start.splits) {
        const ExtensionOptions extension{options.extension_path, ExtensionTarget::tapered,
                                         placing.placement.verdict == Placement::on_surface};
        auto extended = extend_line(p.model, p.region, placing.correspondence, extension);
        // A move to this very target would fail; another one may not, and a whole region can show both.
        start.splits = extended.has_value();
        if (extended) {
            start.extended = std::move(*extended);
        }
    }
    start.V = start.extended.model.mesh.V;
    set_materials(start, options, placing.correspondence.displacements);
    return start;
}

DragStart start_at_result(const MoveResult& move, const MoveOptions& options)
{
    DragStart start;
    start.extended = unextended(move.rest, move.region, move.correspondence);
    start.V = move.V;
    start.splits = !move.right_faces.empty();
    if (start.splits) {
        start.extended.vertices = move.extended_line;
        const auto first = std::ranges::find(move.extended_line, move.correspondence.line.vertices.front());
        start.extended.first = static_cast<int>(first - move.extended_line.begin());
        start.extended.last += start.extended.first;
        std::ranges::set_union(other_feature_edges(move.rest, start.extended.vertices, start.extended.closed),
                               move.region.kept_edges, std::back_inserter(start.extended.features));
    }
    set_materials(start, options, move.correspondence.displacements);
    return start;
}

int count_flipped(const Mesh& rest, const Positions& V, const std::vector<int>& faces)
{
    std::vector<char> flipped(faces.size());
    const Mesh moved{V, {}};
    parallel_for(static_cast<int>(faces.size()), [&](int i) {
        const auto normal = [&](const Positions& X) {
            const Vec3 a = X.row(rest.F(faces[i], 0)), b = X.row(rest.F(faces[i], 1)), c = X.row(rest.F(faces[i], 2));
            return Vec3((b - a).cross(c - a));
        };
        flipped[i] = normal(rest.V).dot(normal(V)) < 0;
    });
    return static_cast<int>(std::ranges::count(flipped, 1));
}

} // namespace

/// What previews start from; never changed once made.
struct Editor::Base {
    Base(Drag made, FeatureLine feature_line) : drag(std::move(made)), line(std::move(feature_line))
    {
        const ExtendedLine& extended = drag.extended();
        rest = std::make_shared<Mesh>(extended.model.mesh);
        patch = patch_of_faces(*rest, extended.region.faces);
        Model region{std::move(patch.mesh), {}, {}, extended.model.surface};
        if (region.surface) {
            for (const int t : patch.to_face) {
                region.cad_face.push_back(extended.model.cad_face[t]);
            }
        }
        meter.emplace(std::move(region));
        sides = {drag.side_faces()[0], drag.side_faces()[1]};
        if (!drag.splits()) {
            sides = sides_of_line(*rest, extended.region.faces, extended.vertices, extended.closed);
        }
        local_vertex.assign(rest->V.rows(), -1);
        local_face.assign(rest->F.rows(), -1);
        for (std::size_t v = patch.to_vertex.size(); v-- > 0;) {
            local_vertex[patch.to_vertex[v]] = static_cast<int>(v);
        }
        for (std::size_t t = 0; t < patch.to_face.size(); ++t) {
            local_face[patch.to_face[t]] = static_cast<int>(t);
        }
    }

    /// A preview of a usual region takes some 20 ms of one processor. On a machine that has other work, waiting for
    /// helpers at every step takes longer than that.
    int threads() const
    {
        constexpr Eigen::Index alone = 25000; // vertices
        return meter->rest().V.rows() < alone ? 1 : 0;
    }

    Result<DragStep> step(const TargetLine& target, const MoveOptions& options) const
    {
        return on_threads(threads(), [&] {
            return drag.step(line, target, options.correspondence, options.placement, options.compressed_side);
        });
    }

    StrainedParts parts(const DragStep& step) const
    {
        if (step.placement.verdict == Placement::off_surface) {
            return {{}, drag.extended().region.faces};
        }
        const Correspondence& c = step.correspondence;
        return strained_parts(*rest, drag.topology(), sides, c.line.vertices, c.line.closed, c.displacements,
                              step.placement.compressed);
    }

    EditorPreview preview(DragStep step) const
    {
        EditorPreview made;
        made.rest = rest;
        made.mesh_number = mesh_number;
        made.parts = parts(step);
        made.V = std::move(step.V);
        made.line = std::move(step.correspondence.line.vertices);
        made.placement = step.placement;
        made.leaves_region = step.leaves_region;
        made.flipped =
            on_threads(threads(), [&] { return count_flipped(*rest, made.V, drag.extended().region.faces); });
        return made;
    }

    /// Measures on the region alone, since a model may be much larger. What cannot be measured is left out.
    void measure(EditorPreview& preview, const TargetCurve& target, bool closed) const
    {
        Positions moved(meter->rest().V.rows(), 3);
        for (std::size_t v = 0; v < patch.to_vertex.size(); ++v) {
            moved.row(static_cast<Eigen::Index>(v)) = preview.V.row(patch.to_vertex[v]);
        }
        const auto local = [](const std::vector<int>& list, const std::vector<int>& map) {
            std::vector<int> mapped;
            std::ranges::transform(list, std::back_inserter(mapped), [&](int i) { return map[i]; });
            std::erase(mapped, -1);
            return mapped;
        };
        QualityInput input{meter->rest(), moved, local(preview.line, local_vertex), closed, {}, {}, &target};
        input.compressed_faces = local(preview.parts.compressed, local_face);
        input.tension_faces = local(preview.parts.tension, local_face);
        if (const auto report = on_threads(threads(), [&] { return meter->measure(input); })) {
            preview.strip = *report;
        }
    }

    Drag drag;
    FeatureLine line; ///< on the model, as it was prepared
    int mesh_number = 0;
    std::shared_ptr<const Mesh> rest;
    FacePatch patch;                                     ///< the region, its mesh in `meter`
    std::optional<StripMeter> meter;                     ///< on it
    std::pair<std::vector<int>, std::vector<int>> sides; ///< region triangles left and right of the line
    std::vector<int> local_vertex, local_face;
};

struct Editor::Solved {
    TargetLine target;
    std::shared_ptr<const JobOutcome> outcome;

    EditorPreview preview() const
    {
        const MoveResult& move = outcome->move;
        const QualityInput input = quality_input(move, outcome->preparation.target->line);
        EditorPreview made;
        made.V = move.V;
        made.line = move.correspondence.line.vertices;
        made.placement = move.placement;
        made.parts = {input.compressed_faces, input.tension_faces};
        made.strip = outcome->measures.quality;
        made.flipped = outcome->measures.quality.flipped;
        made.exact = true;
        return made;
    }
};

Editor::Editor(Job job, JobInputs inputs) : job_(std::move(job)), inputs_(std::move(inputs))
{
    inputs_.target.reset();
    inputs_.memory = std::make_shared<PreparationMemory>();
}

Editor::~Editor() = default;

JobInputs Editor::inputs_with(const TargetLine& target) const
{
    JobInputs inputs = inputs_;
    inputs.target = target;
    return inputs;
}

Editor::State Editor::state() const
{
    const std::lock_guard lock(mutex_);
    return state_;
}

Result<void> Editor::start(const TargetLine& target, const Progress& progress)
{
    return guarded([&] { return started(target, progress).map([](const auto&) {}); });
}

Result<std::shared_ptr<const Editor::Base>> Editor::started(const TargetLine& target, const Progress& progress)
{
    return place_job(job_, inputs_with(target), progress)
        .and_then([&](const Placing& placing) {
            FeatureLine line = placing.preparation.line;
            return Drag::create(start_at_rest(placing, move_options(job_))).map([&](Drag drag) {
                return std::make_shared<Base>(std::move(drag), std::move(line));
            });
        })
        .map([&](const std::shared_ptr<Base>& made) -> std::shared_ptr<const Base> {
            const std::lock_guard lock(mutex_);
            made->mesh_number = ++meshes_;
            state_.base = made;
            state_.solved.reset();
            return made;
        });
}

Result<std::shared_ptr<const JobOutcome>> Editor::solve(const TargetLine& target, const Progress& progress)
{
    return solve_job(job_, inputs_with(target), progress).map([&](JobOutcome solved) {
        auto outcome = std::make_shared<const JobOutcome>(std::move(solved));
        auto drag = guarded([&] { return Drag::create(start_at_result(outcome->move, move_options(job_))); });
        if (drag) {
            auto made = std::make_shared<Base>(std::move(*drag), outcome->preparation.line);
            const std::lock_guard lock(mutex_);
            made->mesh_number = ++meshes_;
            state_.base = std::move(made);
            state_.solved = std::make_shared<Solved>(Solved{target, outcome});
        }
        return outcome;
    });
}

Result<EditorPreview> Editor::preview(const TargetLine& target, double budget_ms, const Progress& progress)
{
    const auto begin = Clock::now();
    return guarded([&]() -> Result<EditorPreview> {
               State from = state();
               if (!from.base) {
                   auto made = started(target, progress);
                   if (!made) {
                       return tl::unexpected(made.error());
                   }
                   from.base = std::move(*made);
               }
               if (from.solved && same_curve(from.solved->target, target)) {
                   EditorPreview made = from.solved->preview();
                   made.rest = from.base->rest;
                   made.mesh_number = from.base->mesh_number;
                   return made;
               }
               return from.base->step(target, move_options(job_)).map([&](DragStep step) {
                   const bool closed = step.correspondence.line.closed;
                   EditorPreview made = from.base->preview(std::move(step));
                   const auto measuring = Clock::now();
                   const bool in_time = seconds_since(begin) + from.strip_seconds <= 1e-3 * budget_ms;
                   if (in_time) {
                       from.base->measure(made, target, closed);
                   }
                   const std::lock_guard lock(mutex_);
                   // A strip that once took long, on a busy machine say, is tried again in the end.
                   state_.strip_seconds = in_time ? seconds_since(measuring) : 0.8 * from.strip_seconds;
                   return made;
               });
           })
        .map([&](EditorPreview made) {
            made.seconds = seconds_since(begin);
            return made;
        });
}

Result<void> Editor::save(const TargetLine& target, const std::filesystem::path& path,
                          const std::filesystem::path& target_path) const
{
    return guarded([&] { return save_job(job_, inputs_with(target), path, target_path); });
}

nlohmann::ordered_json strip_json(const EditorPreview& preview)
{
    Measures measures;
    measures.quality = preview.strip.value_or(QualityReport{});
    measures.has_line = measures.has_target = measures.has_rest = preview.strip.has_value();
    measures.has_compressed = preview.strip.has_value() && !preview.parts.compressed.empty();
    const nlohmann::ordered_json all = measures_json(measures);
    nlohmann::ordered_json strip;
    for (const char* key : {"line_error_max_mm", "chord_error_max_mm", "slide_max_mm", "bulge", "sections", "crease"}) {
        strip[key] = all[key];
    }
    strip["flipped"] = preview.flipped;
    return strip;
}

} // namespace tapeline
