// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says of the angle at the rim of the region.
#include "tests/plugin/run_command.h"
#include "tests/support/files.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tapeline::testing {
namespace {

/// Slides a circle of the pawn between two others, on which its region ends.
CommandRun move_circle(const TemporaryFolder& folder, std::vector<std::string> more)
{
    std::vector<std::string> words = {"move",
                                      TAPELINE_SOURCE_DIR "/resources/models/pawn.step",
                                      "--line",
                                      "4",
                                      "--slide",
                                      "1.5",
                                      "--max-edge",
                                      "0.8",
                                      "--angular-deflection",
                                      "12",
                                      "-o",
                                      (folder / "moved.obj").string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_tapeline(words);
}

} // namespace

TEST(RimWarning, SaysThatAnExistingCreaseChangesItsAngleAndWhatKeepsIt)
{
    const TemporaryFolder folder;
    const CommandRun free = move_circle(folder, {});
    ASSERT_EQ(free.exit_code, 0) << free.err;
    EXPECT_NE(free.err.find("where the region ends on a crease of"), std::string::npos) << free.err;
    EXPECT_NE(free.err.find("--rim tangent keeps it"), std::string::npos) << free.err;
    EXPECT_EQ(free.err.find("leaves a crease"), std::string::npos) << free.err;
    const CommandRun tangent = move_circle(folder, {"--rim", "tangent"});
    ASSERT_EQ(tangent.exit_code, 0) << tangent.err;
    EXPECT_EQ(tangent.err.find("where the region ends"), std::string::npos) << tangent.err;
}

} // namespace tapeline::testing
