// SPDX-License-Identifier: Apache-2.0
#include "frame_check.hpp"

#include "device/force_pad/firmware/pad_firmware.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace tp::test {

using namespace tp::pad;

namespace {

template <typename Value>
bool survives(const Frame& frame) {
    Value value;
    if (!decode(frame, value))
        return true;
    return std::memcmp(encode(value).bytes, frame.bytes, frame_size) == 0;
}

std::string complaint_about(const Frame& frame) {
    if (!survives<ForceFrame>(frame) || !survives<AskFrame>(frame) || !survives<CalibrateFrame>(frame) ||
        !survives<StateFrame>(frame) || !survives<CapabilitiesFrame>(frame) ||
        !survives<OutlineFrame>(frame) || !survives<IdentityFrame>(frame) ||
        !survives<CalibrationFrame>(frame))
        return "a frame that is taken is not given back as it came";
    return {};
}

std::string complaint_about(const PadConfig& config, const Drive& drive) {
    const auto most = static_cast<std::int32_t>(1000.0f * config.greatest_torque + 1.0f);
    for (const std::int32_t torque : drive.torque_unm)
        if (std::abs(torque) > most)
            return "a motor is asked for more torque than it has";
    return {};
}

} // namespace

std::string complaint_about_frames(std::string_view bytes) {
    for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
        PadFirmware pad(config);
        Sensors sensors;
        pad.step(sensors);
        pad.receive(encode(CalibrateFrame{}));
        for (std::size_t at = 0; at + frame_size <= bytes.size(); at += frame_size) {
            Frame raw;
            std::memcpy(raw.bytes, bytes.data() + at, frame_size);
            Frame mended = raw;
            mended.bytes[1] = protocol_version;
            const std::uint16_t crc = crc16(mended.bytes, frame_size - 2);
            mended.bytes[frame_size - 2] = static_cast<std::uint8_t>(crc & 0xFFu);
            mended.bytes[frame_size - 1] = static_cast<std::uint8_t>(crc >> 8);
            for (const Frame& frame : {raw, mended}) {
                if (std::string words = complaint_about(frame); !words.empty())
                    return words;
                pad.receive(frame);
                // The same bytes as what the encoders and the clock say.
                sensors.time_us += frame.bytes[4];
                for (int i = 0; i < most_motors; ++i)
                    sensors.counts[i] += static_cast<std::int8_t>(frame.bytes[5 + i]) * (frame.bytes[9] + 1);
                sensors.celsius = static_cast<std::int8_t>(frame.bytes[10]);
                if (std::string words = complaint_about(config, pad.step(sensors)); !words.empty())
                    return words;
                Frame answer;
                while (pad.answer(answer))
                    if (std::string words = complaint_about(answer); !words.empty())
                        return words;
                StateFrame state;
                if (!decode(pad.state(), state))
                    return "the pad sends a state that is none";
                const double force = std::hypot(state.force_x_mn, state.force_y_mn);
                if (force > 1000.0 * static_cast<double>(config.max_force) + 2.0)
                    return "the pad pulls harder than its limit";
            }
        }
    }
    return {};
}

} // namespace tp::test
