// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says to right and wrong command lines, without moving anything.
#include "tests/plugin/run_command.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

const std::vector<std::string> commands = {"mesh", "lines", "target", "move", "check", "run", "compare"};

/// One line on standard error, nothing on standard output.
void expect_one_sentence(const CommandRun& run, int exit_code, const std::string& part)
{
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_NE(run.err.find("error: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

TEST(CommandLine, HasHelpWithAnExampleEverywhere)
{
    for (const std::string& command : commands) {
        const CommandRun run = run_tapeline({command, "--help"});
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_EQ(run.err, "");
        EXPECT_NE(run.out.find("Example:\n  tapeline " + command + " "), std::string::npos) << run.out;
        EXPECT_EQ(run_tapeline({command, "-h"}).out, run.out);
    }
    const CommandRun run = run_tapeline({"--help"});
    EXPECT_EQ(run.exit_code, 0);
    for (const std::string& command : commands) {
        EXPECT_NE(run.out.find("\n  " + command + " "), std::string::npos) << command;
    }
    EXPECT_NE(run.out.find("Example:"), std::string::npos);
}

TEST(CommandLine, KnowsTheFlagsThatAreNamedInItsHelp)
{
    const std::string help = run_tapeline({"move", "--help"}).out;
    for (const char* flag : {"--line", "--target", "--roi-distance", "--method", "--out", "--stats", "--report",
                             "--save-job", "--max-edge", "--threads", "--quiet", "--progress", "--free-borders"}) {
        EXPECT_NE(help.find(flag), std::string::npos) << flag;
    }
}

TEST(CommandLine, TellsItsVersion)
{
    const CommandRun run = run_tapeline({"--version"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_TRUE(run.out.starts_with("tapeline ")) << run.out;
    EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(run.out[9]))) << run.out;
}

TEST(CommandLine, ShowsItsHelpAsAnErrorWhenNothingIsAsked)
{
    const CommandRun run = run_tapeline({});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("Usage: tapeline COMMAND"), std::string::npos);
}

TEST(CommandLine, NamesTheNearestFlagOrCommandForAnUnknownOne)
{
    expect_one_sentence(run_tapeline({"lines", "x.obj", "--crease-angel", "3"}), 1, "did you mean --crease-angle?");
    expect_one_sentence(run_tapeline({"mvoe"}), 1, "did you mean move?");
    expect_one_sentence(run_tapeline({"lines", "x.obj", "y.obj"}), 1, "y.obj");
}

TEST(CommandLine, RefusesValuesThatAreMissingIllTypedOrOutOfRange)
{
    expect_one_sentence(run_tapeline({"lines"}), 1, "input");
    expect_one_sentence(run_tapeline({"lines", "x.obj", "--crease-angle"}), 1, "--crease-angle");
    expect_one_sentence(run_tapeline({"lines", "x.obj", "--crease-angle", "ten"}), 1,
                        "--crease-angle must be a number in deg, not string \"ten\"");
    expect_one_sentence(run_tapeline({"lines", "x.obj", "--crease-angle", "181"}), 1, "0.1 to 180");
    expect_one_sentence(run_tapeline({"move", "x.obj", "--line", "0", "-o", "y.obj", "--method", "arap-srx"}), 1,
                        "did you mean 'arap-sr'?");
    expect_one_sentence(run_tapeline({"move", "x.obj", "--line", "0", "--slide", "3"}), 1, "--out");
    expect_one_sentence(run_tapeline({"mesh", "x.obj", "--progress", "loud"}), 1, "--progress");
}

TEST(CommandLine, SaysWhichFileCannotBeRead)
{
    expect_one_sentence(run_tapeline({"mesh", "/no/such/model.step"}), 2, "/no/such/model.step");
    expect_one_sentence(run_tapeline({"lines", "/no/such/model.obj"}), 2, "/no/such/model.obj");
    expect_one_sentence(run_tapeline({"run", "/no/such/job.json"}), 2, "/no/such/job.json");
    expect_one_sentence(run_tapeline({"check", "/no/a.obj", "--against", "/no/b.obj"}), 2, "/no/a.obj");
}

TEST(CommandLine, RefusesOutputsItCannotNameBeforeItReadsAnything)
{
    const TemporaryFolder folder;
    write_panel(folder / "panel.obj", 8, 6);
    const std::string panel = (folder / "panel.obj").string();
    const std::string before = read_text(panel);
    expect_one_sentence(run_tapeline({"mesh", panel, "-o", (folder / "x.xyz").string()}), 1, "x.xyz");
    expect_one_sentence(run_tapeline({"mesh", panel, "-o", panel}), 1, "overwrite the input");
    expect_one_sentence(run_tapeline({"target", panel, "--line", "0", "-o", (folder / "t.obj").string()}), 1, "t.obj");
    expect_one_sentence(run_tapeline({"mesh", panel, "-o", folder.path().string()}), 1, folder.path().string());
    EXPECT_EQ(read_text(panel), before);
    EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"panel.obj"});
}

TEST(CommandLine, CountsLinesFromTheLongestAndPrintsThemAsJson)
{
    const TemporaryFolder folder;
    write_panel(folder / "panel.obj");
    const CommandRun run = run_tapeline({"lines", (folder / "panel.obj").string(), "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(json["lines"].size(), 1U);
    const auto& line = json["lines"][0];
    EXPECT_EQ(line["id"], 0);
    EXPECT_EQ(line["vertices"].size(), 41U);
    EXPECT_FALSE(line["closed"].get<bool>());
    EXPECT_NEAR(line["length_mm"].get<double>(), 800, 5);
    EXPECT_NEAR(line["crease_angle_mean"].get<double>(), 12, 1);
    for (const char* key : {"crease_angle_min", "crease_angle_max", "cad_edges"}) {
        EXPECT_TRUE(line.contains(key)) << key;
    }
}

TEST(CommandLine, SaysSoWhenThereIsNoSuchLine)
{
    const TemporaryFolder folder;
    write_panel(folder / "panel.obj", 16, 12);
    const std::string panel = (folder / "panel.obj").string();
    const std::string out = (folder / "t.json").string();
    expect_one_sentence(run_tapeline({"target", panel, "--line", "7", "-o", out}), 3, "7");
    expect_one_sentence(run_tapeline({"target", panel, "--line", "0@90%..10%", "-o", out}), 3, "backwards");
    expect_one_sentence(run_tapeline({"target", panel, "--line", "/no/chain.txt", "-o", out}), 2, "/no/chain.txt");
    EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"panel.obj"});
}

TEST(CommandLine, ReportsProgressAsJsonLinesThatNeverGoBack)
{
    const TemporaryFolder folder;
    write_panel(folder / "panel.obj", 16, 12);
    const CommandRun run = run_tapeline({"mesh", (folder / "panel.obj").string(), "--progress=json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    std::istringstream lines(run.err);
    double last = 0;
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        const auto step = nlohmann::json::parse(line);
        EXPECT_GE(step["fraction"].get<double>(), last);
        EXPECT_LE(step["fraction"].get<double>(), 1);
        EXPECT_FALSE(step["stage"].get<std::string>().empty());
        last = step["fraction"].get<double>();
    }
    EXPECT_GT(count, 0);
}

} // namespace
} // namespace tapeline::testing
