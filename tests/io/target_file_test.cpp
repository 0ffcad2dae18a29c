// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/target_file.h"
#include "tests/bspline/curves.h"
#include "tests/support/files.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>

namespace tapeline {
namespace {

using testing::circle;
using testing::data_of_spatial_cubic;
using testing::line_of;
using testing::read_text;
using testing::TemporaryFolder;

BSplineData awkward_data()
{
    BSplineData data = data_of_spatial_cubic();
    data.weights = {1, 2, 1.0 / 3, 1, 0.7, 1, 1e-3, 1};
    data.knots[4] = 0.1 + 0.2 - 0.15;
    data.control_points[3] = Vec3(1.0 / 3, -2e-17, 12345.678901234567);
    return data;
}

/// Largest distance between the two curves, both ways.
double distance_between(const TargetLine& a, const TargetLine& b)
{
    double worst = 0;
    for (int i = 0; i <= 400; ++i) {
        worst = std::max(worst, b.foot(a.point(a.parameter_at(a.length() * i / 400))).distance);
        worst = std::max(worst, a.foot(b.point(b.parameter_at(b.length() * i / 400))).distance);
    }
    return worst;
}

std::ptrdiff_t files_in(const TemporaryFolder& folder)
{
    return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

TEST(TargetFile, InJsonKeepsEveryDouble)
{
    const TemporaryFolder scratch;
    const BSplineData data = awkward_data();
    ASSERT_TRUE(write_target(scratch / "line.json", line_of(data)));
    const auto line = read_target(scratch / "line.json");
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_EQ(line->data().degree, data.degree);
    EXPECT_EQ(line->data().knots, data.knots);
    EXPECT_EQ(line->data().weights, data.weights);
    EXPECT_EQ(line->data().control_points, data.control_points);
    EXPECT_FALSE(line->closed());
}

TEST(TargetFile, InCadFormatsKeepsTheCurve)
{
    const TemporaryFolder scratch;
    for (const char* name : {"line.step", "line.STP", "line.iges", "line.igs", "line.brep"}) {
        for (const TargetLine& line : {line_of(awkward_data()), line_of(data_of_spatial_cubic()),
                                       circle(Vec3(1, 2, 3), 40), testing::straight(Vec3(1, 0, 0), Vec3(0, 7, 1))}) {
            const auto written = write_target(scratch / name, line);
            ASSERT_TRUE(written) << written.error().message;
            const auto again = read_target(scratch / name);
            ASSERT_TRUE(again) << name << ": " << again.error().message;
            EXPECT_LE(distance_between(line, *again), 1e-12 * line.length()) << name;
            EXPECT_EQ(again->closed(), line.closed()) << name;
            // The sense is kept.
            EXPECT_NEAR((again->tangent(again->first_parameter()) - line.tangent(line.first_parameter())).norm(), 0,
                        1e-9)
                << name;
        }
    }
}

TEST(TargetFile, HoldsTheSameBytesForTheSameLine)
{
    const TemporaryFolder scratch;
    for (const char* ending : {".json", ".csv", ".step", ".iges", ".brep"}) {
        ASSERT_TRUE(write_target(scratch / (std::string("a") + ending), line_of(awkward_data())));
        ASSERT_TRUE(write_target(scratch / (std::string("b") + ending), line_of(awkward_data())));
        EXPECT_EQ(read_text(scratch / (std::string("a") + ending)), read_text(scratch / (std::string("b") + ending)))
            << ending;
    }
    EXPECT_EQ(files_in(scratch), 10); // and no temporary file is left
}

TEST(TargetFile, InCsvIsInterpolatedClosely)
{
    const TemporaryFolder scratch;
    for (const TargetLine& line : {line_of(data_of_spatial_cubic()), circle(Vec3(1, 2, 3), 40)}) {
        ASSERT_TRUE(write_target(scratch / "line.csv", line));
        const auto again = read_target(scratch / "line.csv");
        ASSERT_TRUE(again) << again.error().message;
        EXPECT_LE(distance_between(line, *again), 1e-6 * line.length());
        EXPECT_EQ(again->closed(), line.closed());
    }
}

TEST(TargetFile, TakesCsvAsPeopleWriteIt)
{
    const TemporaryFolder scratch;
    for (const std::string content :
         {"x,y,z\n0,0,0\n10,5,0\n20,0,1\n30,5,1\n", "x,y,z\r\n0,0,0\r\n10,5,0\r\n20,0,1\r\n30,5,1",
          "\xEF\xBB\xBF# a line\n\n X , Y , Z\n 0, 0,0 # start\n+10 ,5e0,  0\n\n20,0,1\n30,5,1\n\n",
          "x,y,z\r0,0,0\r0,0,0\r10,5,0\r20,0,1\r30,5,1\r"}) {
        scratch.write("line.csv", content);
        const auto line = read_target(scratch / "line.csv");
        ASSERT_TRUE(line) << line.error().message;
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(10, 5, 0), Vec3(20, 0, 1), Vec3(30, 5, 1)}) {
            EXPECT_LE(line->foot(p).distance, 1e-6 * line->length());
        }
    }
    scratch.write("two.txt", "x,y,z\n0,0,0\n1,0,0\n");
    EXPECT_TRUE(read_target(scratch / "two.txt"));
}

TEST(TargetFile, TakesALineWhoseEndsMeetAsClosed)
{
    const TemporaryFolder scratch;
    const std::string square = R"({"degree": 1, "knots": [0,0,1,2,3,4,4],
        "control_points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,0]])";
    scratch.write("a.json", square + "}");
    scratch.write("b.json", square + ", \"closed\": false}");
    scratch.write("c.json", square + ", \"closed\": true}");
    EXPECT_TRUE(read_target(scratch / "a.json")->closed());
    EXPECT_FALSE(read_target(scratch / "b.json")->closed());
    EXPECT_TRUE(read_target(scratch / "c.json")->closed());
}

TEST(EditFile, ReadsPositionsAndVectors)
{
    const TemporaryFolder scratch;
    scratch.write("edits.json", R"({"edits": [{"index": 2, "to": [1, 2.5, -3]}, {"index": 0, "by": [0, 0, 1e-3]}]})");
    const auto edits = read_edits(scratch / "edits.json");
    ASSERT_TRUE(edits) << edits.error().message;
    ASSERT_EQ(edits->size(), 2u);
    EXPECT_EQ((*edits)[0].index, 2);
    EXPECT_EQ((*edits)[0].value, Vec3(1, 2.5, -3));
    EXPECT_FALSE((*edits)[0].relative);
    EXPECT_TRUE((*edits)[1].relative);
    EXPECT_EQ((*edits)[1].value, Vec3(0, 0, 1e-3));
}

TEST(EditFile, IsRefusedInOneSentence)
{
    const TemporaryFolder scratch;
    const auto refuse = [&](const std::string& content, const std::string& word) {
        scratch.write("edits.json", content);
        const auto edits = read_edits(scratch / "edits.json");
        ASSERT_FALSE(edits) << content;
        EXPECT_NE(edits.error().message.find(word), std::string::npos) << edits.error().message;
        EXPECT_NE(edits.error().message.find("edits.json"), std::string::npos) << edits.error().message;
    };
    refuse("", "JSON");
    refuse("[]", "object");
    refuse("{\"edit\": []}", "\"edits\"");
    refuse("{\"edits\": {}}", "\"edits\"");
    refuse("{}", "\"edits\"");
    refuse(R"({"edits": [{"index": 1}]})", "edits[0]");
    refuse(R"({"edits": [{"index": 1, "to": [0,0,0], "by": [0,0,0]}]})", "one of them");
    refuse(R"({"edits": [{"index": 1.5, "to": [0,0,0]}]})", "edits[0].index");
    refuse(R"({"edits": [{"index": 1, "to": [0,0]}]})", "edits[0].to");
    refuse(R"({"edits": [{"index": 1, "two": [0,0,0]}]})", "\"to\"");
    refuse(R"({"edits": [{"to": [0,0,0]}]})", "edits[0].index");
    refuse(R"({"edits": [7]})", "edits[0]");
}

} // namespace
} // namespace tapeline
