// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/check.h"

#include "io/model_file.h"
#include "io/target_file.h"
#include "kernel/exact_sheet.h"
#include "kernel/parallel.h"
#include "kernel/placement.h"
#include "kernel/strip.h"
#include "plugin/runner/guard.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/line_sides.h"
#include "plugin/runner/move_record.h"
#include "plugin/runner/preparation.h"
#include "plugin/runner/rest_match.h"
#include "plugin/runner/target_choice.h"
#include "plugin/runner/vertex_list.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

/// Distance of each point from a model's surface: its CAD faces where it has them, else its triangles [mm].
std::vector<double> distances_to(const Model& model, const Positions& V)
{
    std::vector<int> all(model.mesh.F.rows());
    std::iota(all.begin(), all.end(), 0);
    const std::optional<ExactSheet> exact =
        model.surface ? std::optional<ExactSheet>(std::in_place, model, all) : std::nullopt;
    const std::optional<ClosestPoint> triangles =
        exact ? std::nullopt : std::optional<ClosestPoint>(std::in_place, model.mesh);
    std::vector<double> distance(V.rows());
    parallel_for(static_cast<int>(V.rows()), [&](int v) {
        const Vec3 p = V.row(v);
        const SheetFoot foot = exact ? exact->foot(p) : SheetFoot{triangles->closest(p), {}};
        distance[v] = foot.exact ? (foot.exact->point - p).norm() : foot.triangle.distance;
    });
    return distance;
}

/// The steps of a check; each returns whether it worked and leaves its part in the members.
class Checker {
public:
    Checker(const Job& job, const Progress& progress, const CheckInputs& inputs)
        : job_(job), progress_(progress), inputs_(inputs)
    {
    }

    Result<void> read()
    {
        return report(0, "import")
            .and_then([&] { return take_model(after_, inputs_.after, job_.input); })
            .and_then([&] { return take_model(before_, inputs_.before, job_.command.against); })
            .and_then([&] { return read_record(); })
            .and_then([&] { return read_target_line(); });
    }

    void match()
    {
        const RestMatch match = match_rest(after_->model.mesh, before_->model.mesh, record_.appended);
        outcome_.match = match.how;
        outcome_.measures.has_rest = match.found;
        if (match.found) {
            const Triangles& before = before_->model.mesh.F;
            const Triangles& after = after_->model.mesh.F;
            // The CAD data of the model before still fits where the triangles are the same.
            rest_ = before.rows() == after.rows() && before == after ? before_->model : Model{};
            rest_.mesh = Mesh{match.V, after_->model.mesh.F};
            cad_ = with_cad_faces(rest_.mesh, before_->model);
            find_moved_faces();
        }
    }

    Result<void> find_line()
    {
        if (!inputs_.line.empty()) {
            return use_vertices(inputs_.line, "the line");
        }
        if (!job_.command.line_vertices.empty()) {
            return read_vertex_list(job_.command.line_vertices).and_then([&](std::vector<int> vertices) {
                return use_vertices(std::move(vertices), job_.command.line_vertices.string());
            });
        }
        if (!record_.line.empty()) {
            return use_vertices(record_.line,
                                job_.command.stats.empty() ? "the statistics" : job_.command.stats.string());
        }
        if (!outcome_.measures.has_rest) {
            omit("no line is known (give --line-vertices FILE), so measures along it are left out");
            return {};
        }
        return choose_from_rest();
    }

    Result<void> measure()
    {
        if (!outcome_.measures.has_rest) {
            omit(outcome_.match + ", so only distances to the surface before are measured");
            measure_distances();
            measure_line_error();
            return {};
        }
        QualityInput input{rest_.mesh, after_->model.mesh.V, line_.vertices, line_.closed,
                           {},         moved_faces_,         nullptr,        9};
        input.target = target_ ? &*target_ : nullptr;
        input.cad = &cad_;
        if (!target_) {
            omit("no target is known (give --target FILE), so the line error is left out");
        }
        outcome_.measures.has_target = target_.has_value() && outcome_.measures.has_line;
        if (outcome_.measures.has_line) {
            find_sides(input);
        }
        return report(0.4, "quality").and_then([&] { return measure_quality(input); }).map([&](QualityReport report) {
            outcome_.measures.quality = std::move(report);
        });
    }

    CheckOutcome finish()
    {
        outcome_.line = line_.vertices;
        outcome_.gates = evaluate_gates(job_.gate, outcome_.measures);
        return std::move(outcome_);
    }

private:
    Result<void> report(double fraction, const char* stage)
    {
        return progress_.report(fraction, stage) ? Result<void>() : fail(ErrorKind::cancelled, "cancelled");
    }

    void omit(std::string reason) { outcome_.measures.omitted.push_back(std::move(reason)); }

    Result<void> take_model(std::shared_ptr<const ImportedModel>& place, const std::shared_ptr<const HeldModel>& held,
                            const std::filesystem::path& path) const
    {
        if (held) {
            place = std::shared_ptr<const ImportedModel>(held, &held->imported);
            return {};
        }
        return read_model(path, import_options(job_.import)).map([&](ImportedModel model) {
            place = std::make_shared<const ImportedModel>(std::move(model));
        });
    }

    Result<void> read_record()
    {
        if (inputs_.record) {
            record_ = *inputs_.record;
            return {};
        }
        if (job_.command.stats.empty()) {
            return {};
        }
        return read_move_record(job_.command.stats).map([&](MoveRecord record) { record_ = std::move(record); });
    }

    Result<void> read_target_line()
    {
        target_ = inputs_.target;
        if (job_.target.target.empty()) {
            return {};
        }
        return read_target(job_.target.target).map([&](TargetLine line) { target_ = std::move(line); });
    }

    /// Binary STL holds single precision, so vertices that stayed come back rounded.
    double still_tolerance() const
    {
        const bool coarse = after_->report.format == "STL binary" || before_->report.format == "STL binary";
        return coarse ? 1e-6 * bounding_diagonal(rest_.mesh.V) : 0;
    }

    void find_moved_faces()
    {
        const double tolerance = still_tolerance();
        const Positions& V = after_->model.mesh.V;
        const auto moved = [&](int v) { return (V.row(v) - rest_.mesh.V.row(v)).norm() > tolerance; };
        for (int t = 0; t < rest_.mesh.F.rows(); ++t) {
            if (moved(rest_.mesh.F(t, 0)) || moved(rest_.mesh.F(t, 1)) || moved(rest_.mesh.F(t, 2))) {
                moved_faces_.push_back(t);
            }
        }
        if (moved_faces_.empty()) {
            outcome_.warnings.emplace_back("no vertex has moved");
        }
    }

    Result<void> use_vertices(std::vector<int> vertices, const std::string& source)
    {
        const auto count = after_->model.mesh.V.rows();
        const auto unknown = std::ranges::find_if(vertices, [&](int v) { return v >= count; });
        if (unknown != vertices.end()) {
            return fail(ErrorKind::rejected,
                        fmt::format("{}: vertex {} does not exist; {} has {} vertices", source, *unknown,
                                    inputs_.after ? "the model" : job_.input.string(), count));
        }
        const bool closed = record_.closed && vertices == record_.line;
        if (closed) {
            vertices.push_back(vertices.front());
        }
        const Model& model = outcome_.measures.has_rest ? rest_ : after_->model;
        return line_through(model, std::move(vertices)).map([&](FeatureLine line) { take(std::move(line)); });
    }

    void take(FeatureLine line)
    {
        line_ = std::move(line);
        outcome_.measures.has_line = true;
    }

    double travel(const FeatureLine& line) const
    {
        double sum = 0;
        for (const int v : line.vertices) {
            sum += (after_->model.mesh.V.row(v) - rest_.mesh.V.row(v)).norm();
        }
        return sum;
    }

    Result<void> choose_from_rest()
    {
        const std::vector<FeatureLine> lines = find_feature_lines(rest_, line_options(job_.lines));
        if (!job_.lines.line.empty()) {
            return choose_line(rest_, lines, job_.lines.line).map([&](FeatureLine line) {
                take_used(std::move(line));
            });
        }
        const auto most = std::ranges::max_element(lines, {}, [&](const FeatureLine& l) { return travel(l); });
        if (most == lines.end() || travel(*most) == 0) {
            omit("no feature line moved (give --line-vertices FILE), so measures along it are left out");
            return {};
        }
        outcome_.warnings.push_back(
            fmt::format("no line is given: taking feature line {}, which moved most", most->id));
        take_used(*most);
        return {};
    }

    /// Of a whole feature line only the part that goes to the target counts.
    void take_used(FeatureLine line)
    {
        if (target_) {
            if (const auto map = correspond(rest_, line, *target_)) {
                line = map->line;
            }
        }
        take(std::move(line));
    }

    Correspondence displacements() const
    {
        Correspondence map;
        map.line = line_;
        map.before = line_.before;
        map.after = line_.after;
        for (const int v : line_.vertices) {
            map.targets.emplace_back(after_->model.mesh.V.row(v));
            map.displacements.emplace_back(after_->model.mesh.V.row(v) - rest_.mesh.V.row(v));
        }
        return map;
    }

    void find_sides(QualityInput& input)
    {
        std::string side = job_.move.compressed_side != "auto" ? job_.move.compressed_side : record_.compressed_side;
        if (side.empty()) {
            const Region region = region_of_faces(rest_, moved_faces_, false, {});
            const PlacementResult placed = decide_placement(rest_.mesh, region, displacements());
            side = placed.verdict == Placement::off_surface ? "none"
                   : placed.compressed == LineSide::left    ? "left"
                                                            : "right";
        }
        outcome_.compressed_side = side;
        if (side == "none") {
            omit("the line leaves the surface, so there is no compressed side and no bulge");
            return;
        }
        // The prolonged line separates the sides all the way to the rim.
        const bool extended =
            std::ranges::all_of(record_.extended_line, [&](int v) { return v >= 0 && v < rest_.mesh.V.rows(); });
        input.extended_line = extended ? record_.extended_line : std::vector<int>{};
        input.carried = record_.line.empty()
                            ? kept_strips(rest_.mesh, after_->model.mesh.V, line_.vertices, line_.closed)
                            : record_.carried;
        std::erase_if(input.carried, [&](int v) { return v < 0 || v >= rest_.mesh.V.rows(); });
        const Correspondence line = displacements();
        const auto sides = input.extended_line.empty()
                               ? sides_by_extension(rest_, moved_faces_, line)
                               : sides_of_line(rest_.mesh, moved_faces_, input.extended_line, line_.closed);
        StrainedParts parts = strained_parts(rest_.mesh, sides, line_.vertices, line_.closed, line.displacements,
                                             side == "left" ? LineSide::left : LineSide::right);
        input.compressed_faces = std::move(parts.compressed);
        input.tension_faces = std::move(parts.tension);
        outcome_.measures.has_compressed = !input.compressed_faces.empty();
    }

    void measure_distances()
    {
        const Positions& V = after_->model.mesh.V;
        const std::vector<double> distance = distances_to(before_->model, V);
        outcome_.measures.surface_distance_reference =
            before_->model.surface ? BulgeReference::exact : BulgeReference::triangles;
        double largest = 0, squares = 0;
        for (const double d : distance) {
            largest = std::max(largest, d);
            squares += d * d;
        }
        outcome_.measures.surface_distance_max_mm = largest;
        outcome_.measures.surface_distance_rms_mm =
            std::sqrt(squares / std::max<double>(1, static_cast<double>(V.rows())));
    }

    void measure_line_error()
    {
        if (!target_ || !outcome_.measures.has_line) {
            return;
        }
        QualityReport& q = outcome_.measures.quality;
        const std::vector<Vec3> points = line_points(after_->model.mesh, line_);
        for (std::size_t k = 0; k < points.size(); ++k) {
            q.line_error_max_mm = std::max(q.line_error_max_mm, target_->foot(points[k]).distance);
            if (k > 0) {
                const Vec3 middle = 0.5 * (points[k - 1] + points[k]);
                q.chord_error_max_mm = std::max(q.chord_error_max_mm, target_->foot(middle).distance);
            }
        }
        outcome_.measures.has_target = true;
    }

    const Job& job_;
    const Progress& progress_;
    const CheckInputs& inputs_;
    std::shared_ptr<const ImportedModel> after_, before_;
    MoveRecord record_;
    std::optional<TargetLine> target_;
    Model rest_;
    Model cad_; ///< rest_'s mesh with the CAD faces of the model before
    FeatureLine line_;
    std::vector<int> moved_faces_;
    CheckOutcome outcome_;
};

} // namespace

Result<CheckOutcome> check_result(const Job& job, const Progress& progress, const CheckInputs& inputs)
{
    return guarded([&]() -> Result<CheckOutcome> {
        Checker checker(job, progress, inputs);
        return checker.read()
            .and_then([&] {
                checker.match();
                return checker.find_line();
            })
            .and_then([&] { return checker.measure(); })
            .map([&] { return checker.finish(); });
    });
}

std::string check_json(const CheckOutcome& outcome)
{
    nlohmann::ordered_json json;
    json["match"] = outcome.match;
    json["line"] = {{"vertices", outcome.line}};
    json["compressed_side"] = outcome.compressed_side;
    json["measures"] = measures_json(outcome.measures);
    json["omitted"] = outcome.measures.omitted;
    json["gates"] = gates_json(outcome.gates);
    json["warnings"] = outcome.warnings;
    return json_text(json);
}

} // namespace tapeline
