// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "core/servo/fault.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace tp {

/// A value that one thread writes and any thread reads, without a lock and never torn: a sequence lock over
/// atomic words. Each word is stored with release and loaded with acquire, so that a reader who meets a word
/// of a newer write also meets that write's odd turn.
template <typename T>
class Published {
    static_assert(std::is_trivially_copyable_v<T>);
    static constexpr std::size_t word_count = (sizeof(T) + 7) / 8;

public:
    /// Only the writing thread; waits for nobody.
    void publish(const T& value) noexcept {
        std::array<std::uint64_t, word_count> raw{};
        std::memcpy(raw.data(), &value, sizeof(T));
        const std::uint64_t turn = turn_.load(std::memory_order_relaxed);
        turn_.store(turn + 1, std::memory_order_relaxed);
        for (std::size_t i = 0; i < word_count; ++i)
            words_[i].store(raw[i], std::memory_order_release);
        turn_.store(turn + 2, std::memory_order_release);
    }

    /// Any thread; repeats while a write is under way.
    T latest() const noexcept {
        std::array<std::uint64_t, word_count> raw{};
        std::uint64_t before = 0;
        std::uint64_t after = 0;
        do {
            before = turn_.load(std::memory_order_acquire);
            for (std::size_t i = 0; i < word_count; ++i)
                raw[i] = words_[i].load(std::memory_order_acquire);
            after = turn_.load(std::memory_order_acquire);
        } while (before != after || (before & 1u) != 0);
        T value;
        std::memcpy(static_cast<void*>(&value), raw.data(), sizeof(T));
        return value;
    }

private:
    std::atomic<std::uint64_t> turn_{0};
    std::array<std::atomic<std::uint64_t>, word_count> words_{};
};

/// What the servo knows of itself, for a page or a test that polls.
struct ServoSnapshot {
    double time = 0.0;                       ///< s, servo's clock
    double x = 0.0, y = 0.0;                 ///< mm, finger, surface frame
    double fx = 0.0, fy = 0.0;               ///< N, force delivered, surface frame
    double distance = 0.0;                   ///< mm, to the nearest contour; see FarLook; infinity for none
    double nearest_x = 0.0, nearest_y = 0.0; ///< mm, surface frame
    double gain = 0.0;                       ///< 0 … 1
    double tour_progress = 0.0;              ///< 0 … 1
    double worst_lateness = 0.0;             ///< s, since the start
    std::uint64_t ticks = 0;
    std::uint64_t scene = 0;   ///< number of the scene that is rendered; 0: none
    std::int32_t contour = -1; ///< index into that scene, -1 for none
    Fault fault = Fault::none;
    std::uint32_t buttons = 0;
    bool engaged = false;
    bool touring = false;
    bool tour_finished = false;

    Vec2 finger() const { return {x, y}; }
    Vec2 force() const { return {fx, fy}; }
};

} // namespace tp
