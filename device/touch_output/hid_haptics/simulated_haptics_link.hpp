// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/simulated/report_cable.hpp"
#include "device/touch_output/hid_haptics/haptics_transport.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

/// And a share, 0 … 1, of the reports to the pad that is not taken, which is told.
struct HapticsLinkTroubles : CableTroubles {
    double refuse = 0.0;
    std::vector<std::uint8_t> lie; ///< what the device says of its reports instead of the truth
};

/// A cable to a model pad, in simulated time. The model must outlive it.
class SimulatedHapticsLink final : public HapticsTransport {
public:
    /// `delay_ms` is how many milliseconds a report takes each way.
    explicit SimulatedHapticsLink(ModelHapticPad& pad, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : pad_(pad), cable_(delay_ms, seed) {}

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
    ModelHapticPad& pad_;
    ReportCable cable_;
    unsigned long sends_ = 0;
};

} // namespace tp
