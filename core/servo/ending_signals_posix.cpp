// SPDX-License-Identifier: Apache-2.0
#include "core/servo/ending_signals.hpp"

#include <array>
#include <csignal>
#include <cstddef>

namespace tp {

namespace {

constexpr std::array ways_out{SIGINT,  SIGTERM, SIGHUP, SIGQUIT, SIGABRT,
                              SIGSEGV, SIGBUS,  SIGFPE, SIGILL,  SIGXCPU};
std::array<struct sigaction, ways_out.size()> before;
void (*first)() noexcept = nullptr;

extern "C" void do_first_and_go_on(int signal) {
    first();
    for (std::size_t i = 0; i < ways_out.size(); ++i)
        if (ways_out[i] == signal)
            sigaction(signal, &before[i], nullptr);
    raise(signal); // blocked until this handler returns; then what stood here before has its turn
}

} // namespace

void on_ending_signals(void (*action)() noexcept) noexcept {
    first = action;
    for (std::size_t i = 0; i < ways_out.size(); ++i) {
        struct sigaction ours {};
        ours.sa_handler = do_first_and_go_on;
        sigemptyset(&ours.sa_mask);
        ours.sa_flags = SA_ONSTACK;
        sigaction(ways_out[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN)
            sigaction(ways_out[i], &ours, nullptr);
    }
}

} // namespace tp
