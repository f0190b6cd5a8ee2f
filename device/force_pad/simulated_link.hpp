// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/model_pad.hpp"
#include "device/force_pad/report_transport.hpp"

#include <cstdint>
#include <deque>
#include <random>

namespace tp {

/// What can go wrong on the way between a computer and a pad. Shares are 0 … 1 of all frames.
struct LinkTroubles {
    double drop = 0.0;   ///< each way
    double garble = 0.0; ///< each way: some bytes are others
    double odd = 0.0;    ///< from the pad: reports of another length
    bool mute = false;   ///< nothing comes from the pad
    bool repeats = false; ///< its last frame comes from the pad over and over
    bool deaf = false;   ///< nothing reaches the pad
    bool unplugged = false;
};

/// A cable to a model pad, in simulated time, with a delay and knobs for what goes wrong. The pad must
/// outlive it.
class SimulatedLink final : public ReportTransport {
public:
    /// `delay_ms` is how many milliseconds a frame takes each way.
    explicit SimulatedLink(ModelPad& pad, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : pad_(pad), delay_ms_(delay_ms), random_(seed) {}

    /// A millisecond of the pad.
    void advance();
    /// A wait passes in simulated time too.
    Got read(pad::Frame& frame, int wait_ms) noexcept override;
    bool write(const pad::Frame& frame) noexcept override;

    LinkTroubles troubles;

private:
    struct UnderWay {
        std::uint64_t due = 0; ///< ms
        pad::Frame frame;
    };
    bool happens(double share);
    void garble(pad::Frame& frame);

    ModelPad& pad_;
    unsigned delay_ms_;
    std::mt19937 random_;
    std::uint64_t now_ = 0; ///< ms
    std::deque<UnderWay> to_pad_;
    std::deque<UnderWay> from_pad_;
    pad::Frame said_{}; ///< what the pad said last, before it began to repeat itself
};

} // namespace tp
