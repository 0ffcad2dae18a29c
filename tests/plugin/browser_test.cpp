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

/// A comparison and the report of one move, made once for all tests here.
class Browser : public ::testing::Test {
protected:
    static void SetUpTestSuite()
    {
        if (browser().empty()) {
            return;
        }
        folder_ = std::make_unique<TemporaryFolder>();
        write_panel(*folder_ / "panel.obj", 24, 18);
        const json job = {{"input", "panel.obj"},
                          {"lines", {{"line", "0@25%..75%"}}},
                          {"target", {{"slide", {0, 20, 40, 20, 0}}}},
                          {"outputs", {{"out", "moved.obj"}, {"report", "report.html"}}}};
        folder_->write("job.json", job.dump());
        const std::string path = (*folder_ / "job.json").string();
        ASSERT_EQ(run_tapeline(
                      {"compare", path, "-o", (*folder_ / "out").string(), "--quiet", "--methods", "asan-fl,arap-sr"})
                      .exit_code,
                  0);
        ASSERT_EQ(run_tapeline({"run", path, "--quiet"}).exit_code, 0);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    void SetUp() override
    {
        if (browser().empty()) {
            GTEST_SKIP() << "there is no Chromium to open the page with; scripts/setup installs it";
        }
    }

    static std::string address(const std::string& name) { return "file://" + (*folder_ / name).string(); }

    static std::unique_ptr<TemporaryFolder> folder_;
};
std::unique_ptr<TemporaryFolder> Browser::folder_;

TEST_F(Browser, ShowsAComparisonWithATableAndAModelToTurn)
{
    const Opened page = open_page(address("out/compare.html"));
    EXPECT_TRUE(page.console.empty()) << page.console.front();
    EXPECT_EQ(page.attribute("data-state"), "ready");
    EXPECT_GT(std::stod("0" + page.attribute("data-covered")), 0.15) << "share of the canvas that shows the model";
    EXPECT_GT(std::stoi("0" + page.attribute("data-colours")), 20);
    for (const char* method : {"asan-fl", "arap-sr"}) {
        EXPECT_TRUE(page.has(std::string(">") + method + "</th>")) << method;
        EXPECT_TRUE(page.has(std::string(">") + method + "</button>")) << method;
    }
    EXPECT_TRUE(page.has("class=\"best\"") || page.has("best\""));
}

TEST_F(Browser, ShowsEveryShading)
{
    for (const char* shading : {"zebra", "displacement", "off%20the%20old%20surface", "gaussian%20sign"}) {
        const Opened page = open_page(address("out/compare.html#arap-sr,") + shading + ",0.5");
        EXPECT_TRUE(page.console.empty()) << page.console.front();
        EXPECT_GT(std::stod("0" + page.attribute("data-covered")), 0.15) << shading;
        EXPECT_GT(std::stoi("0" + page.attribute("data-colours")), 4) << shading;
    }
}

TEST_F(Browser, ShowsTheReportOfOneMoveTheSameWay)
{
    const Opened page = open_page(address("report.html"));
    EXPECT_TRUE(page.console.empty()) << page.console.front();
    EXPECT_EQ(page.attribute("data-state"), "ready");
    EXPECT_GT(std::stod("0" + page.attribute("data-covered")), 0.15);
    EXPECT_TRUE(page.has("bulge of the compressed side [mm]"));
}

TEST_F(Browser, SaysThatWebGlIsMissingAndKeepsTheRest)
{
    const Opened page = open_page(address("out/compare.html"), {"--disable-3d-apis"});
    EXPECT_EQ(page.attribute("data-state"), "no-webgl");
    EXPECT_TRUE(page.has("This browser has no WebGL"));
    EXPECT_TRUE(page.has(">asan-fl</th>"));
    EXPECT_TRUE(page.has("data:image/png;base64,"));
}

TEST_F(Browser, MakesSenseWithoutJavaScript)
{
    const std::string page = without_scripts(read_text(*folder_ / "out/compare.html"));
    for (const char* part : {"needs JavaScript", ">asan-fl</th>", "data:image/png;base64,", "<svg "}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

TEST_F(Browser, NeedsNoNetwork)
{
    for (const char* name : {"out/compare.html", "report.html"}) {
        const std::string page = without_scripts(read_text(*folder_ / name));
        EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:)"))) << name;
        EXPECT_EQ(page.find("url("), std::string::npos) << name;
        EXPECT_EQ(page.find("@import"), std::string::npos) << name;
    }
}

} // namespace
} // namespace tapeline::testing
