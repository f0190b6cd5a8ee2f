// SPDX-License-Identifier: Apache-2.0
#include "device/guard/guarded_pull.hpp"

namespace tp {

bool GuardedPull::hears(ForceGuard::Word word) noexcept {
    if (word == ForceGuard::Word::gone)
        unguarded_.store(true, std::memory_order_release);
    if (word != ForceGuard::Word::here)
        let_go_.store(true, std::memory_order_release);
    return word == ForceGuard::Word::here;
}

bool GuardedPull::may_go_out(bool pulls) noexcept {
    if (!pulls)
        let_go_.store(false, std::memory_order_release);
    return !pulls || (!let_go() && hears(guard_->beat(true)));
}

bool GuardedPull::went_out(bool pulls) noexcept { return hears(guard_->beat(pulls)) || !pulls; }

} // namespace tp
