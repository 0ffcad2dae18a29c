// SPDX-License-Identifier: GPL-3.0-or-later
// Every method of the table through the program, and what it says when two starts do not agree.
#include "kernel/method.h"
#include "tests/plugin/run_command.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

using nlohmann::json;

class Methods : public ::testing::Test {
protected:
    void SetUp() override { write_panel(folder_ / "panel.obj", 40, 30); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    CommandRun slide(const std::string& mm, std::vector<std::string> more) const
    {
        std::vector<std::string> all = {
            "move", file("panel.obj"), "--line",  "0@25%..75%",      "--slide", mm, "--quiet", "--roi-distance", "280",
            "-o",   file("moved.obj"), "--stats", file("stats.json")};
        all.insert(all.end(), more.begin(), more.end());
        return run_tapeline(all);
    }
    json stats() const { return json::parse(read_text(file("stats.json"))); }

    TemporaryFolder folder_;
};

TEST_F(Methods, AllMoveTheLineAndSayHow)
{
    for (const MethodInfo& info : method_table()) {
        const std::string name(info.name);
        const CommandRun run = slide("0,20,0", {"--method", name, "--check-unique", "--allow-ambiguous"});
        ASSERT_EQ(run.exit_code, 0) << name << ": " << run.err;
        EXPECT_NE(run.out.find("method"), std::string::npos);
        const json s = stats();
        EXPECT_EQ(s["method"], name);
        const json solver = s["quality"]["solver"];
        EXPECT_EQ(solver["method"], name);
        EXPECT_GE(solver["iterations"].get<int>(), 1);
        EXPECT_LT(solver["error_estimate_mm"].get<double>(), 0.1) << name;
        EXPECT_EQ(solver["uniqueness_mm"], s["uniqueness"]["distance_mm"]);
        EXPECT_EQ(s["retraction"]["applied"].get<bool>(), info.splits) << name;
        // One run a part; the band that keeps the tangent plane at the rim comes on top.
        const auto solves = std::ranges::count_if(s["solve"], [](const auto& part) { return part["side"] != "rim"; });
        EXPECT_EQ(solves, info.splits ? 2 : 1) << name;
        EXPECT_LT(s["quality"]["line_error_max_mm"].get<double>(), 1e-9) << name;
    }
}

TEST_F(Methods, AreAllNamedInTheHelp)
{
    const CommandRun help = run_tapeline({"move", "--help"});
    for (const MethodInfo& info : method_table()) {
        EXPECT_NE(help.out.find("\n  " + std::string(info.name) + " "), std::string::npos) << info.name;
        EXPECT_EQ(method_named(info.name), info.method);
        EXPECT_EQ(&method_info(info.method), &info);
        EXPECT_FALSE(info.title.ends_with("."));
    }
    EXPECT_FALSE(method_named("asan-f"));
}

TEST_F(Methods, EndWithExitCodeFourWhenTheResultIsAmbiguous)
{
    const CommandRun refused = slide("0,8.8,30,51.2,60,51.2,30,8.8,0", {"--method", "arap-sr", "--check-unique"});
    EXPECT_EQ(refused.exit_code, 4) << refused.err;
    EXPECT_NE(refused.err.find("ambiguous"), std::string::npos) << refused.err;
    EXPECT_EQ(files_in(folder_.path()), std::vector<std::string>{"panel.obj"});
    const CommandRun allowed =
        slide("0,8.8,30,51.2,60,51.2,30,8.8,0", {"--method", "arap-sr", "--check-unique", "--allow-ambiguous"});
    EXPECT_EQ(allowed.exit_code, 0) << allowed.err;
    EXPECT_NE(allowed.out.find("ambiguous"), std::string::npos) << allowed.out;
    EXPECT_TRUE(stats()["uniqueness"]["ambiguous"].get<bool>());
    // Not asked, not judged.
    EXPECT_EQ(slide("0,8.8,30,51.2,60,51.2,30,8.8,0", {"--method", "arap-sr"}).exit_code, 0);
    EXPECT_TRUE(stats()["uniqueness"].is_null());
}

} // namespace
} // namespace tapeline::testing
