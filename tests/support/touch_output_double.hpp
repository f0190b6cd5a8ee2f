// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_output.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>

namespace tp::testing {

/// A touch output that a test reads, with a knob for everything that goes wrong. Keeps what it was told without allocating.
class TouchOutputDouble final : public TouchOutput {
public:
    std::function<std::optional<PadTouch>(double)> pad; ///< its readings; empty: it is no pad
    TouchMeans means = TouchMeans::ticks;
    double rate = 1000.0;
    std::atomic<bool> unplugged{false};
    bool refuses = false;

    std::array<Tick, 4096> ticks{}; ///< the first ones
    std::atomic<std::size_t> tick_count{0};
    double level = 0.0; ///< asked for last
    std::size_t levels = 0;
    std::atomic<int> halts{0};
    int stops = 0;

    TouchCapabilities capabilities() const {
        TouchCapabilities can;
        can.name = "double";
        can.means = means;
        can.rate = rate;
        if (pad)
            can.pad = Rect{{-20, -20}, {20, 20}};
        return can;
    }

    Result<TouchCapabilities> open() override { return capabilities(); }
    std::optional<PadTouch> read(double now) noexcept override { return pad ? pad(now) : std::nullopt; }
    bool resist(double wanted) noexcept override {
        level = wanted;
        ++levels;
        return !refuses;
    }
    bool tick(const Tick& tick) noexcept override {
        if (tick_count < ticks.size())
            ticks[tick_count] = tick;
        ++tick_count;
        return !refuses;
    }
    void halt() noexcept override {
        level = 0.0;
        ++halts;
    }
    void stop() noexcept override { ++stops; }
    bool lost() const noexcept override { return unplugged; }
};

} // namespace tp::testing
