// SPDX-License-Identifier: Apache-2.0
#include "app/cli/stop_signal.hpp"

#include <array>
#include <csignal>

namespace tp {

namespace {

constexpr std::array heeded{SIGINT, SIGTERM};
std::atomic<bool> stop{false};
std::atomic<int> received{0};
std::array<struct sigaction, heeded.size()> before;

static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may not wait for a lock");

void heed(int signal) {
    received = signal;
    stop = true;
}

} // namespace

StopSignal::StopSignal() {
    stop = false;
    struct sigaction ours {};
    ours.sa_handler = heed;
    ours.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&ours.sa_mask);
    for (std::size_t i = 0; i < heeded.size(); ++i)
        sigaction(heeded[i], &ours, &before[i]);
}

StopSignal::~StopSignal() {
    for (std::size_t i = 0; i < heeded.size(); ++i)
        sigaction(heeded[i], &before[i], nullptr);
}

const std::atomic<bool>& StopSignal::asked() { return stop; }

int StopSignal::exit_code() { return 128 + received; }

} // namespace tp
