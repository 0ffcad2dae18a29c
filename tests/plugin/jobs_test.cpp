// SPDX-License-Identifier: GPL-3.0-or-later
// The jobs in resources/jobs, on our own STEP models: each ends well and keeps the limits that stand in it.
#include "plugin/runner/job_file.h"
#include "tests/plugin/run_command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

namespace fs = std::filesystem;

class OurJobs : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override
    {
        const auto job = read_job(fs::path(TAPELINE_SOURCE_DIR) / "resources" / "jobs" / GetParam());
        ASSERT_TRUE(job) << job.error().message;
        job_ = *job;
        asked_ = job_.outputs;
        job_.outputs = {};
        job_.outputs.out = {folder_ / "moved.obj"};
        job_.outputs.rest = folder_ / "rest.obj";
        job_.outputs.stats = folder_ / "stats.json";
        job_.outputs.save_target = folder_ / "target.json";
    }

    std::string file(const char* name) const { return (folder_ / name).string(); }

    Job job_;
    OutputSettings asked_;
    TemporaryFolder folder_;
};

TEST_P(OurJobs, KeepTheirLimitsAndPassTheSameOnesInCheck)
{
    const auto& gate = job_.gate;
    ASSERT_TRUE(gate.min_squash && gate.max_flipped && gate.max_line_error);
    folder_.write("job.json", job_text(job_, folder_.path()));
    const CommandRun run = run_tapeline({"run", file("job.json"), "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
    const auto stats = nlohmann::json::parse(read_text(folder_ / "stats.json"));
    EXPECT_LE(stats["quality"]["rim_crease"]["mean_change"].get<double>(), 0.5);
    EXPECT_LE(stats["quality"]["rim_crease"]["max_change"].get<double>(), 1.5);
    // Only one of the models has a bend beside its line; nothing is taken for one elsewhere.
    const auto& strip = stats["strip"];
    EXPECT_EQ(strip["class"], GetParam() == std::string("fillet_strip.json") ? "left" : "none") << strip["message"];
    std::vector<std::string> words = {"check",    file("moved.obj"),   "--against", file("rest.obj"),
                                      "--target", file("target.json"), "--quiet"};
    const auto limit = [&](const char* flag, const std::optional<double>& value) {
        if (value) {
            words.insert(words.end(), {flag, fmt::format("{}", *value)});
        }
    };
    limit("--max-bulge", gate.max_bulge);
    limit("--max-inflections", gate.max_inflections);
    limit("--max-turning-increase", gate.max_turning_increase);
    limit("--min-squash", gate.min_squash);
    limit("--max-flipped", gate.max_flipped);
    limit("--max-line-error", gate.max_line_error);
    limit("--max-crease-change", gate.max_crease_change);
    // Without statistics the line and the sides are found again, and are the same.
    std::vector<nlohmann::json> bulges;
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--stats", file("stats.json")}, {}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), more.begin(), more.end());
        all.insert(all.end(), {"--json", file("check.json")});
        const CommandRun check = run_tapeline(all);
        EXPECT_EQ(check.exit_code, 0) << check.err << check.out;
        bulges.push_back(nlohmann::json::parse(read_text(folder_ / "check.json"))["measures"]["bulge"]);
    }
    ASSERT_EQ(bulges[0].is_null(), bulges[1].is_null());
    if (!bulges[0].is_null()) {
        EXPECT_NEAR(bulges[0]["max_mm"].get<double>(), bulges[1]["max_mm"].get<double>(), 1e-3);
        EXPECT_NEAR(bulges[0]["rms_mm"].get<double>(), bulges[1]["rms_mm"].get<double>(), 1e-3);
    }
}

TEST_P(OurJobs, WriteResultsStatisticsAndPicturesOutsideTheSources)
{
    EXPECT_EQ(asked_.out.size(), 2U);
    for (const fs::path& path : {asked_.out.at(0), asked_.stats, asked_.pictures}) {
        EXPECT_NE(path.string().find("/build/demo/"), std::string::npos) << path;
    }
}

/// The jobs whose line slides to one side on the surface keep the limits that such a move can keep.
class OurSlides : public OurJobs {};

TEST_P(OurSlides, AskForNoBulgeNoInflectionAndNoSquashedTriangle)
{
    EXPECT_EQ(job_.gate.max_bulge, 0.1);
    EXPECT_EQ(job_.gate.max_inflections, 0);
    EXPECT_EQ(job_.gate.max_turning_increase, 1);
    EXPECT_EQ(job_.gate.min_squash, 0.6);
    EXPECT_EQ(job_.gate.max_flipped, 0);
    EXPECT_EQ(job_.gate.max_line_error, 1e-9);
}

constexpr auto stem = [](const auto& job) { return fs::path(job.param).stem().string(); };

INSTANTIATE_TEST_SUITE_P(Job, OurSlides,
                         ::testing::Values("hood.json", "panel.json", "wheel_arch.json", "pawn.json", "bracket.json",
                                           "hood_open_end.json", "fillet_strip.json"),
                         stem);
INSTANTIATE_TEST_SUITE_P(Job, OurJobs,
                         ::testing::Values("hood.json", "panel.json", "wheel_arch.json", "pawn.json", "bracket.json",
                                           "hood_above.json", "hood_pull.json", "hood_zigzag.json",
                                           "hood_open_end.json", "door.json", "fillet_strip.json"),
                         stem);

} // namespace
} // namespace tapeline::testing
