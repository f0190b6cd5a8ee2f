// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/giving_back.hpp"

namespace tp {

GivingBack& GivingBack::here() {
    static GivingBack one;
    return one;
}

std::uint64_t GivingBack::begin() {
    const std::lock_guard lock(mutex_);
    under_way_.insert(++begun_);
    return begun_;
}

void GivingBack::ended(std::uint64_t number) {
    {
        const std::lock_guard lock(mutex_);
        under_way_.erase(number);
    }
    ended_.notify_all();
}

std::uint64_t GivingBack::begun() const {
    const std::lock_guard lock(mutex_);
    return begun_;
}

void GivingBack::wait_for(std::uint64_t begun) {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this, begun] { return under_way_.empty() || *under_way_.begin() > begun; });
}

} // namespace tp
