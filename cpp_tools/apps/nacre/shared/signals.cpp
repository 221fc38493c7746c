// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shared/signals.h"

#include <unistd.h>
#include <atomic>
#include <csignal>

namespace nacre::tool {
namespace {

std::atomic<int> g_signal{0};
std::atomic<int> g_writers{0};
std::atomic<pid_t> g_child{0};

// Runs inside a signal: lock-free atomics, kill and _exit only.
void on_signal(int signal, siginfo_t* info, void*)
{
    g_signal = signal;
    if (const pid_t child = g_child; child > 0 && info->si_code != SI_KERNEL) kill(child, signal);
    if (g_writers == 0) _exit(128 + signal);
}

}  // namespace

void install_signal_handlers()
{
    struct sigaction action = {};
    action.sa_sigaction = on_signal;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
    // A full disc or a closed pipe is an error that gets a message, not a silent end.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() noexcept
{
    return g_signal != 0;
}

void check_interrupted()
{
    if (const int signal = g_signal) throw Interrupted(signal);
}

WritingGuard::WritingGuard() noexcept
{
    ++g_writers;
}

WritingGuard::~WritingGuard()
{
    if (--g_writers == 0 && g_signal != 0) _exit(128 + g_signal);
}

void forward_signals_to(pid_t child) noexcept
{
    g_child = child;
}

}  // namespace nacre::tool
