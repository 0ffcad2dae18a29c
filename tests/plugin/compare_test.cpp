// SPDX-License-Identifier: GPL-3.0-or-later
// `tapeline compare` on a coarse crease panel, from the job file to everything that it writes.
#include "kernel/method.h"
#include "tests/plugin/run_command.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>

namespace tapeline::testing {
namespace {

using nlohmann::json;

/// A job on the panel, whose middle half of the crease slides by up to 80 mm.
json panel_job()
{
    return {{"description", "a <b>bold</b> slide & \"more\""},
            {"input", "<i>panel'.obj"},
            {"lines", {{"line", "0@25%..75%"}}},
            {"target", {{"slide", {0, 40, 80, 40, 0}}}},
            {"outputs", {{"out", "single.obj"}, {"stats", "single.json"}}},
            {"gate", {{"max_bulge", 1.0}}}};
}

/// Runs a comparison into the folder `out` beside the job.
CommandRun compare(const TemporaryFolder& folder, const json& job, const std::vector<std::string>& more,
                   const std::string& out = "out")
{
    if (!std::filesystem::exists(folder / "<i>panel'.obj")) {
        write_panel(folder / "panel.obj", 24, 18);
        std::filesystem::rename(folder / "panel.obj", folder / "<i>panel'.obj");
    }
    folder.write("job.json", job.dump());
    std::vector<std::string> arguments = {"compare", (folder / "job.json").string(), "-o", (folder / out).string(),
                                          "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tapeline(arguments);
}

const json& method_of(const json& result, const std::string& name)
{
    return *std::ranges::find_if(result["methods"], [&](const json& m) { return m["method"] == name; });
}

void expect_stable_keys(const json& result)
{
    for (const char* pointer : {"/tool_version",
                                "/description",
                                "/input/path",
                                "/input/sha256",
                                "/line/length_mm",
                                "/region/vertices",
                                "/region/distance_mm",
                                "/headline",
                                "/winner",
                                "/threads_per_method",
                                "/methods/0/method",
                                "/methods/0/state",
                                "/methods/0/reason",
                                "/methods/0/rank",
                                "/methods/0/mesh",
                                "/methods/0/placement/compressed_side",
                                "/methods/0/retraction/crossings",
                                "/methods/0/solve/0/iterations",
                                "/methods/0/uniqueness",
                                "/methods/0/solve/0/error_estimate_mm",
                                "/methods/0/quality/bulge/max_mm",
                                "/methods/0/quality/bulge/rms_mm",
                                "/methods/0/quality/sections/compressed/inflections_after",
                                "/methods/0/quality/rim_crease/max_change",
                                "/methods/0/quality/squash",
                                "/methods/0/gates/0/passed",
                                "/methods/0/warnings",
                                "/methods/0/seconds",
                                "/warnings",
                                "/seconds/methods",
                                "/seconds/pictures"}) {
        EXPECT_TRUE(result.contains(json::json_pointer(pointer))) << pointer;
    }
}

/// The row of every method, in JSON, in the table of the page and on the terminal, and its files.
void expect_all_methods(const TemporaryFolder& folder, const json& result, const std::string& page,
                        const std::string& out)
{
    ASSERT_EQ(result["methods"].size(), method_table().size());
    std::vector<int> ranks;
    for (std::size_t k = 0; k < method_table().size(); ++k) {
        const json& m = result["methods"][k];
        const std::string name(method_table()[k].name);
        EXPECT_EQ(m["method"], name);
        EXPECT_NE(page.find(">" + name + "</th>"), std::string::npos) << name;
        EXPECT_NE(out.find(name), std::string::npos) << name;
        if (m["state"] != "done") {
            EXPECT_FALSE(m["reason"].get<std::string>().empty()) << name;
            continue;
        }
        ranks.push_back(m["rank"]);
        EXPECT_EQ(m["mesh"], name + ".obj");
        EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + name + ".obj")));
        for (const char* kind : {"shaded", "zebra", "curvature", "closeup", "sections"}) {
            const auto picture = folder / ("out/pictures/" + name + "_" + kind + ".png");
            EXPECT_TRUE(read_text(picture).starts_with("\x89PNG")) << picture;
        }
    }
    std::ranges::sort(ranks);
    for (std::size_t k = 0; k < ranks.size(); ++k) {
        EXPECT_EQ(ranks[k], static_cast<int>(k) + 1);
    }
    EXPECT_GE(ranks.size(), 3U);
}

/// What comes from the job is escaped, and nothing is fetched from elsewhere.
void expect_harmless(const std::string& page)
{
    EXPECT_EQ(page.find("<b>bold"), std::string::npos);
    EXPECT_EQ(page.find("<i>panel"), std::string::npos);
    EXPECT_NE(page.find("a &lt;b&gt;bold&lt;/b&gt; slide &amp; &quot;more&quot;"), std::string::npos);
    EXPECT_NE(page.find("&lt;i&gt;panel&#39;.obj"), std::string::npos);
    std::string markup = page;
    for (std::size_t at = markup.find("<script"); at != std::string::npos; at = markup.find("<script", at + 1)) {
        markup.erase(at + 7, markup.find("</script>", at) - at - 7);
    }
    EXPECT_FALSE(std::regex_search(markup, std::regex("(src|href)=\"(?!data:)")));
    EXPECT_EQ(markup.find("url("), std::string::npos);
    EXPECT_EQ(markup.find("@import"), std::string::npos);
    EXPECT_NE(markup.find("needs JavaScript"), std::string::npos) << "the sentence for those who have none";
    EXPECT_NE(markup.find("<svg "), std::string::npos) << "sections are there without JavaScript";
}

TEST(Compare, RunsEveryMethodRanksThemAndWritesThePage)
{
    const TemporaryFolder folder;
    const CommandRun run = compare(folder, panel_job(), {});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const std::string page = read_text(folder / "out/compare.html");
    const json result = json::parse(read_text(folder / "out/compare.json"));
    expect_stable_keys(result);
    expect_all_methods(folder, result, page, run.out);
    expect_harmless(page);
    for (const char* column : {"Gauss sign", "Crown", "Rim crease", "End kink"}) {
        EXPECT_NE(page.find(std::string(">") + column + "</th>"), std::string::npos) << column;
    }
    const json &ours = method_of(result, "asan-fl"), &arap = method_of(result, "arap-sr");
    EXPECT_NEAR(ours["quality"]["slide_max_mm"], 80, 1);
    EXPECT_LT(ours["rank"], arap["rank"]);
    EXPECT_LT(ours["quality"]["bulge"]["fraction"], 0.01);
    EXPECT_GT(arap["quality"]["bulge"]["fraction"], 0.1);
    EXPECT_TRUE(ours["gates"][0]["passed"]);
    EXPECT_FALSE(arap["gates"][0]["passed"]);
    const std::string headline = result["headline"];
    EXPECT_TRUE(headline.starts_with(result["winner"].get<std::string>() + " comes first: its bulge is ")) << headline;
    EXPECT_NE(page.find(headline), std::string::npos);
    const auto bulge = [](const json& m) { return std::abs(m["quality"]["bulge"]["max_mm"].get<double>()); };
    const auto& all = result["methods"];
    const auto worst = std::ranges::max_element(all, {}, bulge);
    EXPECT_NE(headline.find((*worst)["method"].get<std::string>() + " bulges most"), std::string::npos) << headline;
}

/// Measures of a method without times and its place among others.
json timeless(json method)
{
    method.erase("seconds");
    method.erase("rank");
    for (json& solve : method["solve"]) {
        solve.erase("seconds");
    }
    return method;
}

TEST(Compare, GivesWhatASingleMoveGivesOnAnyNumberOfThreads)
{
    const TemporaryFolder folder;
    ASSERT_EQ(compare(folder, panel_job(), {"--methods", "asan-fl,arap-sr", "--threads", "1"}, "one").exit_code, 0);
    ASSERT_EQ(compare(folder, panel_job(), {"--methods", "asan-fl,arap-sr", "--threads", "4"}, "four").exit_code, 0);
    const json one = json::parse(read_text(folder / "one/compare.json"));
    const json four = json::parse(read_text(folder / "four/compare.json"));
    int compared = 0;
    for (const std::string& name : files_in(folder / "one")) {
        if (name.ends_with(".obj") || name.ends_with(".png")) {
            EXPECT_EQ(read_text(folder / ("four/" + name)), read_text(folder / ("one/" + name))) << name;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 2 + 4 + 2 * 5);
    for (const std::string name : {"asan-fl", "arap-sr"}) {
        EXPECT_EQ(timeless(method_of(one, name)), timeless(method_of(four, name)));
        json job = panel_job();
        job["move"]["method"] = name;
        folder.write("single_job.json", job.dump());
        const CommandRun run = run_tapeline({"run", (folder / "single_job.json").string(), "--quiet"});
        EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 5) << run.err;
        EXPECT_EQ(read_text(folder / "single.obj"), read_text(folder / ("one/" + name + ".obj"))) << name;
        const json single = json::parse(read_text(folder / "single.json"));
        EXPECT_EQ(single["quality"], method_of(one, name)["quality"]) << name;
        EXPECT_EQ(single["placement"], method_of(one, name)["placement"]) << name;
    }
}

TEST(CompareFailure, OfAMethodIsARowThatSaysWhy)
{
    const TemporaryFolder folder;
    json job = panel_job();
    job["move"] = {{"max_iterations", 1}};
    const CommandRun run = compare(folder, job, {"--methods", "asan,arap-sr"});
    EXPECT_EQ(run.exit_code, 4) << "no method gave a result";
    const json r = json::parse(read_text(folder / "out/compare.json"));
    EXPECT_TRUE(r["winner"].is_null());
    for (const json& m : r["methods"]) {
        EXPECT_EQ(m["state"], "not_converged");
        EXPECT_TRUE(m["rank"].is_null());
        EXPECT_NE(m["reason"].get<std::string>().find("did not converge"), std::string::npos);
    }
    const std::string page = read_text(folder / "out/compare.html");
    EXPECT_NE(page.find("did not converge"), std::string::npos);
    EXPECT_EQ(page.find("best\">"), std::string::npos) << "what is not sound is not the best of anything";
}

TEST(CompareFailure, OfAnAmbiguousMethodIsARowToo)
{
    const TemporaryFolder folder;
    json job = panel_job();
    job["input"] = TAPELINE_SOURCE_DIR "/resources/models/panel.step";
    job["remesh"] = {{"max_edge", 25}};
    job["target"] = {{"slide", {0, 14.6, 50, 85.4, 100, 85.4, 50, 14.6, 0}}, {"tolerance", 0.01}};
    ASSERT_EQ(compare(folder, job, {"--methods", "asan-fl,arap-sr", "--check-unique"}).exit_code, 0);
    const json r = json::parse(read_text(folder / "out/compare.json"));
    const json &ours = method_of(r, "asan-fl"), &arap = method_of(r, "arap-sr");
    EXPECT_EQ(ours["state"], "done");
    EXPECT_LT(ours["uniqueness"]["distance_mm"], 0.1);
    EXPECT_EQ(arap["state"], "ambiguous");
    EXPECT_GT(arap["uniqueness"]["distance_mm"], 0.1);
    EXPECT_TRUE(arap["rank"].is_null());
    EXPECT_NE(read_text(folder / "out/compare.html").find("is ambiguous: from another start"), std::string::npos);

    // Both are measured from the CAD faces, the one that stays on them and the one that buckles far off.
    const json &still = ours["quality"]["bulge"], &buckled = arap["quality"]["bulge"];
    EXPECT_EQ(still["reference"], "exact");
    EXPECT_EQ(buckled["reference"], "exact");
    EXPECT_LT(std::abs(still["max_mm"].get<double>()), 1e-6);
    EXPECT_GT(std::abs(buckled["max_mm"].get<double>()), 10);
    EXPECT_EQ(buckled["fallback_vertices"], 0);
}

TEST(CompareFailure, WritesNothingWhenTheJobCannotBePrepared)
{
    const TemporaryFolder folder;
    json job = panel_job();
    job["target"] = {{"slide", 4000}};
    const CommandRun run = compare(folder, job, {});
    EXPECT_EQ(run.exit_code, 3) << run.err;
    EXPECT_EQ(files_in(folder.path()), (std::vector<std::string>{"<i>panel'.obj", "job.json"}));
}

TEST(CompareFailure, ComesEarlyForMethodsThatDoNotExistOrStandTwice)
{
    const TemporaryFolder folder;
    const CommandRun unknown = compare(folder, panel_job(), {"--methods", "asan-fl,arap-xx"});
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_NE(unknown.err.find("'arap-xx'"), std::string::npos) << unknown.err;
    const CommandRun twice = compare(folder, panel_job(), {"--methods", "asan-fl,asan-fl"});
    EXPECT_EQ(twice.exit_code, 1);
    EXPECT_NE(twice.err.find("twice"), std::string::npos) << twice.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(CompareFailure, ComesAtOnceWhenInterrupted)
{
    const TemporaryFolder folder;
    write_panel(folder / "<i>panel'.obj.obj", 24, 18);
    std::filesystem::rename(folder / "<i>panel'.obj.obj", folder / "<i>panel'.obj");
    folder.write("job.json", panel_job().dump());
    const CommandRun run = run_tapeline(
        {"compare", (folder / "job.json").string(), "-o", (folder / "out").string(), "--progress=json"}, "methods");
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

} // namespace
} // namespace tapeline::testing
