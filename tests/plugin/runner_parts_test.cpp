// SPDX-License-Identifier: GPL-3.0-or-later
// Small parts of the runner, each on its own.
#include "kernel/spelling.h"
#include "plugin/runner/html.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/numbers.h"
#include "plugin/runner/output_set.h"
#include "plugin/runner/region_choice.h"
#include "plugin/runner/sha256.h"
#include "plugin/runner/vertex_list.h"
#include "tests/plugin/run_command.h"
#include "tests/support/shapes.h"

#include <gtest/gtest.h>
#include <limits>

namespace tapeline::testing {
namespace {

TEST(Spelling, CountsEdits)
{
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("line", ""), 4);
    EXPECT_EQ(edit_distance("retracton", "retraction"), 1);
    EXPECT_EQ(edit_distance("angel", "angle"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(nearest_word("stifness", {"stiff", "stiffness_ratio"}), "stiff");
}

TEST(Sha256, AgreesWithTheStandard)
{
    const TemporaryFolder folder;
    // FIPS 180-2, appendix B.1.
    EXPECT_EQ(file_sha256(folder.write("abc", "abc")).value(),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_FALSE(file_sha256(folder / "none"));
}

TEST(Base64, AgreesWithTheStandard)
{
    // RFC 4648, section 10.
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(ShortNumber, KeepsTheDigitsThatMatter)
{
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(69.2345), "69.2");
    EXPECT_EQ(short_number(-1234.4), "-1234");
    EXPECT_EQ(short_number(0.7784), "0.78");
    EXPECT_EQ(short_number(0.003681), "0.0037");
    EXPECT_EQ(short_number(0.000375), "3.8e-4");
    EXPECT_EQ(short_number(1.5e-12), "1.5e-12");
}

TEST(HtmlTemplate, FillsNamesOnceAndLeavesValuesAsTheyStand)
{
    EXPECT_EQ(fill_template("a {{x}} b {{y}}{{x}}", {{"x", "1{{y}}"}, {"y", "2"}}), "a 1{{y}} b 21{{y}}");
    EXPECT_EQ(fill_template("{{unknown}}|{{open", {}), "|{{open");
    EXPECT_EQ(fill_template("", {{"x", "1"}}), "");
}

TEST(HtmlText, LetsNothingEndAnElementOrAScript)
{
    EXPECT_EQ(html_text("<a href=\"x\">'&'</a>"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
    EXPECT_EQ(script_json(R"({"name":"</script><!--"})"), R"({"name":"\u003c/script>\u003c!--"})");
}

TEST(VertexList, ReadsTextAndJson)
{
    const TemporaryFolder folder;
    const std::vector<int> wanted = {3, 1, 2};
    EXPECT_EQ(read_vertex_list(folder.write("a", "3\n1\n2\n")).value(), wanted);
    EXPECT_EQ(read_vertex_list(folder.write("b", " 3, 1;2")).value(), wanted);
    EXPECT_EQ(read_vertex_list(folder.write("c", "[3,1,2]")).value(), wanted);
    EXPECT_EQ(read_vertex_list(folder.write("d", R"({"line": {"vertices": [3, 1, 2]}})")).value(), wanted);
    for (const char* wrong : {"", "a", "1 -2", "1.5", "[1, \"2\"]", "{}", "[]", "99999999999"}) {
        EXPECT_EQ(read_vertex_list(folder.write("e", wrong)).error().kind, ErrorKind::unreadable) << wrong;
    }
}

TEST(OutputSet, WritesAllFilesOrNone)
{
    const TemporaryFolder folder;
    OutputSet outputs;
    outputs.add_text(folder / "new/a.txt", "a");
    outputs.add_text(folder / "b.txt", "b");
    ASSERT_TRUE(outputs.check("").and_then([&] { return outputs.commit(); }));
    EXPECT_EQ(read_text(folder / "new/a.txt"), "a");
    OutputSet again;
    again.add_text(folder / "b.txt", "changed");
    again.add(folder / "c.txt", [](const auto&) { return Result<void>(fail(ErrorKind::unreadable, "no room")); });
    EXPECT_FALSE(again.commit());
    EXPECT_EQ(read_text(folder / "b.txt"), "b");
    EXPECT_EQ(files_in(folder.path()), (std::vector<std::string>{"b.txt", "new/a.txt"}));
}

TEST(OutputSet, RefusesANameGivenTwiceAndTheInput)
{
    const TemporaryFolder folder;
    const auto input = folder.write("in.obj", "x");
    OutputSet twice;
    twice.add_text(folder / "a.obj", "");
    twice.add_text(folder / "./a.obj", "");
    EXPECT_EQ(twice.check(input).error().kind, ErrorKind::usage);
    OutputSet over;
    over.add_text(folder / "./in.obj", "");
    EXPECT_EQ(over.check(input).error().kind, ErrorKind::usage);
}

TEST(Gates, PassAtTheirLimitAndFailBeyondIt)
{
    Measures measures;
    measures.has_line = measures.has_rest = measures.has_compressed = true;
    measures.quality.bulge_max_mm = -0.1;
    measures.quality.squash = 0.6;
    GateSettings gate;
    gate.max_bulge = 0.1;
    gate.min_squash = 0.6;
    EXPECT_FALSE(gate_failure(evaluate_gates(gate, measures)));
    measures.quality.bulge_max_mm = -0.11;
    const auto missed = gate_failure(evaluate_gates(gate, measures));
    ASSERT_TRUE(missed);
    EXPECT_EQ(missed->kind, ErrorKind::quality_gate);
    EXPECT_NE(missed->message.find("max_bulge is 0.11, limit 0.1"), std::string::npos) << missed->message;
    EXPECT_EQ(missed->message.find("min_squash"), std::string::npos);
}

TEST(Gates, FailOnWhatWasNotMeasuredOrIsNotANumber)
{
    Measures measures;
    GateSettings gate;
    gate.max_line_error = 1e-9;
    EXPECT_NE(gate_failure(evaluate_gates(gate, measures))->message.find("could not be measured"), std::string::npos);
    measures.has_target = true;
    measures.quality.line_error_max_mm = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(gate_failure(evaluate_gates(gate, measures)));
}

TEST(FacesNear, AreThoseWithinTheDistanceAndConnectedToTheLine)
{
    const Mesh mesh = crease_panel(40, 30);
    FeatureLine line;
    line.vertices = crease_panel_line(40, 30);
    std::vector<Vec3> points;
    for (const int v : line.vertices) {
        points.emplace_back(mesh.V.row(v));
    }
    std::vector<char> taken(mesh.F.rows(), 0);
    for (const int t : faces_near(mesh, line, points, 95)) {
        taken[t] = 1;
    }
    for (Eigen::Index t = 0; t < mesh.F.rows(); ++t) {
        double nearest = 1e9;
        for (int k = 0; k < 3; ++k) {
            nearest = std::min(nearest, std::abs(mesh.V(mesh.F(t, k), 1)));
        }
        // Sections are hardly longer than their y range; points lie 20 mm apart.
        if (nearest < 90) {
            EXPECT_TRUE(taken[t]) << t;
        } else if (nearest > 96) {
            EXPECT_FALSE(taken[t]) << t;
        }
    }
}

} // namespace
} // namespace tapeline::testing
