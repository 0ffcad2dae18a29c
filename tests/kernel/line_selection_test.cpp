// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/feature_lines.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

#include <gtest/gtest.h>

using namespace tapeline;
using namespace tapeline::testing;

namespace {

struct Panel {
    Model model = model_of(grid(40, 4, 0, 400, -100, 100, [](double, double y) { return -0.3 * std::abs(y); }));
    std::vector<FeatureLine> lines = find_feature_lines(model);
};

std::vector<int> row(int from, int to)
{
    std::vector<int> vertices;
    for (int i = from; i <= to; ++i) {
        vertices.push_back(2 * 41 + i);
    }
    return vertices;
}

std::string message(const Result<FeatureLine>& result) { return result ? "" : result.error().message; }

} // namespace

TEST(LineThrough, MeasuresAChain)
{
    const Panel panel;
    const auto line = line_through(panel.model, row(3, 9));
    ASSERT_TRUE(line);
    EXPECT_EQ(line->id, -1);
    EXPECT_FALSE(line->closed);
    EXPECT_NEAR(line->length_mm, 60, 1e-12);
    EXPECT_NEAR(line->crease_angle_mean, 2 * std::atan(0.3) * 180 / M_PI, 1e-9);
}

TEST(LineThrough, IsClosedWhenTheListReturnsToItsStart)
{
    const Model model = model_of(cylinder(12, 3, 10, 30));
    std::vector<int> circle(12);
    for (int i = 0; i < 12; ++i) {
        circle[i] = i;
    }
    circle.push_back(0);
    const auto line = line_through(model, circle);
    ASSERT_TRUE(line);
    EXPECT_TRUE(line->closed);
    EXPECT_EQ(line->vertices.size(), 12U);
    EXPECT_NEAR(line->length_mm, 12 * 20 * std::sin(M_PI / 12), 1e-9);
}

TEST(LineThrough, RejectsListsThatAreNoChain)
{
    const Panel panel;
    EXPECT_NE(message(line_through(panel.model, {})).find("at least two"), std::string::npos);
    EXPECT_NE(message(line_through(panel.model, {82})).find("at least two"), std::string::npos);
    EXPECT_NE(message(line_through(panel.model, {82, 84})).find("82 and 84"), std::string::npos);
    EXPECT_NE(message(line_through(panel.model, {82, 83, 82})).find("twice"), std::string::npos);
    EXPECT_NE(message(line_through(panel.model, {82, 999})).find("999"), std::string::npos);
    EXPECT_NE(message(line_through(panel.model, {-1, 82})).find("-1"), std::string::npos);
}

TEST(SelectLine, TakesAWholeLineByItsNumber)
{
    const Panel panel;
    ASSERT_EQ(panel.lines.size(), 1U);
    const auto line = select_line(panel.model, panel.lines, "0");
    ASSERT_TRUE(line);
    EXPECT_EQ(line->vertices, row(0, 40));
    EXPECT_EQ(line->id, 0);
}

TEST(SelectLine, SnapsARangeInMillimetresOrPercentToTheNearestVertices)
{
    const Panel panel;
    for (const char* selector : {"0@103..304", "0@25%..75%", "0@100..75%", " 0 @ 100 mm .. 300 mm "}) {
        const auto line = select_line(panel.model, panel.lines, selector);
        ASSERT_TRUE(line) << selector << message(line);
        EXPECT_EQ(line->vertices, row(10, 30)) << selector;
        EXPECT_NEAR(line->length_mm, 200, 1e-9);
        EXPECT_EQ(line->id, 0);
    }
}

TEST(SelectLine, RemembersTheRestOfTheLineNearestFirst)
{
    const Panel panel;
    const auto line = select_line(panel.model, panel.lines, "0@100..300");
    ASSERT_TRUE(line);
    std::vector<int> before = row(0, 9);
    std::ranges::reverse(before);
    EXPECT_EQ(line->before, before);
    EXPECT_EQ(line->after, row(31, 40));
}

TEST(SelectLine, RunsOverTheStartOfAClosedLine)
{
    const Model model = model_of(cylinder(20, 3, 10, 30));
    const auto lines = find_feature_lines(model);
    ASSERT_EQ(lines.size(), 2U);
    const auto line = select_line(model, lines, "0@80%..20%");
    ASSERT_TRUE(line) << message(line);
    EXPECT_FALSE(line->closed);
    EXPECT_EQ(line->vertices, (std::vector<int>{16, 17, 18, 19, 0, 1, 2, 3, 4}));
    EXPECT_EQ(line->before, (std::vector<int>{15, 14, 13, 12, 11}));
    EXPECT_EQ(line->after, (std::vector<int>{5, 6, 7, 8, 9, 10}));
}

TEST(SelectLine, NamesTheLinesThatThereAre)
{
    const Model model = model_of(cube(4));
    const auto lines = find_feature_lines(model);
    const auto none = select_line(model, lines, "12");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::rejected);
    EXPECT_EQ(none.error().message, "no line 12: the model has lines 0 to 11");
    EXPECT_NE(message(select_line(model, {}, "0")).find("no lines"), std::string::npos);
}

TEST(SelectLine, RejectsRangesThatHoldNoEdge)
{
    const Panel panel;
    for (const char* selector : {"0@101..104", "0@300..100", "0@100..500", "0@-5..100", "0@50%..120%"}) {
        const auto line = select_line(panel.model, panel.lines, selector);
        ASSERT_FALSE(line) << selector;
        EXPECT_EQ(line.error().kind, ErrorKind::rejected);
        EXPECT_NE(message(line).find(selector), std::string::npos) << message(line);
    }
}

TEST(SelectLine, CannotReadNonsense)
{
    const Panel panel;
    for (const char* selector : {"", "x", "0@", "0@10", "0@10..", "0@..10", "0@a..b", "0@nan..10", "0x", "0@1..2..3"}) {
        const auto line = select_line(panel.model, panel.lines, selector);
        ASSERT_FALSE(line) << selector;
        EXPECT_EQ(line.error().kind, ErrorKind::usage) << selector;
    }
}
