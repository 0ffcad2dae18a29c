// SPDX-License-Identifier: GPL-3.0-or-later
// Moves beside other feature lines, on models from elsewhere and on our bracket, through the program.
#include "tests/plugin/run_command.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace tapeline::testing
