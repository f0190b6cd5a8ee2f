// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/protocol/frame.hpp"

namespace tp::pad {

namespace {

constexpr size_t crc_at = frame_size - 2;

/// Fills a frame field by field; the rest stays zero.
class Writer {
public:
    Writer(FrameType type, uint16_t sequence) : frame_{} {
        u8(static_cast<uint8_t>(type));
        u8(protocol_version);
        u16(sequence);
    }
    void u8(uint8_t value) { frame_.bytes[at_++] = value; }
    void u16(uint16_t value) {
        u8(static_cast<uint8_t>(value & 0xFFu));
        u8(static_cast<uint8_t>(value >> 8));
    }
    void i16(int16_t value) { u16(static_cast<uint16_t>(value)); }
    void u32(uint32_t value) {
        u16(static_cast<uint16_t>(value & 0xFFFFu));
        u16(static_cast<uint16_t>(value >> 16));
    }
    void i32(int32_t value) { u32(static_cast<uint32_t>(value)); }
    Frame done() {
        at_ = crc_at;
        u16(crc16(frame_.bytes, crc_at));
        return frame_;
    }

private:
    Frame frame_;
    size_t at_ = 0;
};

/// Reads the fields of a frame in the same order.
class Reader {
public:
    Reader(const Frame& frame, FrameType type) : frame_(frame) {
        const bool typed = u8() == static_cast<uint8_t>(type);
        const bool known = u8() == protocol_version;
        at_ = crc_at;
        const bool whole = u16() == crc16(frame_.bytes, crc_at);
        at_ = 2;
        good_ = typed && known && whole;
    }
    bool good() const { return good_; }
    uint8_t u8() { return frame_.bytes[at_++]; }
    uint16_t u16() {
        const uint8_t low = u8();
        return static_cast<uint16_t>(low | (u8() << 8));
    }
    int16_t i16() { return static_cast<int16_t>(u16()); }
    uint32_t u32() {
        const uint32_t low = u16();
        return low | (static_cast<uint32_t>(u16()) << 16);
    }
    int32_t i32() { return static_cast<int32_t>(u32()); }
    /// What was not read is reserved and must be zero.
    bool rest_is_zero() {
        while (at_ < crc_at)
            if (u8() != 0)
                return false;
        return true;
    }

private:
    const Frame& frame_;
    size_t at_ = 0;
    bool good_;
};

bool is_answer(FrameType type) {
    return type == FrameType::state || type == FrameType::capabilities || type == FrameType::outline ||
           type == FrameType::identity || type == FrameType::calibration;
}

} // namespace

uint16_t crc16(const uint8_t* bytes, size_t count) {
    uint32_t crc = 0xFFFF;
    for (size_t i = 0; i < count; ++i) {
        crc ^= static_cast<uint32_t>(bytes[i]) << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 0x8000u) != 0 ? (crc << 1) ^ 0x1021u : crc << 1;
    }
    return static_cast<uint16_t>(crc);
}

Frame encode(const ForceFrame& value) {
    Writer out(FrameType::force, value.sequence);
    out.i16(value.x_mn);
    out.i16(value.y_mn);
    out.u8(value.motors ? 1 : 0);
    return out.done();
}

bool decode(const Frame& frame, ForceFrame& value) {
    Reader in(frame, FrameType::force);
    ForceFrame read;
    read.sequence = in.u16();
    read.x_mn = in.i16();
    read.y_mn = in.i16();
    const uint8_t motors = in.u8();
    read.motors = motors == 1;
    if (!in.good() || motors > 1 || !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

Frame encode(const AskFrame& value) {
    Writer out(FrameType::ask, value.sequence);
    out.u8(static_cast<uint8_t>(value.what));
    out.u8(value.page);
    return out.done();
}

bool decode(const Frame& frame, AskFrame& value) {
    Reader in(frame, FrameType::ask);
    AskFrame read;
    read.sequence = in.u16();
    read.what = static_cast<FrameType>(in.u8());
    read.page = in.u8();
    if (!in.good() || !is_answer(read.what) || !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

Frame encode(const CalibrateFrame& value) {
    Writer out(FrameType::calibrate, value.sequence);
    out.u8(static_cast<uint8_t>(value.action));
    out.u8(value.motor);
    out.u16(value.permille);
    return out.done();
}

bool decode(const Frame& frame, CalibrateFrame& value) {
    Reader in(frame, FrameType::calibrate);
    CalibrateFrame read;
    read.sequence = in.u16();
    read.action = static_cast<CalibrateAction>(in.u8());
    read.motor = in.u8();
    read.permille = in.u16();
    const bool known = read.action == CalibrateAction::home || read.action == CalibrateAction::scale;
    if (!in.good() || !known || read.motor > 3 || read.permille < 500 || read.permille > 1500 ||
        !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

Frame encode(const StateFrame& value) {
    Writer out(FrameType::state, value.sequence);
    out.u32(value.time_us);
    out.i32(value.x_um);
    out.i32(value.y_um);
    out.i16(value.force_x_mn);
    out.i16(value.force_y_mn);
    out.u16(value.residual_um);
    out.u16(value.status);
    out.u16(value.heard);
    out.u8(static_cast<uint8_t>(value.celsius));
    out.u8(value.buttons);
    return out.done();
}

bool decode(const Frame& frame, StateFrame& value) {
    Reader in(frame, FrameType::state);
    StateFrame read;
    read.sequence = in.u16();
    read.time_us = in.u32();
    read.x_um = in.i32();
    read.y_um = in.i32();
    read.force_x_mn = in.i16();
    read.force_y_mn = in.i16();
    read.residual_um = in.u16();
    read.status = in.u16();
    read.heard = in.u16();
    read.celsius = static_cast<int8_t>(in.u8());
    read.buttons = in.u8();
    if (!in.good() || (read.status & ~status::all) != 0 || !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

Frame encode(const CapabilitiesFrame& value) {
    Writer out(FrameType::capabilities, value.sequence);
    out.u8(static_cast<uint8_t>(value.kind));
    out.u8(value.firmware_major);
    out.u8(value.firmware_minor);
    out.u8(value.corners);
    out.u16(value.max_force_mn);
    out.u16(value.continuous_force_mn);
    out.u16(value.resolution_um);
    out.u16(value.rate_hz);
    out.u16(value.delay_us);
    out.u8(value.watchdog_ms);
    return out.done();
}

bool decode(const Frame& frame, CapabilitiesFrame& value) {
    Reader in(frame, FrameType::capabilities);
    CapabilitiesFrame read;
    read.sequence = in.u16();
    read.kind = static_cast<PadKind>(in.u8());
    read.firmware_major = in.u8();
    read.firmware_minor = in.u8();
    read.corners = in.u8();
    read.max_force_mn = in.u16();
    read.continuous_force_mn = in.u16();
    read.resolution_um = in.u16();
    read.rate_hz = in.u16();
    read.delay_us = in.u16();
    read.watchdog_ms = in.u8();
    const bool known = read.kind == PadKind::cables || read.kind == PadKind::pantograph;
    if (!in.good() || !known || !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

Frame encode(const OutlineFrame& value) {
    Writer out(FrameType::outline, value.sequence);
    out.u8(value.page);
    out.u8(value.corners);
    for (uint8_t i = 0; i < corners_per_page; ++i) {
        out.i32(i < value.corners ? value.x_um[i] : 0);
        out.i32(i < value.corners ? value.y_um[i] : 0);
    }
    return out.done();
}

bool decode(const Frame& frame, OutlineFrame& value) {
    Reader in(frame, FrameType::outline);
    OutlineFrame read;
    read.sequence = in.u16();
    read.page = in.u8();
    read.corners = in.u8();
    bool good = in.good() && read.corners <= corners_per_page;
    for (uint8_t i = 0; i < corners_per_page; ++i) {
        read.x_um[i] = in.i32();
        read.y_um[i] = in.i32();
        good = good && (i < read.corners || (read.x_um[i] == 0 && read.y_um[i] == 0));
    }
    if (!good)
        return false;
    value = read;
    return true;
}

Frame encode(const IdentityFrame& value) {
    Writer out(FrameType::identity, value.sequence);
    for (size_t i = 0; i < serial_size && value.serial[i] != 0; ++i)
        out.u8(static_cast<uint8_t>(value.serial[i]));
    return out.done();
}

bool decode(const Frame& frame, IdentityFrame& value) {
    Reader in(frame, FrameType::identity);
    IdentityFrame read;
    read.sequence = in.u16();
    bool ended = false;
    bool good = in.good();
    for (size_t i = 0; i < serial_size; ++i) {
        const uint8_t letter = in.u8();
        good = good && (letter == 0 || (!ended && letter > 0x20 && letter < 0x7F));
        ended = ended || letter == 0;
        read.serial[i] = static_cast<char>(letter);
    }
    if (!good || !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

Frame encode(const CalibrationFrame& value) {
    Writer out(FrameType::calibration, value.sequence);
    out.u8(value.homed ? 1 : 0);
    for (const uint16_t permille : value.permille)
        out.u16(permille);
    return out.done();
}

bool decode(const Frame& frame, CalibrationFrame& value) {
    Reader in(frame, FrameType::calibration);
    CalibrationFrame read;
    read.sequence = in.u16();
    const uint8_t homed = in.u8();
    read.homed = homed == 1;
    for (uint16_t& permille : read.permille)
        permille = in.u16();
    if (!in.good() || homed > 1 || !in.rest_is_zero())
        return false;
    value = read;
    return true;
}

} // namespace tp::pad
