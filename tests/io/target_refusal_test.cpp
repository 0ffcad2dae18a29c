// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/target_file.h"
#include "tests/bspline/curves.h"
#include "tests/support/files.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace tapeline {
namespace {

using testing::circle;
using testing::TemporaryFolder;

/// Each content must be refused in one sentence that names the file and says `word`.
void expect_refused(const TemporaryFolder& scratch, const std::string& name, const std::string& content,
                    const std::string& word)
{
    scratch.write(name, content);
    const auto line = read_target(scratch / name);
    ASSERT_FALSE(line) << content;
    const std::string& message = line.error().message;
    EXPECT_NE(message.find(name), std::string::npos) << message;
    EXPECT_NE(message.find(word), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(line.error().kind == ErrorKind::unreadable || line.error().kind == ErrorKind::rejected);
}

TEST(TargetFile, RefusesBadJsonInOneSentence)
{
    const TemporaryFolder scratch;
    const auto refuse = [&](const std::string& content, const std::string& word) {
        expect_refused(scratch, "bad.json", content, word);
    };
    const std::string points = "\"control_points\": [[0,0,0],[1,0,0],[2,1,0],[3,0,0]]";
    const std::string knots = "\"knots\": [0,0,0,0,1,1,1,1]";
    const std::string good = "{\"degree\": 3, " + knots + ", " + points;
    refuse("{", "JSON");
    refuse("{\"degree\": 3,, }", "line 1");
    refuse("{\"degree\": 1e999}", "JSON");
    refuse("{\"degree\": \"\xff\xfe\"}", "JSON");
    refuse("{}", "degree");
    refuse(good + ", \"knotz\": 1}", "\"knots\"");
    refuse(good + ", \"Closed\": true}", "\"closed\"");
    refuse(good + ", \"closed\": 1}", "\"closed\"");
    refuse(good + ", \"closed\": true}", "closed");
    refuse(good + ", \"weights\": [1,1,1]}", "weights");
    refuse(good + ", \"weights\": [1,1,1,-2]}", "weight 3");
    refuse(good + ", \"weights\": {}}", "\"weights\"");
    refuse("{\"degree\": \"3\", " + knots + ", " + points + "}", "\"degree\"");
    refuse("{\"degree\": 2.5, " + knots + ", " + points + "}", "\"degree\"");
    refuse("{\"degree\": 1e9, " + knots + ", " + points + "}", "degree");
    refuse("{\"degree\": 3, \"knots\": [0,0,0,0,1,1,1], " + points + "}", "knots");
    refuse("{\"degree\": 3, \"knots\": [0,0,0,0,1,1,1,0.5], " + points + "}", "knot 7");
    refuse("{\"degree\": 3, \"knots\": [0,0,0,null,1,1,1,1], " + points + "}", "\"knots[3]\"");
    refuse("{\"degree\": 3, " + knots + "}", "\"control_points\" is missing");
    refuse("{\"degree\": 3, " + knots + ", \"control_points\": [[0,0,0],[1,0],[2,1,0],[3,0,0]]}",
           "\"control_points[1]\"");
    refuse("{\"degree\": 3, " + knots + ", \"control_points\": [[0,0,0],[1,0,0],[2,1,\"a\"],[3,0,0]]}",
           "\"control_points[2]\"");
    refuse("{\"degree\": 3, " + knots + ", \"control_points\": [[0,0,0],[0,0,0],[0,0,0],[0,0,0]]}", "length");
    refuse(std::string(200000, '{'), "JSON");
    refuse("{\"degree\":" + std::string(200000, '['), "JSON");
}

TEST(TargetFile, RefusesABadCsvWithTheLineNumber)
{
    const TemporaryFolder scratch;
    const auto refuse = [&](const std::string& content, const std::string& word) {
        expect_refused(scratch, "bad.csv", content, word);
    };
    refuse("", "empty");
    refuse("  \n \n", "empty");
    refuse("0,0,0\n1,1,1\n", "line 1");
    refuse("x,y,z\n0,0,0\n1,nan,0\n", "line 3");
    refuse("x,y,z\n0,0,0\n1,inf,0\n", "line 3");
    refuse("x,y,z\n0,0,0\n1,1e999,0\n", "line 3");
    refuse("x,y,z\n0,0,0\n\n# note\n1,2\n", "line 5");
    refuse("x,y,z\n0,0,0,\n", "line 2");
    refuse("x,y,z\n0,0;0,0\n", "line 2");
    refuse("x,y,z\n0,0x1,0\n", "line 2");
    refuse("x,y,z\n1,1,1\n1,1,1\n", "at least 2");
    refuse("x,y,z\n", "at least 2");
    refuse(std::string("x,y,z\n0,0,\0\n", 11), "line 2");
    refuse("solid of nothing\n", "line 1");
}

TEST(TargetFile, RefusesABrokenCadFile)
{
    const TemporaryFolder scratch;
    for (const char* name : {"line.step", "line.iges", "line.brep"}) {
        ASSERT_TRUE(write_target(scratch / name, circle(Vec3(1, 2, 3), 40)));
        const std::string whole = testing::read_text(scratch / name);
        for (const double share : {0.1, 0.5, 0.9}) {
            expect_refused(scratch, name,
                           whole.substr(0, static_cast<size_t>(share * static_cast<double>(whole.size()))), "");
        }
    }
    expect_refused(scratch, "line.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "");
}

TEST(TargetFile, RefusesWhatCannotBeOpenedOrNamed)
{
    const TemporaryFolder scratch;
    EXPECT_EQ(read_target(scratch / "none.json").error().kind, ErrorKind::unreadable);
    EXPECT_EQ(read_target(scratch.path()).error().kind, ErrorKind::unreadable);
    const TargetLine line = circle(Vec3::Zero(), 1);
    EXPECT_EQ(write_target(scratch / "line.docx", line).error().kind, ErrorKind::usage);
    EXPECT_EQ(write_target(scratch / "no/such/folder.json", line).error().kind, ErrorKind::unreadable);
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

} // namespace
} // namespace tapeline
