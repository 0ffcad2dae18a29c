// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/cli/command_line.h"
#include "plugin/cli/commands.h"
#include "plugin/cli/console.h"

#include <cstdio>
#include <exception>
#include <optional>
#include <tbb/global_control.h>

namespace {

int run(int argc, char** argv)
{
    using namespace tapeline;
    watch_for_interrupts();
    const auto read = read_command_line(argc, argv);
    if (const auto* answer = std::get_if<Answer>(&read)) {
        std::fputs(answer->text.c_str(), answer->exit_code == 0 ? stdout : stderr);
        return answer->exit_code;
    }
    const auto& invocation = std::get<Invocation>(read);
    std::optional<tbb::global_control> limit;
    if (invocation.job.command.threads > 0) {
        limit.emplace(tbb::global_control::max_allowed_parallelism, invocation.job.command.threads);
    }
    Console console(invocation.job.command);
    const auto done = run_invocation(invocation, console);
    return done ? 0 : console.fail(done.error());
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("tapeline: error: out of memory; take a coarser mesh or a larger --linear-deflection\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tapeline: error: %s\n", error.what());
    } catch (...) {
        std::fputs("tapeline: error: an unknown failure\n", stderr);
    }
    return tapeline::exit_code(tapeline::ErrorKind::rejected);
}
