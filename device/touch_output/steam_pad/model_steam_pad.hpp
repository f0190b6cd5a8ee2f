// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "device/touch_output/steam_pad/steam_reports.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// A controller with Steam pads without hardware: reports in, reports out, two thumbs between. What lies where in its reports is
/// written down by hand, so that it does not share the mistakes of steam_reports. One step is a millisecond.
class ModelSteamPad {
public:
    explicit ModelSteamPad(steam::Kind kind) : kind_(kind) {}

    /// A feature report of 65 bytes, its number in front. False: refused.
    bool receive(std::span<const std::uint8_t> report);
    void step();
    /// The next input report of 64 bytes; false when all is said. Every 4 ms it tells how it is.
    bool report(std::vector<std::uint8_t>& bytes);

    steam::Kind kind() const { return kind_; }
    /// mm, x right, y up as it is held.
    void touch(steam::Side side, Vec2 place, bool pressed = false);
    void lift(steam::Side side) { thumbs_[static_cast<std::size_t>(side)].there = false; }
    /// The stick at the left, −1 … 1, which shares its bytes with the left pad of the 2015 controller.
    void push_stick(Vec2 way) { stick_ = way; }
    /// Of a receiver: its controller is switched on or off.
    void switch_on(bool on);
    bool on() const { return on_; }

    /// How strongly the pad swings in this millisecond, 0 … 1.
    double felt(steam::Side side) const;
    bool imitates() const { return mouse_ || keys_; } ///< a mouse or keys
    unsigned long ticks() const { return ticks_; }    ///< that it was told to play
    /// ms, of all pulses it was told to play.
    double longest_ms() const { return longest_ms_; }

    double imitates_again_after_ms = 3000.0; ///< since it was last told not to; a 2015 controller never does

private:
    struct Thumb {
        bool there = false;
        bool pressed = false;
        Vec2 place{0.0};
    };
    struct Playing {
        double left_us = 0.0;
        double strength = 0.0;
    };
    void play(std::span<const std::uint8_t> command);
    std::vector<std::uint8_t> state();

    steam::Kind kind_;
    std::array<Thumb, 2> thumbs_;
    std::array<Playing, 2> playing_;
    Vec2 stick_{0.0};
    bool on_ = true;
    bool mouse_ = true;
    bool keys_ = true;
    double untold_ms_ = 0.0;
    unsigned long ticks_ = 0;
    double longest_ms_ = 0.0;
    unsigned now_ms_ = 0;
    std::uint32_t sequence_ = 0;
    std::vector<std::vector<std::uint8_t>> unsaid_;
};

} // namespace tp
