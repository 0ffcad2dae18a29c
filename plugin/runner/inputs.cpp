// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/inputs.h"

#include "plugin/runner/line_refinement.h"
#include "plugin/runner/preparation.h"
#include "plugin/runner/sha256.h"
#include "plugin/runner/vertex_list.h"

#include <fmt/format.h>

namespace tapeline {

std::vector<int> HeldLine::chain() const
{
    std::vector<int> vertices = line.vertices;
    if (line.closed) {
        vertices.push_back(vertices.front());
    }
    return vertices;
}

Result<std::shared_ptr<const HeldModel>> hold_model(const std::filesystem::path& path, const ImportSettings& settings,
                                                    const Progress& progress)
{
    if (!progress.report(0, "import")) {
        return fail(ErrorKind::cancelled, "cancelled");
    }
    auto held = std::make_shared<HeldModel>();
    held->path = path;
    held->settings = settings;
    return read_model(path, import_options(settings))
        .and_then([&](ImportedModel imported) {
            held->imported = std::move(imported);
            return file_sha256(path);
        })
        .and_then([&](std::string sum) -> Result<std::shared_ptr<const HeldModel>> {
            held->sha256 = std::move(sum);
            if (!progress.report(1, "import")) {
                return fail(ErrorKind::cancelled, "cancelled");
            }
            return std::move(held);
        });
}

Result<std::shared_ptr<const HeldModel>> hold_mesh(Mesh mesh, const ImportSettings& settings)
{
    return take_mesh("the arrays", std::move(mesh), import_options(settings)).map([&](ImportedModel imported) {
        auto held = std::make_shared<HeldModel>();
        held->imported = std::move(imported);
        held->settings = settings;
        return std::shared_ptr<const HeldModel>(std::move(held));
    });
}

std::vector<HeldLine> held_lines(const HeldModel& model, const LineSettings& settings)
{
    std::vector<HeldLine> held;
    for (FeatureLine& line : find_feature_lines(model.imported.model, line_options(settings))) {
        LineSettings own = settings;
        own.line.text = std::to_string(line.id);
        held.push_back({std::move(line), std::move(own)});
    }
    return held;
}

Result<HeldLine> held_chain(const HeldModel& model, std::vector<int> vertices, const LineSettings& settings)
{
    const auto count = model.imported.model.mesh.V.rows();
    for (const int v : vertices) {
        if (v < 0 || v >= count) {
            return fail(ErrorKind::rejected,
                        fmt::format("vertex {} of the line does not exist; the model has {} vertices", v, count));
        }
    }
    return line_through(model.imported.model, std::move(vertices)).map([&](FeatureLine line) {
        LineSettings own = settings;
        own.line.text.clear();
        return HeldLine{std::move(line), std::move(own)};
    });
}

Result<HeldLine> held_part(const HeldModel& model, const HeldLine& line, const std::string& from, const std::string& to,
                           const RemeshSettings& remesh)
{
    if (line.settings.line.empty() || line.settings.line.text.find('@') != std::string::npos) {
        return fail(ErrorKind::usage,
                    "a part can be taken of a whole feature line, not of a part or a chain of vertices");
    }
    const std::string selector = fmt::format("{}@{}..{}", line.settings.line.text, from, to);
    HeldLine part{{}, line.settings};
    part.settings.line.text = selector;
    return refine_before_choice(model.imported.model, line.line, remesh)
        .and_then([&](std::optional<RefinedLine> refined) {
            std::vector<FeatureLine> lines(static_cast<std::size_t>(line.line.id) + 1);
            lines.back() = refined ? refined->line : line.line;
            if (refined) {
                part.refined = std::make_shared<const Model>(std::move(refined->model));
            }
            return select_line(part.refined ? *part.refined : model.imported.model, lines, selector);
        })
        .map([&](FeatureLine chosen) {
            part.line = std::move(chosen);
            return std::move(part);
        });
}

JobInputs use_held(Job& job, std::shared_ptr<const HeldModel> model, const HeldLine& line,
                   std::optional<TargetLine> target)
{
    job.input = model->path;
    job.import = model->settings;
    job.lines = line.settings;
    JobInputs inputs;
    inputs.model = std::move(model);
    inputs.target = std::move(target);
    if (line.settings.line.empty()) {
        inputs.line = line.chain();
    }
    return inputs;
}

} // namespace tapeline
