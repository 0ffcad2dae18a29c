// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/child_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tapeline {

namespace {

/// The child's side: never returns.
[[noreturn]] void work_and_leave(const std::function<std::string()>& work, int pipe_end)
{
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE}) {
        std::signal(signal, SIG_DFL); // the host's handlers would print, or not return
    }
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    try {
        const std::string bytes = work();
        size_t sent = 0;
        while (sent < bytes.size()) {
            const ssize_t count = write(pipe_end, bytes.data() + sent, bytes.size() - sent);
            if (count > 0) {
                sent += static_cast<size_t>(count);
            } else if (count < 0 && errno != EINTR) {
                _exit(2);
            }
        }
        _exit(0);
    } catch (...) {
        _exit(2);
    }
}

/// Reads until the other side closes; false when the time is up.
bool receive(int pipe_end, int limit_seconds, std::string& bytes)
{
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::seconds(limit_seconds);
    std::array<char, 1 << 16> buffer;
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) {
            return false;
        }
        pollfd wait{pipe_end, POLLIN, 0};
        const int ready = poll(&wait, 1, static_cast<int>(left));
        if (ready < 0 && errno == EINTR) {
            continue;
        }
        const ssize_t count = ready > 0 ? read(pipe_end, buffer.data(), buffer.size()) : 0;
        if (count > 0) {
            bytes.append(buffer.data(), static_cast<size_t>(count));
        } else if (ready != 0 && (count == 0 || errno != EINTR)) {
            return true;
        }
    }
}

} // namespace

ChildOutput run_in_child(const std::function<std::string()>& work, int limit_seconds)
{
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        return {};
    }
    const pid_t child = fork();
    if (child < 0) {
        close(ends[0]);
        close(ends[1]);
        return {};
    }
    if (child == 0) {
        close(ends[0]);
        work_and_leave(work, ends[1]);
    }
    close(ends[1]);
    ChildOutput output;
    const bool in_time = receive(ends[0], limit_seconds, output.bytes);
    close(ends[0]);
    if (!in_time) {
        kill(child, SIGKILL);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    output.end = !in_time ? ChildEnd::timed_out : good ? ChildEnd::finished : ChildEnd::crashed;
    return output;
}

} // namespace tapeline
