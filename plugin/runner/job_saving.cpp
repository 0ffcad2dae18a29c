// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/job_saving.h"

#include "io/target_file.h"
#include "plugin/runner/job_file.h"
#include "plugin/runner/job_outputs.h"
#include "plugin/runner/output_set.h"
#include "plugin/runner/preparation.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tapeline {

namespace {

std::string chain_text(const std::vector<int>& chain)
{
    std::string text;
    for (const int v : chain) {
        text += fmt::format("{}\n", v);
    }
    return text;
}

/// The double that gives `mm` back when a reader multiplies it by the unit's length; rounding may put it some units in
/// the last place off the quotient, or leave none.
std::optional<double> in_unit(double mm, double unit_mm)
{
    double below = mm / unit_mm, above = below;
    for (int k = 0; k < 4; ++k) {
        for (const double x : {below, above}) {
            if (x * unit_mm == mm) {
                return x;
            }
        }
        below = std::nextafter(below, -std::numeric_limits<double>::infinity());
        above = std::nextafter(above, std::numeric_limits<double>::infinity());
    }
    return std::nullopt;
}

/// A mesh as its file will hold it, in the unit.
Result<Mesh> mesh_in_unit(const Mesh& mesh, const std::string& unit)
{
    Mesh scaled = mesh;
    for (Eigen::Index k = 0; k < scaled.V.size(); ++k) {
        double& x = scaled.V.data()[k];
        const auto written = in_unit(x, unit_length_mm(unit));
        if (!written) {
            return fail(
                ErrorKind::rejected,
                fmt::format("the job cannot be saved: vertex {} at {:.17g} mm has no exact value in {}, so that "
                            "its file would give another model; take a model in mm",
                            k / 3, x, unit));
        }
        x = *written;
    }
    return scaled;
}

} // namespace

Result<void> save_job(Job job, const JobInputs& inputs, const std::filesystem::path& path,
                      const std::filesystem::path& target_path)
{
    namespace fs = std::filesystem;
    const auto beside = [&](const char* ending) { return fs::path(path).replace_extension(ending); };
    OutputSet outputs;
    if (inputs.target) {
        job.target.target = target_path.empty() ? beside(".target.json") : target_path;
        if (auto fine = check_target_name(job.target.target); !fine) {
            return fine;
        }
        outputs.add(job.target.target, [&](const fs::path& file) { return write_target(file, *inputs.target); });
    }
    if (!inputs.line.empty()) {
        job.lines.line.text = beside(".line.txt").string();
        outputs.add_text(job.lines.line.text, chain_text(inputs.line));
    }
    const fs::path read_from = job.input;
    if (inputs.model && inputs.model->path.empty()) {
        job.input = beside(".model.obj");
        auto mesh = mesh_in_unit(inputs.model->imported.model.mesh, job.import.units);
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        outputs.add(job.input, [mesh = std::move(*mesh)](const fs::path& file) { return write_mesh(file, mesh); });
    }
    if (job.outputs.out.empty()) {
        job.outputs.out = {beside(".obj")};
    }
    outputs.add_text(path, job_text(job, path.parent_path()));
    return outputs.check(read_from).and_then([&] { return outputs.commit(); });
}

} // namespace tapeline
