// SPDX-License-Identifier: GPL-3.0-or-later
// Files that nobody should have written: the program reads or refuses them in one sentence, and never dies.
#include "tests/plugin/run_command.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tapeline::testing {
namespace {

/// Runs `tapeline mesh` on a file; it must read it, or refuse it by name in one line with exit 2 or 3 and no output.
void expect_read_or_refused(const std::filesystem::path& file)
{
    const TemporaryFolder folder;
    const std::string out = (folder / "out.obj").string();
    const CommandRun run = run_tapeline({"mesh", file.string(), "-o", out, "--quiet"});
    SCOPED_TRACE(file.filename().string() + ": exit " + std::to_string(run.exit_code) + ", " + run.err);
    ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 2 || run.exit_code == 3);
    if (run.exit_code == 0) {
        EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"out.obj"});
        return;
    }
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1);
    EXPECT_NE(run.err.find(file.filename().string()), std::string::npos);
    EXPECT_TRUE(files_in(folder.path()).empty());
}

TEST(BadInput, OfOthersIsReadOrRefusedInOneSentence)
{
    const auto data = data_folder();
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*data / "nasty")) {
        expect_read_or_refused(entry.path());
        ++files;
    }
    EXPECT_GT(files, 10);
}

TEST(BadInput, OfOurOwnIsRefusedInOneSentence)
{
    const TemporaryFolder folder;
    const std::vector<std::pair<const char*, std::string>> files = {
        {"empty.obj", ""},
        {"blank.stl", "   \n\n"},
        {"prose.step", "Dear reader, this is no model."},
        {"cut.step", "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('x'),'2;1');\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT("},
        {"few.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
        {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"infinite.off", "OFF\n3 1 0\n0 0 0\n1e999 0 0\n0 1 0\n3 0 1 2\n"},
        {"many.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"},
        {"many.ply", "ply\nformat ascii 1.0\nelement vertex 900000000\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"},
        {"short.stl", std::string(80, ' ') + std::string("\xff\xff\xff\x7f", 4) + std::string(20, 'x')},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"}};
    for (const auto& [name, content] : files) {
        const auto file = folder.write(name, content);
        const CommandRun run = run_tapeline({"mesh", file.string(), "--quiet"});
        EXPECT_TRUE(run.exit_code == 2 || run.exit_code == 3) << name << ": " << run.exit_code << " " << run.out;
        EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
        EXPECT_NE(run.err.find(name), std::string::npos) << run.err;
    }
}

/// A move of the panel's whole line with a target that cannot be reached.
class BadTarget : public ::testing::Test {
protected:
    void SetUp() override { write_panel(folder_ / "panel.obj", 40, 30); }

    CommandRun move_to(const std::string& csv, std::vector<std::string> more = {}) const
    {
        const std::string target = folder_.write("target.csv", csv).string();
        std::vector<std::string> arguments = {
            "move", (folder_ / "panel.obj").string(), "--line", "0", "--target", target,
            "-o",   (folder_ / "out.obj").string(),   "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tapeline(arguments);
    }
    void expect_refused(const CommandRun& run) const
    {
        EXPECT_TRUE(run.exit_code == 2 || run.exit_code == 3) << run.exit_code << " " << run.err;
        EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.obj"));
    }

    TemporaryFolder folder_;
};

TEST_F(BadTarget, IsRefusedWhenItIsNoLine)
{
    expect_refused(move_to(""));
    expect_refused(move_to("x,y,z\n"));
    expect_refused(move_to("x,y,z\n0,0,0\n"));
    expect_refused(move_to("x,y,z\n0,0,0\n1,nan,0\n2,0,0\n"));
    expect_refused(move_to("a,b,c\n0,0,0\n1,0,0\n2,0,0\n"));
}

TEST_F(BadTarget, IsRefusedWhenItLiesFartherAwayThanTheRegionIsWide)
{
    expect_refused(move_to("x,y,z\n-200,5000,0\n0,5000,0\n200,5000,0\n", {"--roi-distance", "150"}));
}

TEST_F(BadTarget, IsRefusedWhenItCrossesTheRim)
{
    expect_refused(
        move_to("x,y,z\n-200,0,-8\n-100,200,-30\n0,290,-45\n100,200,-30\n200,0,-8\n", {"--roi-distance", "150"}));
}

TEST(BadJob, IsRefusedBeforeAnythingIsRead)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& text, int exit_code, const std::string& part) {
        const CommandRun run = run_tapeline({"run", folder.write("job.json", text).string()});
        EXPECT_EQ(run.exit_code, exit_code) << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
        EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    };
    refused("{", 2, "job.json: not a JSON file");
    refused("{}", 1, "key 'input' is missing");
    refused(R"({"input": "x.obj"})", 1, "outputs.out");
    refused(R"({"input": "x.obj", "outputs": {"out": "y.obj"}})", 1, "no goal");
    refused(R"({"input": "x.obj", "outputs": {"out": "y.obj"}, "target": {"slide": 3}})", 1, "lines.line");
    refused(R"({"input": "x.obj", "move": {"methd": 3}})", 1, "did you mean 'method'?");
}

} // namespace
} // namespace tapeline::testing
