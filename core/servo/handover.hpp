// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tp {

/// Hands values from one thread to a ticking one, which locks nothing and frees nothing: by an atomic swap. A value is freed
/// by the thread that handed it over, once the other has left it.
template <typename T>
class Handover {
public:
    struct Held {
        std::uint64_t number = 0; ///< 1, 2, 3 …
        std::unique_ptr<const T> value;
    };

    /// In place of the value before; returns its number. nullptr: there is none. Only the thread that hands over.
    std::uint64_t offer(std::unique_ptr<const T> value) {
        auto held = std::make_unique<Held>();
        held->number = ++last_number_;
        held->value = std::move(value);
        offered_.store(held.get(), std::memory_order_release);
        held_.push_back(std::move(held));
        const std::uint64_t needed = oldest_needed_.load(std::memory_order_acquire);
        std::erase_if(held_, [needed](const auto& one) { return one->number < needed; });
        return last_number_;
    }

    /// The newest; null before the first. Those before it are left. Only the ticking thread.
    const Held* take() noexcept {
        const Held* const newest = offered_.load(std::memory_order_acquire);
        if (newest != nullptr)
            oldest_needed_.store(newest->number, std::memory_order_release);
        return newest;
    }

private:
    std::atomic<const Held*> offered_{nullptr};
    std::atomic<std::uint64_t> oldest_needed_{0}; ///< those with a smaller number are no longer looked at
    std::vector<std::unique_ptr<const Held>> held_;
    std::uint64_t last_number_ = 0;
};

} // namespace tp
