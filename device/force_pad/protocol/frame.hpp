// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stddef.h>
#include <stdint.h>

/// The frames between a computer and a force pad, byte for byte as ../PROTOCOL.md has them. Pure functions
/// that run on both ends: no allocation, no exception, no library beneath.
///
/// `encode` takes any value of its fields. `decode` is strict: type, version, CRC, reserved bytes and every
/// enumerator must be right, or it is false and leaves the value alone; what it takes, `encode` gives back
/// byte for byte.
namespace tp::pad {

inline constexpr size_t frame_size = 32;
inline constexpr uint8_t protocol_version = 1;

struct Frame {
    uint8_t bytes[frame_size];
};

enum class FrameType : uint8_t {
    force = 0x01,
    ask = 0x02,
    calibrate = 0x03,
    state = 0x81,
    capabilities = 0x82,
    outline = 0x83,
    identity = 0x84,
    calibration = 0x85,
};

/// What a pad is made of.
enum class PadKind : uint8_t { cables = 1, pantograph = 2 };

/// Bits of StateFrame::status.
namespace status {
inline constexpr uint16_t armed = 1u << 0;        ///< the motors obey force frames
inline constexpr uint16_t not_homed = 1u << 1;    ///< it does not know where its knob is: calibrate
inline constexpr uint16_t watchdog = 1u << 2;     ///< no force frame came in time
inline constexpr uint16_t hot = 1u << 3;          ///< a motor is too hot
inline constexpr uint16_t over_current = 1u << 4; ///< a motor took more current than it may
inline constexpr uint16_t unsure = 1u << 5;       ///< the encoders contradict each other
inline constexpr uint16_t singular = 1u << 6;     ///< no force can be made in this pose
inline constexpr uint16_t limited = 1u << 7;      ///< less than the force asked for is made
inline constexpr uint16_t outside = 1u << 8;      ///< the knob is outside the outline
inline constexpr uint16_t bad_frame = 1u << 9;    ///< a frame since the last state was not understood
inline constexpr uint16_t all = (1u << 10) - 1;
} // namespace status

/// Computer → pad, every tick.
struct ForceFrame {
    uint16_t sequence = 0;
    int16_t x_mn = 0; ///< mN, pad's frame
    int16_t y_mn = 0;
    bool motors = false; ///< false: motors off at once
};

/// Computer → pad: send one frame of this type. `page` counts the frames of an outline.
struct AskFrame {
    uint16_t sequence = 0;
    FrameType what = FrameType::capabilities;
    uint8_t page = 0;
};

enum class CalibrateAction : uint8_t {
    home = 1,  ///< the knob stands on its mark
    scale = 2, ///< `permille` is what `motor`'s torque is multiplied by
};

/// Computer → pad.
struct CalibrateFrame {
    uint16_t sequence = 0;
    CalibrateAction action = CalibrateAction::home;
    uint8_t motor = 0;        ///< 0 … 3
    uint16_t permille = 1000; ///< 500 … 1500
};

/// Pad → computer, once a millisecond without being asked.
struct StateFrame {
    uint16_t sequence = 0;
    uint32_t time_us = 0; ///< the pad's clock, wraps
    int32_t x_um = 0;     ///< µm, pad's frame
    int32_t y_um = 0;
    int16_t force_x_mn = 0; ///< mN, what the motors make
    int16_t force_y_mn = 0;
    uint16_t residual_um = 0; ///< µm, how far the encoders contradict each other
    uint16_t status = 0;
    uint16_t heard = 0;  ///< sequence of the last force frame that counted
    int8_t celsius = 0;  ///< the hottest motor
    uint8_t buttons = 0; ///< bit 0 = the main button
};

struct CapabilitiesFrame {
    uint16_t sequence = 0;
    PadKind kind = PadKind::cables;
    uint8_t firmware_major = 0;
    uint8_t firmware_minor = 0;
    uint8_t corners = 0; ///< of the outline
    uint16_t max_force_mn = 0;
    uint16_t continuous_force_mn = 0;
    uint16_t resolution_um = 0;
    uint16_t rate_hz = 0;
    uint16_t delay_us = 0;
    uint8_t watchdog_ms = 0;
};

inline constexpr uint8_t corners_per_page = 3;

/// A piece of the polygon that the knob reaches.
struct OutlineFrame {
    uint16_t sequence = 0;
    uint8_t page = 0;
    uint8_t corners = 0; ///< in this frame, at most 3; the other places are zero
    int32_t x_um[corners_per_page] = {};
    int32_t y_um[corners_per_page] = {};
};

inline constexpr size_t serial_size = 16;

struct IdentityFrame {
    uint16_t sequence = 0;
    char serial[serial_size + 1] = {}; ///< printable ASCII, without a space
};

struct CalibrationFrame {
    uint16_t sequence = 0;
    bool homed = false;
    uint16_t permille[4] = {1000, 1000, 1000, 1000};
};

/// CRC-16/IBM-3740 (polynomial 0x1021, start 0xFFFF, nothing reflected; "123456789" gives 0x29B1).
uint16_t crc16(const uint8_t* bytes, size_t count);

/// The type that byte 0 claims.
inline FrameType type_of(const Frame& frame) { return static_cast<FrameType>(frame.bytes[0]); }

/// Later in the cycle of 65 536, by less than half of it.
inline bool newer(uint16_t sequence, uint16_t than) {
    const auto ahead = static_cast<uint16_t>(sequence - than);
    return ahead != 0 && ahead < 0x8000;
}

Frame encode(const ForceFrame& value);
Frame encode(const AskFrame& value);
Frame encode(const CalibrateFrame& value);
Frame encode(const StateFrame& value);
Frame encode(const CapabilitiesFrame& value);
Frame encode(const OutlineFrame& value);
Frame encode(const IdentityFrame& value);
Frame encode(const CalibrationFrame& value);

bool decode(const Frame& frame, ForceFrame& value);
bool decode(const Frame& frame, AskFrame& value);
bool decode(const Frame& frame, CalibrateFrame& value);
bool decode(const Frame& frame, StateFrame& value);
bool decode(const Frame& frame, CapabilitiesFrame& value);
bool decode(const Frame& frame, OutlineFrame& value);
bool decode(const Frame& frame, IdentityFrame& value);
bool decode(const Frame& frame, CalibrationFrame& value);

} // namespace tp::pad
