// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugin/run_command.h"

#include "io/model_file.h"
#include "tests/support/shapes.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace tapeline::testing {

namespace fs = std::filesystem;

namespace {

pid_t start(std::vector<std::string> words, const std::string& out, const std::string& err)
{
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t process = -1;
    const int error = posix_spawnp(&process, words.front().c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        throw std::runtime_error("cannot start " + words.front());
    }
    return process;
}

CommandRun ended(int status, const TemporaryFolder& folder)
{
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), read_text(folder / "out"),
            read_text(folder / "err")};
}

} // namespace

CommandRun run_program(const std::vector<std::string>& words)
{
    const TemporaryFolder folder;
    int status = 0;
    waitpid(start(words, (folder / "out").string(), (folder / "err").string()), &status, 0);
    return ended(status, folder);
}

CommandRun run_tapeline(const std::vector<std::string>& arguments, const std::string& interrupt_at)
{
    const TemporaryFolder folder;
    std::vector<std::string> words = {TAPELINE_COMMAND};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const pid_t process = start(words, (folder / "out").string(), (folder / "err").string());
    int status = 0;
    bool running = true;
    while (running && !interrupt_at.empty()) {
        if (read_text(folder / "err").find(interrupt_at) != std::string::npos) {
            kill(process, SIGINT);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        running = waitpid(process, &status, WNOHANG) == 0;
    }
    if (running) {
        waitpid(process, &status, 0);
    }
    return ended(status, folder);
}

std::vector<std::string> files_in(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            names.push_back(entry.path().lexically_relative(folder).string());
        }
    }
    std::ranges::sort(names);
    return names;
}

void write_panel(const fs::path& path, int nx, int ny)
{
    if (const auto written = write_mesh(path, crease_panel(nx, ny)); !written) {
        throw std::runtime_error(written.error().message);
    }
}

} // namespace tapeline::testing
