// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/child_process.h"

#include <csignal>
#include <cstdio>
#include <gtest/gtest.h>
#include <stdexcept>
#include <unistd.h>

using namespace tapeline;

TEST(ChildProcess, HandsBackEveryByte)
{
    std::string bytes(1 << 20, 'x');
    for (size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(i * 7 % 256);
    }
    const ChildOutput output = run_in_child([&bytes] { return bytes; }, 60);
    EXPECT_EQ(output.end, ChildEnd::finished);
    EXPECT_TRUE(output.bytes == bytes);
}

TEST(ChildProcess, TurnsACrashIntoAnAnswer)
{
    const auto end = [](const std::function<std::string()>& work) { return run_in_child(work, 60).end; };
    EXPECT_EQ(end([]() -> std::string {
                  std::raise(SIGSEGV);
                  return "not reached";
              }),
              ChildEnd::crashed);
    EXPECT_EQ(end([]() -> std::string { std::abort(); }), ChildEnd::crashed);
    EXPECT_EQ(end([]() -> std::string { throw std::runtime_error("no"); }), ChildEnd::crashed);
}

TEST(ChildProcess, EndsWorkThatDoesNotEnd)
{
    const ChildOutput output = run_in_child(
        []() -> std::string {
            while (true) {
                sleep(1);
            }
        },
        1);
    EXPECT_EQ(output.end, ChildEnd::timed_out);
}

TEST(ChildProcess, LetsNothingOfWhatTheWorkPrintsThrough)
{
    ::testing::internal::CaptureStdout();
    const ChildOutput output = run_in_child(
        [] {
            std::puts("noise");
            std::fflush(stdout);
            return std::string("result");
        },
        60);
    EXPECT_EQ(output.bytes, "result");
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}
