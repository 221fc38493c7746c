// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "signals.h"

extern char** environ;

namespace nacre::tool {
namespace {

/// Owns what posix_spawn is told about files and signals.
class SpawnSetup {
public:
    SpawnSetup(const ChildOptions& options, int output)
    {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
        if (!options.folder.empty())
            posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
        if (output >= 0) {
            posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
            posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
        }
        // Signals that we ignore would stay ignored in the child.
        sigset_t defaults;
        sigemptyset(&defaults);
        for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&defaults, signal);
        posix_spawnattr_setsigdefault(&attributes, &defaults);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    }
    SpawnSetup(const SpawnSetup&) = delete;
    SpawnSetup& operator=(const SpawnSetup&) = delete;
    ~SpawnSetup()
    {
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }

    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
};

std::vector<std::string> environment_with(const std::map<std::string, std::string>& extra)
{
    std::vector<std::string> result;
    for (char** entry = environ; *entry; ++entry) {
        const std::string text = *entry;
        if (!extra.contains(text.substr(0, text.find('=')))) result.push_back(text);
    }
    for (const auto& [name, value] : extra) result.push_back(fmt::format("{}={}", name, value));
    return result;
}

std::vector<char*> pointers(std::vector<std::string>& strings)
{
    std::vector<char*> result;
    result.reserve(strings.size() + 1);
    for (std::string& text : strings) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

std::string read_to_end(int descriptor)
{
    std::string text;
    std::array<char, 4096> block;
    for (;;) {
        const ssize_t count = read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(block.data(), static_cast<std::size_t>(count));
    }
}

int wait_for(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

bool is_executable_file(const std::filesystem::path& path)
{
    std::error_code unreadable;  // PATH may name folders that this user may not enter
    return std::filesystem::is_regular_file(path, unreadable) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& command, const ChildOptions& options)
{
    std::array<int, 2> pipe_ends{-1, -1};
    if (options.capture && pipe2(pipe_ends.data(), O_CLOEXEC) != 0)
        throw InputError(
            {command.front(), 0, "", fmt::format("cannot be started: {}", std::strerror(errno))});
    std::vector<std::string> arguments = command;
    std::vector<std::string> environment = environment_with(options.environment);
    const SpawnSetup setup(options, pipe_ends[1]);
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, command.front().c_str(), &setup.actions, &setup.attributes,
                     pointers(arguments).data(), pointers(environment).data());
    if (options.capture) close(pipe_ends[1]);
    ChildResult result{0, {}};
    if (error == 0) {
        forward_signals_to(child);
        if (options.capture) result.output = read_to_end(pipe_ends[0]);
        result.exit_code = wait_for(child);
        forward_signals_to(0);
    }
    if (options.capture) close(pipe_ends[0]);
    if (error != 0)
        throw InputError(
            {command.front(), 0, "", fmt::format("cannot be started: {}", std::strerror(error))});
    return result;
}

std::optional<std::filesystem::path> find_program(const std::string& name)
{
    if (name.find('/') != std::string::npos)
        return is_executable_file(name) ? std::optional(std::filesystem::path(name)) : std::nullopt;
    const char* path = std::getenv("PATH");
    std::string_view rest = path ? path : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::filesystem::path candidate = std::filesystem::path(rest.substr(0, end)) / name;
        if (is_executable_file(candidate)) return candidate;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return std::nullopt;
}

}  // namespace nacre::tool
