// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/servo/force_device.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// What passed between the servo and a device in one tick.
struct RecordedTick {
    double now = 0.0;    ///< s, servo's clock
    bool fresh = false;  ///< the device gave `reading` in this tick; whether it is newer, its stamp says
    DeviceState reading; ///< of this tick; as made where there was none
    bool lost = false;
    bool motors_off = false;
    bool refused = false; ///< the device did not take the force
    Vec2 force{0.0};      ///< N, sent
};

/// A session as FORMAT.md has it.
struct TouchRecording {
    Capabilities device;
    std::vector<RecordedTick> ticks;
    std::size_t bytes_left = 0; ///< at the end, which are no whole tick
};

inline constexpr std::size_t tick_size = 64;

/// The header's bytes.
std::string recording_header(const Capabilities& device);
std::array<char, tick_size> recorded_bytes(const RecordedTick& tick, std::uint32_t number);

/// Any bytes. An error where the header is not one.
Result<TouchRecording> parse_recording(std::string_view bytes);

} // namespace tp
