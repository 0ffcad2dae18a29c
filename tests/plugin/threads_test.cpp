// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "plugin/runner/threads.h"

#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <thread>

using namespace tapeline;

namespace {

std::set<std::thread::id> workers_of(int threads)
{
    std::set<std::thread::id> seen;
    std::mutex mutex;
    on_threads(threads, [&] {
        parallel_for(
            400,
            [&](int) {
                std::this_thread::sleep_for(std::chrono::microseconds(50));
                const std::lock_guard lock(mutex);
                seen.insert(std::this_thread::get_id());
            },
            1);
    });
    return seen;
}

} // namespace

TEST(Threads, OneThreadIsTheCallersOwn)
{
    EXPECT_EQ(workers_of(1), std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(Threads, ALimitHoldsInsideTheStepAloneAndGivesItsAnswerBack)
{
    const int before = allowed_threads();
    EXPECT_EQ(on_threads(1, [] { return allowed_threads(); }), 1);
    EXPECT_EQ(on_threads(0, [] { return allowed_threads(); }), before);
    EXPECT_EQ(allowed_threads(), before);
    EXPECT_LE(workers_of(2).size(), 2U);
}

TEST(Threads, AStepRunsInTheCallersThreadAndItsExceptionsComeOut)
{
    EXPECT_EQ(on_threads(3, [] { return std::this_thread::get_id(); }), std::this_thread::get_id());
    EXPECT_THROW(on_threads(2, []() -> int { throw std::runtime_error("out"); }), std::runtime_error);
}
