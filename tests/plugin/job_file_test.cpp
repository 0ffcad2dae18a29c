// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/job_file.h"
#include "plugin/runner/option_value.h"
#include "tests/plugin/run_command.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tapeline::testing {
namespace {

/// The failure of a job text; "read" when it was taken.
std::string failure(const std::string& text)
{
    const auto job = parse_job(text, "job.json", "");
    return job ? "read" : job.error().message;
}

/// A value that the option takes and that is not its default.
nlohmann::json another_value(const Option& option)
{
    struct Other {
        const Option& option;
        nlohmann::json operator()(const bool*) const { return true; }
        nlohmann::json operator()(const int*) const { return 2; }
        nlohmann::json operator()(const double*) const
        {
            return std::isfinite(option.max) ? 0.3 * option.min + 0.7 * option.max : 0.625;
        }
        nlohmann::json operator()(const std::optional<double>*) const { return 0.125; }
        nlohmann::json operator()(const std::string*) const
        {
            return option.choices.empty() ? "words" : std::string(option.choices.back());
        }
        nlohmann::json operator()(const std::vector<std::string>*) const
        {
            return option.choices.empty() ? nlohmann::json{"a", "b"} : nlohmann::json{option.choices.back()};
        }
        nlohmann::json operator()(const std::filesystem::path*) const { return "/tmp/a/file"; }
        nlohmann::json operator()(const LineSelector*) const { return "3@10%..90%"; }
        nlohmann::json operator()(const std::vector<int>*) const { return {1, 2, 3}; }
        nlohmann::json operator()(const std::vector<double>*) const { return {1, 2, 3, 4, 5, 6.5}; }
        nlohmann::json operator()(const std::vector<std::filesystem::path>*) const { return {"/tmp/a", "/tmp/b"}; }
        nlohmann::json operator()(const std::vector<LineSelector>*) const { return {"1", "/tmp/c"}; }
    };
    Job job;
    return std::visit(Other{option}, option.slot(job));
}

TEST(JobFile, KeepsEveryOptionThroughWritingAndReading)
{
    Job job;
    for (const Option& option : option_table()) {
        if (option.in_job()) {
            const auto done = set_option(option, job, another_value(option), option.path());
            ASSERT_TRUE(done) << done.error().message;
            ASSERT_NE(option_json(option, job), option_default(option)) << option.path();
        }
    }
    const auto read = parse_job(job_text(job, "/tmp/folder"), "job.json", "/tmp/folder");
    ASSERT_TRUE(read) << read.error().message;
    for (const Option& option : option_table()) {
        if (option.in_job()) {
            EXPECT_EQ(option_json(option, *read), option_json(option, job)) << option.path();
        }
    }
}

TEST(JobFile, CountsRelativeNamesFromItsFolder)
{
    const auto job =
        parse_job(R"({"input": "../m.obj", "lines": {"line": "chain.txt"}, "outputs": {"out": ["x.obj", "/y.obj"]}})",
                  "job.json", "/jobs/here");
    ASSERT_TRUE(job);
    EXPECT_EQ(job->input, "/jobs/m.obj");
    EXPECT_EQ(job->lines.line.text, "/jobs/here/chain.txt");
    EXPECT_EQ(job->outputs.out[0], "/jobs/here/x.obj");
    EXPECT_EQ(job->outputs.out[1], "/y.obj");
}

TEST(JobFile, TakesASingleValueForAListAndANumberForALine)
{
    const auto job = parse_job(R"({"target": {"slide": 5}, "lines": {"line": 2}})", "job.json", "");
    ASSERT_TRUE(job);
    EXPECT_EQ(job->target.slide, std::vector<double>{5});
    EXPECT_EQ(job->lines.line.text, "2");
}

TEST(JobFile, NamesTheNearestKeyForAnUnknownOne)
{
    EXPECT_EQ(failure(R"({"move": {"retracton": "planes"}})"),
              "job.json: key 'move.retracton' is unknown; did you mean 'retraction'?");
    EXPECT_EQ(failure(R"({"inputs": "a.step"})"), "job.json: key 'inputs' is unknown; did you mean 'input'?");
    EXPECT_EQ(failure(R"({"gates": {}})"), "job.json: key 'gates' is unknown; did you mean 'gate'?");
    EXPECT_EQ(failure(R"({"move": {"slide": 3}})"),
              "job.json: key 'move.slide' is unknown; did you mean 'target.slide'?");
}

TEST(JobFile, SaysWhichTypeAKeyWants)
{
    EXPECT_EQ(failure(R"({"remesh": {"max_edge": "5"}})"),
              "job.json: key 'remesh.max_edge' must be a number in mm, not string \"5\"");
    EXPECT_EQ(failure(R"({"target": {"fair": 1}})"), "job.json: key 'target.fair' must be true or false, not number 1");
    EXPECT_EQ(failure(R"({"move": {"clamp_rings": 1.5}})"),
              "job.json: key 'move.clamp_rings' must be a whole number, not number 1.5");
    EXPECT_EQ(failure(R"({"target": {"slide": [1, "x"]}})"),
              "job.json: key 'target.slide' must be a list of numbers in mm, not array [1,\"x\"]");
    EXPECT_EQ(failure(R"({"move": 3})"),
              "job.json: key 'move' must be an object with keys such as 'method', not number");
    EXPECT_EQ(failure("[]"), "job.json: a job must be a JSON object, not array");
}

TEST(JobFile, SaysWhichRangeAndChoicesAKeyHas)
{
    EXPECT_EQ(failure(R"({"move": {"clamp_rings": 3}})"),
              "job.json: key 'move.clamp_rings' is 3 but must lie in 0 to 2");
    EXPECT_EQ(failure(R"({"remesh": {"max_edge": -1}})"),
              "job.json: key 'remesh.max_edge' is -1 but must be at least 0");
    EXPECT_EQ(failure(R"({"move": {"method": "asan-f"}})"),
              "job.json: key 'move.method' is 'asan-f' but must be one of plate-fl, asan-fl, asan-fl-paper, "
              "asan-fl-sequential, asan, arap, arap-sr, arap-n, sr-arap, lri; did you mean 'asan-fl'?");
    EXPECT_EQ(failure(R"({"region": {"roi_box": [1, 2]}})"),
              "job.json: key 'region.roi_box' must be a list of 6 numbers in mm, but 2 are given");
    EXPECT_NE(failure(R"({"move": {"max_iterations": 1e300}})"), "read");
}

TEST(JobFile, RefusesAKeyGivenTwice)
{
    EXPECT_EQ(failure(R"({"move": {"stiff": "along", "stiff": "across"}})"),
              "job.json: key 'stiff' is given twice; keep one");
    EXPECT_EQ(failure(R"({"move": {"stiff": "along"}, "target": {"fair": true}})"), "read");
}

TEST(JobFile, RefusesWhatIsNotJson)
{
    for (const std::string text : {"", "{", "{\"input\": }", "\xff\xfe{", "{\"input\": \"\xff\"}", "nonsense"}) {
        const auto job = parse_job(text, "job.json", "");
        ASSERT_FALSE(job) << text;
        EXPECT_EQ(job.error().kind, ErrorKind::unreadable);
        EXPECT_TRUE(job.error().message.starts_with("job.json: not a JSON file: ")) << job.error().message;
    }
    EXPECT_EQ(read_job("/no/such/job.json").error().kind, ErrorKind::unreadable);
}

TEST(JobFile, SurvivesDeepNestingAndLongKeys)
{
    EXPECT_NE(failure(std::string(100000, '[')), "read");
    EXPECT_LT(failure("{\"" + std::string(1000000, 'x') + "\": 1}").size(), 400U);
    EXPECT_LT(failure("{\"input\": [\"" + std::string(1000000, 'x') + "\"]}").size(), 400U);
}

} // namespace
} // namespace tapeline::testing
