// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/simulated/report_cable.hpp"
#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "device/touch_output/steam_pad/steam_transport.hpp"

#include <cstdint>

namespace tp {

/// And a share, 0 … 1, of the reports to the pads that is not taken, which is told.
struct SteamLinkTroubles : CableTroubles {
    double refuse = 0.0;
};

/// A cable or radio to model pads, in simulated time. The model must outlive it.
class SimulatedSteamLink final : public SteamTransport {
public:
    /// `delay_ms` is how many milliseconds a report takes each way.
    explicit SimulatedSteamLink(ModelSteamPad& pads, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : pads_(pads), cable_(delay_ms, seed) {}

    /// A millisecond of the pads.
    void advance();
    steam::Kind kind() const override { return pads_.kind(); }
    /// A wait passes in simulated time too.
    Got read(Input& report, int wait_ms) noexcept override;
    bool send(const steam::Feature& report) noexcept override;
    unsigned long sends() const { return sends_; } ///< calls of send

    SteamLinkTroubles troubles;

private:
    ModelSteamPad& pads_;
    ReportCable cable_;
    unsigned long sends_ = 0;
};

} // namespace tp
