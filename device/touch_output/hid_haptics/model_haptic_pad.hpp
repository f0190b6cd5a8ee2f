// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// A touch pad of 100 mm by 60 mm with haptics, without hardware: reports in, reports out, two fingers between. What lies where in
/// its reports is written down by hand and not read from its descriptor. One step is a millisecond.
class ModelHapticPad {
public:
    /// What is said of it: report 1 has two fingers and a button, feature 2 the waveforms of the ordinals 3 … 6 and what they last,
    /// output 3 the trigger, its intensity to 100, how often and how far apart it is played again.
    static std::span<const std::uint8_t> descriptor();
    /// The same without the trigger, as of pads that only tick by themselves.
    static std::vector<std::uint8_t> descriptor_without_trigger();

    /// An output report; its id leads.
    void receive(std::span<const std::uint8_t> report);
    /// The feature report of that id behind its id; empty: refused.
    std::vector<std::uint8_t> feature(std::uint8_t id) const;
    void step();
    /// The next input report, its id in front; false when all is said. Every 8 ms while touched, and once when lifted.
    bool report(std::vector<std::uint8_t>& bytes);

    /// mm, x right, y up, origin in the middle.
    void touch(std::size_t finger, Vec2 place, bool pressed = false);
    void lift(std::size_t finger) { fingers_[finger].there = false; }

    /// How strongly it swings in this millisecond, 0 … 1.
    double felt() const { return left_ms_ > 0 ? strength_ : 0.0; }
    int waveform() const { return waveform_; } ///< the usage of the last one it was told to play; 0: none yet
    unsigned long ticks() const { return ticks_; }

    /// Of the ordinals 3 … 6: press, click, hover, and one that goes on until it is stopped.
    std::array<std::uint16_t, 4> waveforms{0x1006, 0x1003, 0x1008, 0x1004};

private:
    struct Finger {
        bool there = false;
        std::uint8_t contact = 0;
        Vec2 place{0.0};
    };
    std::array<Finger, 2> fingers_;
    std::uint8_t contacts_ = 0;
    bool pressed_ = false;
    bool told_touch_ = false;
    unsigned now_ms_ = 0;
    int left_ms_ = 0;
    double strength_ = 0.0;
    int waveform_ = 0;
    unsigned long ticks_ = 0;
    std::vector<std::vector<std::uint8_t>> unsaid_;
};

} // namespace tp
