// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shared/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "shared/signals.h"

extern char** environ;

namespace nacre::tool {
namespace {

/// Where a child that reports finds our standard output.
constexpr int kReport = 3;

/// Owns what posix_spawn is told about files and signals.
class SpawnSetup {
public:
    SpawnSetup()
    {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
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

    /// Of a child that reports; the last of what its files are told.
    void put_report_aside(bool chatter)
    {
        if (fcntl(STDOUT_FILENO, F_GETFD) >= 0)
            posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, kReport);
        if (chatter)
            posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
        else
            posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
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

[[noreturn]] void throw_start_error(const std::string& program, int error)
{
    throw InputError({program, 0, "", fmt::format("cannot be started: {}", std::strerror(error))});
}

pid_t spawn(const std::vector<std::string>& command,
            const std::map<std::string, std::string>& extra_environment, const SpawnSetup& setup)
{
    std::vector<std::string> arguments = command;
    std::vector<std::string> environment = environment_with(extra_environment);
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, command.front().c_str(), &setup.actions, &setup.attributes,
                     pointers(arguments).data(), pointers(environment).data());
    if (error != 0) throw_start_error(command.front(), error);
    return child;
}

/// Both ends of a pipe, which no child inherits by chance.
class Pipe {
public:
    explicit Pipe(const std::string& program)
    {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw_start_error(program, errno);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe()
    {
        for (const int end : ends_)
            if (end >= 0) close(end);
    }
    [[nodiscard]] int read_end() const noexcept { return ends_[0]; }
    [[nodiscard]] int write_end() const noexcept { return ends_[1]; }
    void close_write_end() { close(std::exchange(ends_[1], -1)); }
    [[nodiscard]] int release_read_end() noexcept { return std::exchange(ends_[0], -1); }
    [[nodiscard]] int release_write_end() noexcept { return std::exchange(ends_[1], -1); }

private:
    std::array<int, 2> ends_{-1, -1};
};

/// Appends what there is; false at the end.
bool read_some(int descriptor, std::string& text)
{
    std::array<char, 4096> block;
    ssize_t count = 0;
    do {
        count = read(descriptor, block.data(), block.size());
    } while (count < 0 && errno == EINTR);
    if (count <= 0) return false;
    text.append(block.data(), static_cast<std::size_t>(count));
    return true;
}

ChildResult wait_for(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return {signal ? 128 + signal : WEXITSTATUS(status), signal, {}};
}

bool is_executable_file(const std::filesystem::path& path)
{
    std::error_code unreadable;  // PATH may name folders that this user may not enter
    return std::filesystem::is_regular_file(path, unreadable) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& command, const ChildOptions& options)
{
    std::optional<Pipe> pipe;
    SpawnSetup setup;
    if (options.capture) {
        pipe.emplace(command.front());
        if (!options.reports)
            posix_spawn_file_actions_adddup2(&setup.actions, pipe->write_end(), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&setup.actions, pipe->write_end(), STDERR_FILENO);
    }
    std::vector<std::string> arguments = command;
    // By a shell: posix_spawn changes folders from glibc 2.29 on only.
    if (!options.folder.empty())
        arguments.insert(arguments.begin(),
                         {"/bin/sh", "-c", R"(cd -- "$0" && exec "$@")", options.folder.string()});
    std::map<std::string, std::string> environment = options.environment;
    if (options.reports) {
        setup.put_report_aside(options.chatter);
        environment["NACRE_REPORT_FD"] = std::to_string(kReport);
    }
    const pid_t child = spawn(arguments, environment, setup);
    std::string captured;
    forward_signals_to(child);
    if (pipe) {
        pipe->close_write_end();
        while (read_some(pipe->read_end(), captured)) {
        }
    }
    ChildResult result = wait_for(child);
    result.output = std::move(captured);
    forward_signals_to(0);
    return result;
}

Dialogue::Dialogue(const std::vector<std::string>& command,
                   const std::map<std::string, std::string>& environment)
{
    Pipe input(command.front()), output(command.front());
    SpawnSetup setup;
    posix_spawn_file_actions_adddup2(&setup.actions, input.read_end(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&setup.actions, output.write_end(), STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&setup.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    child_ = spawn(command, environment, setup);
    input_ = input.release_write_end();
    output_ = output.release_read_end();
}

Dialogue::~Dialogue()
{
    close(input_);
    close(output_);
    (void)wait_for(child_);
}

std::optional<std::string> Dialogue::read_line()
{
    std::size_t end = 0;
    while ((end = unread_.find('\n')) == std::string::npos)
        if (!read_some(output_, unread_)) return std::nullopt;
    std::string line = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    return line;
}

void Dialogue::write_line(std::string text)
{
    text += '\n';
    for (std::string_view rest = text; !rest.empty();) {
        const ssize_t count = write(input_, rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return;
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
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
