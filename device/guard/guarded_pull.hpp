// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/guard/force_guard.hpp"

#include <atomic>
#include <memory>
#include <utility>

namespace tp {

/// The writer's side of a guard that may step in: gives it a sign of life before and after each message. Once
/// the guard has stepped in no message carries a force, until one was meant to carry none.
class GuardedPull {
public:
    explicit GuardedPull(std::unique_ptr<ForceGuard> guard) : guard_(std::move(guard)) {}

    /// Sends a message that is meant to carry a force or not by `write(with_force)`, without its force where
    /// the guard has stepped in, and again without where it does meanwhile. What `write` said last. The
    /// writer.
    template <typename Write>
    bool send(bool pulls, Write write) noexcept {
        const bool may = may_go_out(pulls);
        const bool carries = pulls && may;
        const bool gone_out = write(carries);
        if (!gone_out || went_out(carries))
            return gone_out;
        const bool taken_back = write(false);
        went_out(false);
        return taken_back;
    }

    /// The guard has stepped in, and nothing was written since that is meant to carry no force. Any thread.
    bool let_go() const noexcept { return let_go_.load(std::memory_order_acquire); }
    /// Nobody guards any more. Any thread.
    bool unguarded() const noexcept { return unguarded_.load(std::memory_order_acquire); }

    /// The force is off, and nothing is written any more.
    void dismiss() noexcept { guard_->dismiss(); }

private:
    /// Before a message that is meant to carry a force or not. False: it must carry none.
    bool may_go_out(bool pulls) noexcept;
    /// After it; false: the guard has stepped in meanwhile, and its force must be taken back.
    bool went_out(bool pulls) noexcept;
    bool hears(ForceGuard::Word word) noexcept;

    std::unique_ptr<ForceGuard> guard_;
    std::atomic<bool> let_go_{false};
    std::atomic<bool> unguarded_{false};
};

} // namespace tp
