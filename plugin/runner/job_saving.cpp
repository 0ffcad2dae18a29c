// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/job_saving.h"

#include "io/target_file.h"
#include "plugin/runner/job_file.h"
#include "plugin/runner/job_outputs.h"
#include "plugin/runner/output_set.h"

#include <fmt/format.h>

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
        job.import.units = "mm";
        outputs.add(job.input,
                    [&](const fs::path& file) { return write_mesh(file, inputs.model->imported.model.mesh); });
    }
    if (job.outputs.out.empty()) {
        job.outputs.out = {beside(".obj")};
    }
    outputs.add_text(path, job_text(job, path.parent_path()));
    return outputs.check(read_from).and_then([&] { return outputs.commit(); });
}

} // namespace tapeline
