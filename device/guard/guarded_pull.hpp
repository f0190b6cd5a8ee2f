// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/guard/force_guard.hpp"

#include <atomic>
#include <memory>
#include <utility>

namespace tp {

/// The writer's side of a guard that may step in: asked before and after each message, it says whether the
/// message may carry a force. Once the guard has stepped in none may, until one was meant to carry none.
class GuardedPull {
public:
    explicit GuardedPull(std::unique_ptr<ForceGuard> guard) : guard_(std::move(guard)) {}

    /// Before a message that is meant to carry a force or not. False: it must carry none. The writer.
    bool may_go_out(bool pulls) noexcept;
    /// After it; false: the guard has stepped in meanwhile, and its force must be taken back. The writer.
    bool went_out(bool pulls) noexcept;

    /// The guard has stepped in, and nothing was written since that is meant to carry no force. Any thread.
    bool let_go() const noexcept { return let_go_.load(std::memory_order_acquire); }
    /// Nobody guards any more. Any thread.
    bool unguarded() const noexcept { return unguarded_.load(std::memory_order_acquire); }

    /// The force is off, and nothing is written any more.
    void dismiss() noexcept { guard_->dismiss(); }

private:
    bool hears(ForceGuard::Word word) noexcept;

    std::unique_ptr<ForceGuard> guard_;
    std::atomic<bool> let_go_{false};
    std::atomic<bool> unguarded_{false};
};

} // namespace tp
