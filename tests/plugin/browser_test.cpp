// SPDX-License-Identifier: GPL-3.0-or-later
// Opens report pages in headless Chromium: what a person would see, as far as a program can tell.
#include "tests/plugin/run_command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

namespace tapeline::testing {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// The browser's name, or nothing where there is none.
std::string browser()
{
    std::stringstream folders(std::getenv("PATH") != nullptr ? std::getenv("PATH") : "/usr/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
            if (fs::exists(fs::path(folder) / name)) {
                return (fs::path(folder) / name).string();
            }
        }
    }
    return {};
}

/// A page after it has loaded.
struct Opened {
    std::string dom;
    std::vector<std::string> console; ///< messages of the page
    bool has(const std::string& text) const { return dom.find(text) != std::string::npos; }
    /// Value of the first attribute of that name.
    std::string attribute(const std::string& name) const
    {
        std::smatch match;
        return std::regex_search(dom, match, std::regex(name + "=\"([^\"]*)\"")) ? match[1].str() : "";
    }
};

/// The document without what lies in script elements, which is long.
std::string without_scripts(const std::string& dom)
{
    std::string text;
    std::size_t from = 0;
    for (std::size_t at = dom.find("<script"); at != std::string::npos; at = dom.find("<script", from)) {
        text += dom.substr(from, at - from);
        from = std::min(dom.find("</script>", at), dom.size());
    }
    return text + dom.substr(from);
}

Opened open_page(const std::string& page, const std::vector<std::string>& more = {})
{
    const TemporaryFolder profile;
    std::vector<std::string> words = {browser(),
                                      "--headless",
                                      "--no-sandbox",
                                      "--disable-gpu",
                                      "--use-angle=swiftshader",
                                      "--enable-unsafe-swiftshader",
                                      "--disable-quic",
                                      "--no-first-run",
                                      "--disable-background-networking",
                                      "--disable-component-update",
                                      "--disable-sync",
                                      "--disable-dev-shm-usage",
                                      "--user-data-dir=" + profile.path().string(),
                                      "--window-size=1400,1200",
                                      "--virtual-time-budget=8000",
                                      "--enable-logging=stderr",
                                      "--dump-dom"};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back(page);
    const CommandRun run = run_program(words);
    Opened opened{without_scripts(run.out), {}};
    std::stringstream lines(run.err);
    for (std::string line; std::getline(lines, line);) {
        // Software rendering complains of its own slowness.
        if (line.find("CONSOLE") != std::string::npos && line.find("GL Driver Message") == std::string::npos) {
            opened.console.push_back(line);
        }
    }
    return opened;
}

/// The panel and a job that moves a part of its line.
class Browser : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (browser().empty()) {
            GTEST_SKIP() << "there is no Chromium to open the page with; scripts/setup installs it";
        }
        write_panel(folder_ / "panel.obj", 24, 18);
        const json job = {{"input", "panel.obj"},
                          {"lines", {{"line", "0@25%..75%"}}},
                          {"target", {{"slide", {0, 20, 40, 20, 0}}}},
                          {"outputs", {{"out", "moved.obj"}, {"report", "report.html"}}}};
        folder_.write("job.json", job.dump());
    }

    void compare() const
    {
        const CommandRun run = run_tapeline({"compare", (folder_ / "job.json").string(), "-o",
                                             (folder_ / "out").string(), "--quiet", "--methods", "asan-fl,arap-sr"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }

    std::string address(const std::string& name) const { return "file://" + (folder_ / name).string(); }

    TemporaryFolder folder_;
};

TEST_F(Browser, ShowsAComparisonWithATableAndAModelToTurnInEveryShading)
{
    compare();
    for (const char* look : {"", "#arap-sr,zebra,0.5", "#arap-sr,displacement,1",
                             "#arap-sr,off%20the%20old%20surface,1", "#arap-sr,gaussian%20sign,0"}) {
        const Opened page = open_page(address("out/compare.html") + look);
        EXPECT_TRUE(page.console.empty()) << page.console.front();
        EXPECT_EQ(page.attribute("data-state"), "ready") << look;
        EXPECT_GT(std::stod("0" + page.attribute("data-covered")), 0.15) << look << ": the canvas is blank";
        EXPECT_GT(std::stoi("0" + page.attribute("data-colours")), 4) << look << ": the model has no shading";
        for (const char* method : {"asan-fl", "arap-sr"}) {
            EXPECT_TRUE(page.has(std::string(">") + method + "</th>")) << method;
            EXPECT_TRUE(page.has(std::string(">") + method + "</button>")) << method;
        }
        EXPECT_TRUE(page.has("best\">"));
    }
}

TEST_F(Browser, ShowsTheReportOfOneMoveTheSameWay)
{
    const CommandRun run = run_tapeline({"run", (folder_ / "job.json").string(), "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Opened page = open_page(address("report.html"));
    EXPECT_TRUE(page.console.empty()) << page.console.front();
    EXPECT_EQ(page.attribute("data-state"), "ready");
    EXPECT_GT(std::stod("0" + page.attribute("data-covered")), 0.15);
    EXPECT_TRUE(page.has("bulge of the compressed side [mm]"));
}

TEST_F(Browser, SaysThatWebGlIsMissingAndKeepsTheRest)
{
    compare();
    const Opened page = open_page(address("out/compare.html"), {"--disable-3d-apis"});
    EXPECT_EQ(page.attribute("data-state"), "no-webgl");
    EXPECT_TRUE(page.has("This browser has no WebGL"));
    EXPECT_TRUE(page.has(">asan-fl</th>"));
    EXPECT_TRUE(page.has("data:image/png;base64,"));
}

} // namespace
} // namespace tapeline::testing
