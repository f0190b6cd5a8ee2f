// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "device/touch_output/steam_pad/steam_transport.hpp"

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace tp {

/// What can go wrong on the way between a computer and the pads. Shares are 0 … 1 of all reports.
struct SteamLinkTroubles {
    double drop = 0.0;   ///< from the pads
    double garble = 0.0; ///< from the pads: some bytes are others
    double cut = 0.0;    ///< from the pads: a shorter report
    double refuse = 0.0; ///< to the pads: not taken, and that is told
    bool mute = false;   ///< nothing comes from the pads
    bool deaf = false;   ///< nothing reaches the pads, and nobody is told
    bool unplugged = false;
};

/// A cable or radio to model pads, in simulated time. The model must outlive it.
class SimulatedSteamLink final : public SteamTransport {
public:
    /// `delay_ms` is how many milliseconds a report takes each way.
    explicit SimulatedSteamLink(ModelSteamPad& pads, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : pads_(pads), delay_ms_(delay_ms), random_(seed) {}

    /// A millisecond of the pads.
    void advance();
    steam::Kind kind() const override { return pads_.kind(); }
    /// A wait passes in simulated time too.
    Got read(Input& report, int wait_ms) noexcept override;
    bool send(const steam::Feature& report) noexcept override;
    unsigned long sends() const { return sends_; } ///< calls of send

    SteamLinkTroubles troubles;

private:
    struct UnderWay {
        std::uint64_t due = 0; ///< ms
        std::vector<std::uint8_t> bytes;
    };
    bool happens(double share);

    ModelSteamPad& pads_;
    unsigned delay_ms_;
    std::mt19937 random_;
    std::uint64_t now_ = 0; ///< ms
    unsigned long sends_ = 0;
    std::deque<UnderWay> to_pads_;
    std::deque<UnderWay> from_pads_;
};

} // namespace tp
