// SPDX-License-Identifier: GPL-3.0-or-later
// Moves beside other feature lines, on models from elsewhere and on our bracket, through the program.
#include "tests/plugin/run_command.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

/// A move of one of a model's lines with limits for squash and flips.
struct Slide {
    const char* name;
    const char* model;
    const char* line;
    const char* slide;
    const char* min_squash;
};
void PrintTo(const Slide& slide, std::ostream* out) { *out << slide.name; }

class SlideBesideLines : public ::testing::TestWithParam<Slide> {};

TEST_P(SlideBesideLines, FoldsAndCrushesNothing)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const Slide& slide = GetParam();
    const TemporaryFolder folder;
    const CommandRun run = run_tapeline({"move", (*data / "models" / slide.model).string(), "--line", slide.line,
                                         std::string("--slide=") + slide.slide, "-o", (folder / "moved.obj").string(),
                                         "--min-squash", slide.min_squash, "--max-flipped", "0", "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
}

INSTANTIATE_TEST_SUITE_P(
    Models, SlideBesideLines,
    ::testing::Values(Slide{"FandiskLineOfManyJunctions", "fandisk_pmp.off", "0", "0,0.1,0", "0.6"},
                      Slide{"FandiskTheOtherWay", "fandisk_pmp.off", "0", "0,-0.1,0", "0.5"},
                      Slide{"FandiskCornerToCorner", "fandisk_pmp.off", "1", "-0.1,-0.1,-0.1", "0.5"},
                      Slide{"FandiskCornerToCornerOnTheNarrowSide", "fandisk_pmp.off", "1", "0.06,0.06,0.06", "0.5"},
                      Slide{"RookCircle", "rook.stl", "3", "0.25", "0.6"},
                      Slide{"RookCircleTheOtherWay", "rook.stl", "3", "-0.25", "0.6"}),
    [](const auto& slide) { return slide.param.name; });

TEST(SlideToACorner, RefusesAnEndThatWouldSlidePastTheNeighbouringLine)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const TemporaryFolder folder;
    const CommandRun run =
        run_tapeline({"move", (*data / "models" / "fandisk_pmp.off").string(), "--line", "1", "--slide",
                      "0.21,0.21,0.21", "--roi-distance", "0.3", "-o", (folder / "moved.obj").string()});
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("along another feature line that ends or turns after 0.1828 mm"), std::string::npos)
        << run.err;
    EXPECT_TRUE(files_in(folder.path()).empty());
}

/// A move of the bracket's edge with more of the program's words.
CommandRun move_bracket(const TemporaryFolder& folder, const std::vector<std::string>& more)
{
    std::vector<std::string> words = {"move",       TAPELINE_SOURCE_DIR "/resources/models/bracket.step",
                                      "--line",     "2@15%..85%",
                                      "--slide",    "0,4,0",
                                      "--max-edge", "4",
                                      "-o",         (folder / "moved.obj").string(),
                                      "--stats",    (folder / "stats.json").string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_tapeline(words);
}

nlohmann::json stats_in(const TemporaryFolder& folder)
{
    return nlohmann::json::parse(read_text(folder / "stats.json"));
}

TEST(InnerLinesOfAJob, AreReportedAndHeldWhereAsked)
{
    const TemporaryFolder folder;
    const CommandRun free = move_bracket(folder, {"--roi-distance", "45"});
    ASSERT_EQ(free.exit_code, 0) << free.err;
    const nlohmann::json lines = stats_in(folder)["inner_lines"];
    ASSERT_FALSE(lines.empty());
    const auto sliding = std::ranges::find_if(lines, [](const auto& line) { return line["role"] == "slides"; });
    ASSERT_NE(sliding, lines.end()) << lines.dump(1);
    EXPECT_GE((*sliding)["id"], 0);
    EXPECT_LT((*sliding)["off_line_mm"], 1e-3) << sliding->dump();
    EXPECT_LT((*sliding)["crease_change_max"], 1) << sliding->dump();

    const std::string id = std::to_string((*sliding)["id"].get<int>());
    const CommandRun held = move_bracket(folder, {"--roi-distance", "45", "--hold", id});
    ASSERT_EQ(held.exit_code, 0) << held.err;
    bool found = false;
    const nlohmann::json after = stats_in(folder)["inner_lines"];
    for (const auto& line : after) {
        if (line["id"] == (*sliding)["id"]) {
            found = true;
            EXPECT_EQ(line["role"], "held");
            EXPECT_EQ(line["off_line_mm"], 0);
        }
    }
    EXPECT_TRUE(found);
}

TEST(InnerLinesOfAJob, RefuseLinesThatAreNotThereAndTheLineThatMoves)
{
    const TemporaryFolder folder;
    for (const char* flag : {"--keep", "--hold"}) {
        const CommandRun unknown = move_bracket(folder, {flag, "999"});
        EXPECT_EQ(unknown.exit_code, 3) << unknown.err;
        EXPECT_NE(unknown.err.find("999"), std::string::npos) << unknown.err;
        const CommandRun own = move_bracket(folder, {flag, "2"});
        EXPECT_EQ(own.exit_code, 1) << own.err;
        EXPECT_NE(own.err.find(std::string(flag) + " names line 2, which is the line that moves"), std::string::npos)
            << own.err;
    }
    EXPECT_TRUE(files_in(folder.path()).empty());
}

TEST(InnerLinesOfAJob, OfTheFandiskStayInTheirPlaceWhereTheSurfaceMakesRoom)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const TemporaryFolder folder;
    const CommandRun run =
        run_tapeline({"move", (*data / "models" / "fandisk_pmp.off").string(), "--line", "0", "--slide", "0,0.1,0",
                      "--quiet", "-o", (folder / "moved.obj").string(), "--stats", (folder / "stats.json").string()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    int sliding = 0;
    const nlohmann::json lines = stats_in(folder)["inner_lines"];
    for (const auto& line : lines) {
        EXPECT_GE(line["id"], 0) << line.dump();
        if (line["role"] == "slides") {
            ++sliding;
            // A thousandth of the slide.
            EXPECT_LT(line["off_line_mm"], 1e-4) << line.dump();
        }
    }
    EXPECT_GT(sliding, 0);
}

TEST(InnerLinesOfAJob, AreKeptOnTheDoorAndTheComparisonSaysWhoLosesThem)
{
    const TemporaryFolder folder;
    nlohmann::json job = nlohmann::json::parse(read_text(TAPELINE_SOURCE_DIR "/resources/jobs/door.json"));
    job.erase("$schema");
    job.erase("outputs");
    job["input"] = TAPELINE_SOURCE_DIR "/resources/models/door.step";
    job["remesh"] = {{"max_edge", 25}};
    folder.write("job.json", job.dump());
    const CommandRun run = run_tapeline({"compare", (folder / "job.json").string(), "-o", (folder / "out").string(),
                                         "--methods", "plate-fl,asan-fl-paper", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto result = nlohmann::json::parse(read_text(folder / "out/compare.json"));
    int stayed = 0;
    for (const auto& line : result["methods"][0]["inner_lines"]) {
        EXPECT_NEAR(line["crease_after"].get<double>(), line["crease_before"].get<double>(), 0.5) << line.dump();
        if (line["role"] == "slides") {
            ++stayed;
            EXPECT_LT(line["off_line_mm"], 0.05) << line.dump();
        }
    }
    EXPECT_EQ(stayed, 2) << "the upper line, and the seam above the line that moves";
    double worst = 0; // the published method drags them along
    for (const auto& line : result["methods"][1]["inner_lines"]) {
        worst = std::max(worst, std::abs(line["crease_after"].get<double>() - line["crease_before"].get<double>()));
    }
    EXPECT_GT(worst, 2);
    EXPECT_NE(read_text(folder / "out/compare.html").find("Other lines"), std::string::npos);
}

} // namespace
} // namespace tapeline::testing
