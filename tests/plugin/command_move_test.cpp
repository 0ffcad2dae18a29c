// SPDX-License-Identifier: GPL-3.0-or-later
// Moves through the program, from files to files, on the crease panel: a part of its line slides across the surface.
#include "tests/plugin/run_command.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

using nlohmann::json;

/// The panel and the arguments that slide the middle half of its line by up to 40 mm.
class CommandMove : public ::testing::Test {
protected:
    void SetUp() override { write_panel(folder_ / "panel.obj"); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    std::vector<std::string> move(std::vector<std::string> more = {}) const
    {
        std::vector<std::string> all = {"move",   file("panel.obj"), "--line", "0@25%..75%", "--slide",
                                        "0,40,0", "--roi-distance",  "250",    "-o",         file("moved.obj")};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    json stats() const { return json::parse(read_text(file("stats.json"))); }

    TemporaryFolder folder_;
};

TEST_F(CommandMove, WritesEverythingThatIsAskedFor)
{
    const CommandRun run =
        run_tapeline(move({"-o", file("moved.stl"), "--rest", file("rest.obj"), "--stats", file("stats.json"),
                           "--line-vertices", file("line.txt"), "--save-target", file("target.json"), "--pictures",
                           file("pictures"), "--report", file("report.html"), "--quiet"}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    for (const char* row :
         {"verdict", "compressed side", "bulge", "inflections", "crease angle", "line error", "seconds"}) {
        EXPECT_NE(run.out.find(row), std::string::npos) << row;
    }
    EXPECT_EQ(files_in(folder_.path()),
              (std::vector<std::string>{"line.txt", "moved.obj", "moved.stl", "panel.obj", "pictures/after_closeup.png",
                                        "pictures/after_curvature.png", "pictures/after_shaded.png",
                                        "pictures/after_zebra.png", "pictures/before_closeup.png",
                                        "pictures/before_curvature.png", "pictures/before_shaded.png",
                                        "pictures/before_zebra.png", "pictures/sections.png", "report.html", "rest.obj",
                                        "stats.json", "target.json"}));
    EXPECT_TRUE(read_text(file("pictures/sections.png")).starts_with("\x89PNG"));
}

TEST_F(CommandMove, GivesStatisticsWithStableKeys)
{
    ASSERT_EQ(run_tapeline(move({"--stats", file("stats.json"), "--quiet"})).exit_code, 0);
    const json s = stats();
    for (const char* pointer : {"/tool_version",
                                "/input/path",
                                "/input/sha256",
                                "/input/units",
                                "/input/vertices",
                                "/input/faces",
                                "/line/id",
                                "/line/vertices",
                                "/line/length_mm",
                                "/line/crease_angle_mean",
                                "/region/vertices",
                                "/region/faces",
                                "/region/fixed",
                                "/placement/verdict",
                                "/placement/off_fraction",
                                "/placement/compressed_side",
                                "/placement/s_alpha",
                                "/placement/s_beta",
                                "/extension/mode",
                                "/extension/added_vertices",
                                "/retraction/mode",
                                "/retraction/min_area_ratio",
                                "/retraction/flipped",
                                "/solve/0/side",
                                "/solve/0/iterations",
                                "/solve/0/error_estimate_mm",
                                "/solve/0/seconds",
                                "/solve/0/energy",
                                "/crease/applied",
                                "/crease/before",
                                "/crease/after",
                                "/quality/bulge/max_mm",
                                "/quality/line_error_max_mm",
                                "/seconds/import"}) {
        EXPECT_TRUE(s.contains(json::json_pointer(pointer))) << pointer;
    }
    EXPECT_EQ(s["input"]["sha256"].get<std::string>().size(), 64U);
    EXPECT_EQ(s["placement"]["verdict"], "on_surface");
}

TEST_F(CommandMove, PassesItsOwnCheck)
{
    ASSERT_EQ(run_tapeline(move({"--rest", file("rest.obj"), "--stats", file("stats.json"), "--save-target",
                                 file("target.json"), "--line-vertices", file("line.txt"), "--quiet"}))
                  .exit_code,
              0);
    const std::vector<std::vector<std::string>> ways = {
        {"--against", file("rest.obj"), "--stats", file("stats.json")},
        {"--against", file("panel.obj"), "--stats", file("stats.json")},
        {"--against", file("rest.obj"), "--line-vertices", file("line.txt")},
        {"--against", file("rest.obj"), "--line", "0"}};
    const json from_move = stats()["quality"];
    for (std::vector<std::string> arguments : ways) {
        arguments.insert(arguments.begin(), {"check", file("moved.obj")});
        arguments.insert(arguments.end(), {"--target", file("target.json"), "--json", "-", "--quiet"});
        const CommandRun run = run_tapeline(arguments);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const json measures = json::parse(run.out)["measures"];
        // The same mesh, line and target give the same numbers, whoever tells the line.
        EXPECT_NEAR(measures["line_error_max_mm"].get<double>(), from_move["line_error_max_mm"].get<double>(), 1e-9);
        EXPECT_NEAR(measures["slide_max_mm"].get<double>(), from_move["slide_max_mm"].get<double>(), 1e-9);
        EXPECT_NEAR(measures["squash"].get<double>(), from_move["squash"].get<double>(), 1e-6);
        EXPECT_NEAR(measures["bulge"]["max_mm"].get<double>(), from_move["bulge"]["max_mm"].get<double>(), 1e-3);
    }
}

TEST_F(CommandMove, MissesAGateWithExitCodeFiveAndNamesIt)
{
    const CommandRun run = run_tapeline(move({"--min-squash", "0.999", "--max-flipped", "0", "--quiet"}));
    EXPECT_EQ(run.exit_code, 5);
    EXPECT_NE(run.err.find("min_squash is "), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("max_flipped"), std::string::npos) << run.err;
    EXPECT_NE(run.out.find("verdict"), std::string::npos);
    EXPECT_EQ(files_in(folder_.path()).size(), 2U) << "the result is written for people to look at";
}

TEST_F(CommandMove, TouchesNothingWhenTheSolverDoesNotConverge)
{
    const CommandRun run =
        run_tapeline(move({"--max-iterations", "1", "--solver-tolerance", "1e-12", "--stats", file("s.json")}));
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_NE(run.err.find("did not converge"), std::string::npos) << run.err;
    EXPECT_EQ(files_in(folder_.path()), std::vector<std::string>{"panel.obj"});
    EXPECT_EQ(
        run_tapeline(move({"--max-iterations", "1", "--solver-tolerance", "1e-12", "--allow-unconverged", "--quiet"}))
            .exit_code,
        0);
}

TEST_F(CommandMove, TouchesNothingWhenOneOutputCannotBeWritten)
{
    std::filesystem::create_directory(folder_ / "taken.json");
    std::filesystem::create_directory(folder_ / "taken.json" / "x");
    const CommandRun wrong = run_tapeline(move({"--stats", file("panel.obj/stats.json"), "--quiet"}));
    EXPECT_EQ(wrong.exit_code, 2) << wrong.err;
    EXPECT_EQ(files_in(folder_.path()), std::vector<std::string>{"panel.obj"});
    EXPECT_EQ(run_tapeline(move({"--stats", file("taken.json")})).exit_code, 1);
}

TEST_F(CommandMove, RepeatsItselfFromTheJobItSaves)
{
    ASSERT_EQ(run_tapeline(move({"--save-job", file("job.json"), "--stiffness-ratio", "50", "--quiet"})).exit_code, 0);
    const std::string first = read_text(file("moved.obj"));
    std::filesystem::remove(file("moved.obj"));
    const CommandRun run = run_tapeline({"run", file("job.json"), "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_FALSE(first.empty());
    EXPECT_TRUE(first == read_text(file("moved.obj")));
}

TEST_F(CommandMove, GivesTheSameBytesForOneAndTwoThreads)
{
    std::vector<std::string> results;
    for (const char* threads : {"1", "2", "2"}) {
        ASSERT_EQ(run_tapeline(move({"--threads", threads, "--quiet"})).exit_code, 0);
        results.push_back(read_text(file("moved.obj")));
        EXPECT_GT(results.back().size(), 1000U);
    }
    EXPECT_TRUE(results[0] == results[1]);
    EXPECT_TRUE(results[1] == results[2]);
}

TEST_F(CommandMove, GivesTheSameResultForATargetMadeBefore)
{
    ASSERT_EQ(run_tapeline({"target", file("panel.obj"), "--line", "0@25%..75%", "--slide", "0,40,0", "-o",
                            file("target.json"), "--quiet"})
                  .exit_code,
              0);
    ASSERT_EQ(run_tapeline(move({"--quiet"})).exit_code, 0);
    const std::string direct = read_text(file("moved.obj"));
    ASSERT_EQ(run_tapeline({"move", file("panel.obj"), "--line", "0@25%..75%", "--target", file("target.json"),
                            "--roi-distance", "250", "-o", file("moved.obj"), "--quiet"})
                  .exit_code,
              0);
    EXPECT_TRUE(direct == read_text(file("moved.obj")));
}

TEST_F(CommandMove, StopsWithExitCode130WhenInterrupted)
{
    const CommandRun run = run_tapeline(move({"--progress=json"}), "\"stage\":\"lines\"");
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_EQ(files_in(folder_.path()), std::vector<std::string>{"panel.obj"});
}

TEST_F(CommandMove, AsksForAGoal)
{
    const CommandRun run = run_tapeline({"move", file("panel.obj"), "--line", "0", "-o", file("moved.obj")});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("--slide"), std::string::npos) << run.err;
}

} // namespace
} // namespace tapeline::testing
