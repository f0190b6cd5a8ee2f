// SPDX-License-Identifier: Apache-2.0
#include "device/guard/process/ends.hpp"
#include "device/guard/process/posix_ends.hpp"

#include <cerrno>
#include <csignal>
#include <poll.h>
#include <unistd.h>

namespace tp::guard {

namespace {

constexpr int patience_ms = 2000;

int descriptor_of(End end) { return end == End::device ? device_descriptor : program_descriptor; }

/// As poll(2) of one descriptor; no signal ends the wait.
int wait_for(int descriptor, short for_what, int wait_ms) {
    pollfd one{descriptor, for_what, 0};
    int ready = 0;
    while ((ready = poll(&one, 1, wait_ms)) < 0 && errno == EINTR) {
    }
    return ready;
}

} // namespace

bool take_ends() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTTOU, SIGTTIN, SIGTSTP, SIGALRM,
                             SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGIO, SIGXCPU, SIGXFSZ})
        std::signal(signal, SIG_IGN);
#if defined(__linux__)
    for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal)
        std::signal(signal, SIG_IGN);
    std::signal(SIGPWR, SIG_IGN);
    std::signal(SIGSTKFLT, SIG_IGN);
#endif
    return true;
}

int read_within(End end, std::span<std::uint8_t> into, int wait_ms) {
    const int descriptor = descriptor_of(end);
    const int ready = wait_for(descriptor, POLLIN, wait_ms);
    if (ready <= 0)
        return ready;
    const ssize_t got = read(descriptor, into.data(), into.size());
    return got > 0 ? static_cast<int>(got) : -1;
}

bool write_all(End end, std::span<const std::uint8_t> bytes) {
    const int descriptor = descriptor_of(end);
    while (!bytes.empty()) {
        const ssize_t gone = write(descriptor, bytes.data(), bytes.size());
        if (gone > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(gone));
        else if (gone < 0 && errno == EAGAIN) {
            if (wait_for(descriptor, POLLOUT, patience_ms) <= 0)
                return false;
        } else if (gone == 0 || errno != EINTR)
            return false;
    }
    return true;
}

} // namespace tp::guard
