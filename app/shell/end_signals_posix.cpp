// SPDX-License-Identifier: Apache-2.0
#include "app/shell/end_signals.hpp"
#include "core/base/descriptor.hpp"

#include <QSocketNotifier>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <unistd.h>

namespace tp {

namespace {

constexpr std::array heeded_signals{SIGTERM, SIGINT, SIGHUP};

std::atomic<int> told_end{-1}; ///< of the pipe, where the handler writes
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");

void tell(int) {
    const char any = 0;
    [[maybe_unused]] const auto written = ::write(told_end, &any, 1);
}

} // namespace

struct EndSignals::Heeded {
    Descriptor heard, told;
    std::unique_ptr<QSocketNotifier> notifier;
    std::array<struct sigaction, heeded_signals.size()> before{};
};

EndSignals::EndSignals() {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return; // the system's own way to end a program is left
    heeded_ = std::make_unique<Heeded>();
    heeded_->heard = Descriptor(ends[0]);
    heeded_->told = Descriptor(ends[1]);
    heeded_->notifier = std::make_unique<QSocketNotifier>(ends[0], QSocketNotifier::Read);
    connect(heeded_->notifier.get(), &QSocketNotifier::activated, this, [this] {
        char any = 0;
        if (::read(heeded_->heard.number(), &any, 1) == 1)
            emit asked();
    });
    told_end = ends[1];
    struct sigaction ours {};
    ours.sa_handler = tell;
    ours.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&ours.sa_mask);
    for (std::size_t i = 0; i < heeded_signals.size(); ++i)
        sigaction(heeded_signals[i], &ours, &heeded_->before[i]);
}

EndSignals::~EndSignals() {
    if (!heeded_)
        return;
    for (std::size_t i = 0; i < heeded_signals.size(); ++i)
        sigaction(heeded_signals[i], &heeded_->before[i], nullptr);
    told_end = -1;
}

} // namespace tp
