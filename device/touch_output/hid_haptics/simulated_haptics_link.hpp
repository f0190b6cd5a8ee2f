// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/haptics_transport.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace tp {

/// What can go wrong on the way between a computer and the pad. Shares are 0 … 1 of all reports.
struct HapticsLinkTroubles {
    double drop = 0.0;   ///< from the pad
    double garble = 0.0; ///< from the pad: some bytes are others
    double cut = 0.0;    ///< from the pad: a shorter report
    double refuse = 0.0; ///< to the pad: not taken, and that is told
    bool mute = false;   ///< nothing comes from the pad
    bool deaf = false;   ///< nothing reaches the pad, and nobody is told
    bool unplugged = false;
    std::vector<std::uint8_t> lie; ///< what the device says of its reports instead of the truth
};

/// A cable to a model pad, in simulated time. The model must outlive it.
class SimulatedHapticsLink final : public HapticsTransport {
public:
    /// `delay_ms` is how many milliseconds a report takes each way.
    explicit SimulatedHapticsLink(ModelHapticPad& pad, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : pad_(pad), delay_ms_(delay_ms), random_(seed) {}

    /// A millisecond of the pad.
    void advance();
    std::vector<std::uint8_t> descriptor() override;
    std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t bytes) override;
    /// A wait passes in simulated time too.
    Got read(Input& report, int wait_ms) noexcept override;
    bool send(const haptics::Output& report) noexcept override;
    unsigned long sends() const { return sends_; } ///< calls of send

    HapticsLinkTroubles troubles;

private:
    struct UnderWay {
        std::uint64_t due = 0; ///< ms
        std::vector<std::uint8_t> bytes;
    };
    bool happens(double share);

    ModelHapticPad& pad_;
    unsigned delay_ms_;
    std::mt19937 random_;
    std::uint64_t now_ = 0; ///< ms
    unsigned long sends_ = 0;
    std::deque<UnderWay> to_pad_;
    std::deque<UnderWay> from_pad_;
};

} // namespace tp
